#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>

namespace raytree::inspector {

/// The window goes first: while it answers or its 3D view is drawn, work that nobody waits for,
/// such as the picture, stands still, for software OpenGL wants every core.
class RightOfWay {
  public:
    enum Who : unsigned { window = 1, drawing = 2 };

    /// Beside a window that does not rest, the others wait for this long and no longer.
    explicit RightOfWay(std::chrono::milliseconds longest = std::chrono::milliseconds(250))
        : longest_(longest) {}

    /// The window begins to answer, or its view to be drawn, or it has come to rest; both may be
    /// told again.
    void take(Who who = window);
    void leave(Who who = window);

    /// For threads of such work, between two small pieces of it: returns once both rest.
    void give() const;

  private:
    std::chrono::milliseconds longest_;
    mutable std::mutex mutex_;
    mutable std::condition_variable rests_;
    std::atomic<unsigned> taken_{0};  ///< by whom
    std::atomic<std::chrono::steady_clock::time_point> since_{};
};

}  // namespace raytree::inspector
