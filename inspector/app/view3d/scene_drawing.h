#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <optional>
#include <thread>

#include "state/right_of_way.h"
#include "view3d/scene3d.h"

namespace raytree::inspector {

struct DrawnFrame {
    FrameImage image;
    int number = 0;       ///< of what was asked for
    bool rough = false;   ///< another one follows, with all shapes as they are
    bool keeps = false;   ///< no more than rays was drawn over shapes that had stood still
    bool failed = false;  ///< there was too little memory: there is no image
};

/// Draws the 3D view in a thread of its own: software takes longer than a window may stand still.
class SceneDrawing {
  public:
    /// `drawn` is called in that thread whenever there is a frame to `take`.
    SceneDrawing(std::shared_ptr<RightOfWay> way, std::function<void()> drawn);
    ~SceneDrawing();

    /// Draws this next, whatever was asked for before, and later what is still to be seen of it;
    /// returns its number, which goes up.
    int draw(SceneFrame frame);
    /// The next of the frames that have been drawn, each once.
    std::optional<DrawnFrame> take();
    /// The same, waiting for one.
    DrawnFrame wait();
    /// Beside what is shown: drawn as a whole. It throws what drawing throws.
    std::future<FrameImage> draw_image(SceneFrame frame);

  private:
    using Clock = std::chrono::steady_clock;
    using Lock = std::unique_lock<std::mutex>;
    struct Image {
        SceneFrame frame;
        std::promise<FrameImage> promise;
    };
    /// What is left to do about the frame that is shown, once nothing else is asked for.
    enum class Rest { none, settle, draw_more };

    void run();
    void draw_next(Scene3d& scene, Lock& lock);
    void draw_rest(Scene3d& scene, Lock& lock);
    void finish(Scene3d& scene, Lock& lock);
    void give_up(Lock& lock);
    void hand_over(DrawnFrame frame, Lock& lock);

    std::shared_ptr<RightOfWay> way_;  ///< over other work, as long as it draws
    std::function<void()> drawn_;
    std::mutex mutex_;
    std::condition_variable asked_, answered_;
    std::optional<SceneFrame> frame_;  ///< guarded by mutex_, as all that is asked and answered
    std::optional<Image> image_;
    std::deque<DrawnFrame> frames_;
    int number_ = 0;
    bool ending_ = false;
    int shown_ = 0;  ///< the number of what is drawn; of the thread alone, as below
    Rest rest_ = Rest::none;
    Clock::time_point settled_;
    std::thread thread_;
};

}  // namespace raytree::inspector
