#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>

namespace raytree::inspector {

/// The window goes first: while it answers or draws, work that nobody waits for, such as the
/// picture, stands still, for software OpenGL wants every core.
class RightOfWay {
  public:
    /// Beside a window that does not rest, the others wait for this long and no longer.
    explicit RightOfWay(std::chrono::milliseconds longest = std::chrono::milliseconds(250))
        : longest_(longest) {}

    /// The window begins to answer, or has come to rest; both may be told again.
    void take();
    void leave();

    /// For threads of such work, between two small pieces of it: returns once the window rests.
    void give() const;

  private:
    std::chrono::milliseconds longest_;
    mutable std::mutex mutex_;
    mutable std::condition_variable rests_;
    std::atomic<bool> taken_{false};
    std::atomic<std::chrono::steady_clock::time_point> since_{};
};

}  // namespace raytree::inspector
