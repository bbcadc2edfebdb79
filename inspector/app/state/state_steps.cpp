#include <algorithm>

#include "state/state.h"

/// The state's part in stepping through a tree.
namespace raytree::inspector {

Playback State::new_playback() const {
    std::vector<std::string> lights;
    for (const Light& light : document_->scene().lights) {
        lights.push_back(light.name);
    }
    return Playback(tree_, step_order_, lights);
}

std::size_t State::stops() const {
    return playback_ ? playback_->stops() : tree_ ? new_playback().stops() : 0;
}

void State::begin_playback() {
    playback_.emplace(new_playback());
    playing_ = false;
    selected_ = playback_->event().ray;
}

void State::start_stepping() {
    if (tree_) {
        begin_playback();
        side_pane_ = SidePane::steps;
        tell({.selection = true, .playback = true, .side_pane = true});
    }
}

void State::end_stepping() {
    if (playback_) {
        playback_.reset();
        playing_ = false;
        tell({.playback = true});
    }
}

void State::go_to_stop(std::size_t stop) {
    if (!tree_) {
        return;
    }
    const bool begins = !playback_;
    if (begins) {
        begin_playback();
        side_pane_ = SidePane::steps;
    }
    playback_->go_to(stop);
    selected_ = playback_->event().ray;
    tell({.selection = true, .playback = true, .side_pane = begins});
}

void State::set_step_order(StepOrder order) {
    step_order_ = order;
    if (playback_ && tree_) {  // else as soon as the tree has come
        begin_playback();
    }
    tell({.selection = playback_.has_value(), .playback = true});
}

void State::play(bool playing) {
    if (playing && (!playback_ || playback_->at_end())) {
        go_to_stop(0);
    }
    playing_ = playing && playback_.has_value();
    tell({.playback = true});
}

void State::set_pace(double stops_a_second) {
    pace_ = std::clamp(stops_a_second, 0.25, 32.0);
    tell({.playback = true});
}

void State::tick() {
    if (playing_ && !busy_) {
        playing_ = playback_->stop() + 2 < playback_->stops();
        go_to_stop(playback_->stop() + 1);
    }
}

}  // namespace raytree::inspector
