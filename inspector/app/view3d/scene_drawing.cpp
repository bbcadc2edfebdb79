#include "view3d/scene_drawing.h"

#include <new>
#include <utility>

namespace raytree::inspector {
namespace {

using namespace std::chrono_literals;
constexpr auto settle_time = 250ms;  // without another view or shape: while a hand turns or slides
constexpr auto glance = 12ms;        // between looks at what is asked for

}  // namespace

SceneDrawing::SceneDrawing(std::shared_ptr<RightOfWay> way, std::function<void()> drawn)
    : way_(std::move(way)), drawn_(std::move(drawn)), thread_([this] { run(); }) {}

SceneDrawing::~SceneDrawing() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    asked_.notify_one();
    thread_.join();
}

int SceneDrawing::draw(SceneFrame frame) {
    const std::lock_guard lock(mutex_);
    frame_ = std::move(frame);
    asked_.notify_one();
    return ++number_;
}

std::optional<DrawnFrame> SceneDrawing::take() {
    const std::lock_guard lock(mutex_);
    if (frames_.empty()) {
        return std::nullopt;
    }
    DrawnFrame next = std::move(frames_.front());
    frames_.pop_front();
    return next;
}

DrawnFrame SceneDrawing::wait() {
    Lock lock(mutex_);
    answered_.wait(lock, [this] { return !frames_.empty(); });
    DrawnFrame next = std::move(frames_.front());
    frames_.pop_front();
    return next;
}

std::future<FrameImage> SceneDrawing::draw_image(SceneFrame frame) {
    const std::lock_guard lock(mutex_);
    frame.whole = true;
    image_.emplace(Image{std::move(frame), {}});
    asked_.notify_one();
    return image_->promise.get_future();
}

void SceneDrawing::run() {
    Scene3d scene;  // here: OpenGL's context is this thread's
    Lock lock(mutex_);
    while (true) {
        const auto is_asked = [this] { return frame_ || image_ || ending_; };
        if (rest_ != Rest::draw_more && !is_asked()) {
            way_->leave(RightOfWay::drawing);
        }
        if (rest_ == Rest::none) {
            asked_.wait(lock, is_asked);
        } else if (rest_ == Rest::settle) {
            asked_.wait_until(lock, settled_, is_asked);
        }
        if (ending_) {
            return;
        }
        way_->take(RightOfWay::drawing);
        try {
            is_asked() ? draw_next(scene, lock) : draw_rest(scene, lock);
        } catch (const std::bad_alloc&) {
            give_up(lock);
        }
    }
}

void SceneDrawing::draw_next(Scene3d& scene, Lock& lock) {
    if (image_) {
        Image image = std::move(*image_);
        image_.reset();
        lock.unlock();
        try {
            scene.show(image.frame);
            scene.render();
            image.promise.set_value(scene.image());
        } catch (const std::bad_alloc&) {
            image.promise.set_exception(std::current_exception());
        }
        rest_ = Rest::none;  // the window asks for its frame again
        lock.lock();
        return;
    }
    const SceneFrame frame = std::move(*frame_);
    frame_.reset();
    shown_ = number_;
    lock.unlock();
    const bool other = scene.show(frame);
    scene.render();
    if (other || (rest_ == Rest::none && !scene.is_keeping())) {
        settled_ = Clock::now() + settle_time;
        rest_ = Rest::settle;
    }
    finish(scene, lock);
}

/// Many shapes are shown as they are when all are drawn, and no sooner.
void SceneDrawing::draw_rest(Scene3d& scene, Lock& lock) {
    lock.unlock();
    if (rest_ == Rest::settle) {
        scene.keep();
        rest_ = scene.is_rough() ? Rest::draw_more : Rest::none;
    } else if (scene.draw_more(glance)) {
        rest_ = Rest::none;
    }
    if (rest_ == Rest::none) {
        scene.render();
        finish(scene, lock);
    } else {
        lock.lock();
    }
}

/// Hands over the frame that has been rendered.
void SceneDrawing::finish(Scene3d& scene, Lock& lock) {
    hand_over({scene.image(), shown_, scene.is_rough(), scene.keeps()}, lock);
}

/// What was drawn last stays, and the next frame may need less.
void SceneDrawing::give_up(Lock& lock) {
    rest_ = Rest::none;
    if (lock.owns_lock()) {
        lock.unlock();
    }
    DrawnFrame none;
    none.number = shown_;
    none.failed = true;
    hand_over(std::move(none), lock);
}

void SceneDrawing::hand_over(DrawnFrame frame, Lock& lock) {
    lock.lock();
    frames_.push_back(std::move(frame));
    answered_.notify_one();
    drawn_();
}

}  // namespace raytree::inspector
