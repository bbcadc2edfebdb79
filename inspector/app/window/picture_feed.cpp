#include "window/picture_feed.h"

#include <QAbstractEventDispatcher>

namespace raytree::inspector {
namespace {

/// The overlay that is asked for.
std::optional<OverlayOf> asked(const State& state) {
    if (state.look().depth_overlay && state.explained().depth) {
        return *state.explained().depth;
    }
    return state.look().overlay ? std::optional<OverlayOf>(*state.look().overlay) : std::nullopt;
}

}  // namespace

PictureFeed::PictureFeed(State& state, QObject* parent) : QObject(parent), state_(state) {
    timer_.setInterval(60);
    connect(&timer_, &QTimer::timeout, this, &PictureFeed::poll);
    // While this thread does not wait for events, it answers them.
    const auto* const events = QAbstractEventDispatcher::instance();
    connect(events, &QAbstractEventDispatcher::awake, this, [this] { way_->take(); });
    connect(events, &QAbstractEventDispatcher::aboutToBlock, this, [this] { way_->leave(); });
    state_.observe([this](const Changes& changes) {
        if (changes.document || changes.values) {
            restart();
        }
        if (changes.document || changes.values ||
            ((changes.look || changes.explained) && asked(state_) != measure_)) {
            measure();
        }
    });
}

std::optional<Rgb<double>> PictureFeed::intensity(Pixel pixel) const {
    return render_ ? render_->intensity(pixel) : std::nullopt;
}

/// The threads of the old picture are not waited for: a single tree of theirs may take long.
void PictureFeed::restart() {
    if (render_) {
        render_->cancel();
        ending_.push_back(std::move(render_));
    }
    render_ = std::make_unique<PictureRender>(state_.document(), &picture_, way_.get());
    version_ = ~std::uint64_t{0};
    timer_.start();
    poll();
}

/// Overlays are measured when they are asked for.
void PictureFeed::measure() {
    if (measuring_) {
        measuring_->cancel();
        ending_overlays_.push_back(std::move(measuring_));
    }
    measure_ = asked(state_);
    overlay_.reset();
    overlay_failed_ = false;
    if (measure_ && state_.document()) {
        measuring_ = std::make_unique<OverlayRender>(state_.document(), *measure_, way_.get());
        timer_.start();
    }
    Q_EMIT updated();
}

void PictureFeed::poll_overlay() {
    std::erase_if(ending_overlays_, [](const auto& render) { return render->stopped(); });
    if (!measuring_) {
        return;
    }
    if (measuring_->stopped()) {
        overlay_ = measuring_->overlay();
        overlay_failed_ = !overlay_;
        const std::string failure = measuring_->failure();
        measuring_.reset();
        if (!failure.empty()) {
            state_.say(failure);
        }
    }
    Q_EMIT updated();
}

void PictureFeed::poll() {
    poll_overlay();
    std::erase_if(ending_, [](const auto& render) { return render->stopped(); });
    const std::uint64_t now = render_->version();
    const bool finished = render_->stopped();
    if (now != version_) {
        version_ = now;
        picture_ = render_->snapshot();
        Q_EMIT updated();
    }
    if (finished && now == render_->version() && ending_.empty() && !measuring_ &&
        ending_overlays_.empty()) {
        timer_.stop();
    }
}

}  // namespace raytree::inspector
