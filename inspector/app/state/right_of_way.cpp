#include "state/right_of_way.h"

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace raytree::inspector {

void RightOfWay::take() {
    if (!taken_) {
        since_ = std::chrono::steady_clock::now();
        taken_ = true;
    }
}

void RightOfWay::leave() {
    if (taken_) {
        {
            const std::lock_guard lock(mutex_);
            taken_ = false;
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

void lower_own_priority() {
#ifdef __linux__
    constexpr int nicer = 10;
    thread_local const bool lowered = [] {
        const auto thread = static_cast<id_t>(gettid());
        return setpriority(PRIO_PROCESS, thread, getpriority(PRIO_PROCESS, thread) + nicer) == 0;
    }();
    static_cast<void>(lowered);
#endif
}

}  // namespace raytree::inspector
