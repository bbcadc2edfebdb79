#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <string>

namespace raytree::cli {

/// A bar on standard error for work that takes over half a second, where that is a terminal. It is
/// wiped away in the end.
class Progress {
  public:
    explicit Progress(std::string task);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Takes the share done so far, 0 to 1, from any thread; always true, to go on. Empty where
    /// there is nobody to see it.
    std::function<bool(double)> callback();

  private:
    using Clock = std::chrono::steady_clock;

    void draw(double share);

    std::string task_;
    bool terminal_;
    Clock::time_point next_;  ///< when it is drawn again
    std::mutex mutex_;        ///< of everything that draw touches
    bool drawn_ = false;
};

}  // namespace raytree::cli
