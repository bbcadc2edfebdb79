#include "state/right_of_way.h"

namespace raytree::inspector {

void RightOfWay::take(Who who) {
    if (!(taken_ & who)) {
        const std::lock_guard lock(mutex_);
        if (!taken_) {
            since_ = std::chrono::steady_clock::now();
        }
        taken_ |= who;
    }
}

void RightOfWay::leave(Who who) {
    if (taken_ & who) {
        {
            const std::lock_guard lock(mutex_);
            taken_ &= ~who;
        }
        rests_.notify_all();
    }
}

void RightOfWay::give() const {
    if (!taken_) {
        return;
    }
    const auto until = since_.load() + longest_;
    if (std::chrono::steady_clock::now() < until) {
        std::unique_lock lock(mutex_);
        rests_.wait_until(lock, until, [this] { return !taken_; });
    }
}

}  // namespace raytree::inspector
