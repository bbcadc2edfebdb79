#pragma once

#include <exception>
#include <functional>
#include <string_view>

namespace raytree {

/// Work was ended before it was done, as somebody had asked for.
struct Stopped : std::exception {
    const char* what() const noexcept override { return "stopped"; }
};

/// Hears how far long work of this thread has come, as long as it lives: what is being done, and
/// which share of that is done, 0 to 1. It is called often, and may throw Stopped to end the work.
class ProgressListener {
  public:
    using Hear = std::function<void(std::string_view doing, double share)>;

    explicit ProgressListener(Hear hear);
    ~ProgressListener();
    ProgressListener(const ProgressListener&) = delete;
    ProgressListener& operator=(const ProgressListener&) = delete;

  private:
    Hear hear_;
    ProgressListener* outer_;

    friend void tell_progress(std::string_view doing, double share);
};

/// Tells the thread's listener, if there is one.
void tell_progress(std::string_view doing, double share);

/// Tells, of `all` pieces that are gone through one by one, every few thousandth.
class ProgressCounter {
  public:
    explicit ProgressCounter(std::string_view doing) : doing_(doing) {}
    void at(std::size_t done, std::size_t all) {
        constexpr unsigned seldom = 4096;
        if (++calls_ % seldom == 1) {
            tell_progress(doing_, static_cast<double>(done) / static_cast<double>(all));
        }
    }

  private:
    std::string_view doing_;
    unsigned calls_ = 0;
};

}  // namespace raytree
