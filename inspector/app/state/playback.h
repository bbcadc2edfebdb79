#pragma once

#include <memory>
#include <string>
#include <vector>

#include "state/pixel_tree.h"
#include "tree/schedule.h"

namespace raytree::inspector {

/// How far the tree has been stepped through. Rays not yet sent are not drawn, and an intensity
/// that has not been returned is not shown.
class Playback {
  public:
    /// At the first stop. `lights` are the scene's names.
    Playback(const std::shared_ptr<const PixelTree>& tree, StepOrder order,
             const std::vector<std::string>& lights);

    /// The tree's own rays, without those of a tree that it is compared with.
    const RayTree<double>& tree() const { return *tree_; }
    StepOrder order() const { return schedule_->order(); }
    std::size_t stop() const { return stop_; }
    std::size_t stops() const { return schedule_->stops().size(); }
    bool at_end() const { return stop_ + 1 == stops(); }

    /// To a stop; beyond the last, to the last.
    void go_to(std::size_t stop);

    /// Of a ray of the shown tree.
    Stage stage(std::size_t ray) const { return schedule_->stage(ray, happened()); }
    bool decided(std::size_t ray, std::size_t skip) const {
        return schedule_->decided(ray, skip, happened());
    }
    /// The last event.
    const TreeEvent& event() const { return schedule_->events()[happened() - 1]; }
    /// Whether what a ray returns is known, and the summands at its hit: a tree that was recorded
    /// elsewhere may lack them.
    bool gives_intensity(std::size_t ray) const { return shown_->gives_intensity(ray); }
    bool gives_summands(std::size_t ray) const;
    std::vector<OpenCall> calls() const { return open_calls(*tree_, *schedule_, happened()); }

  private:
    std::size_t happened() const { return schedule_->stops()[stop_]; }

    std::shared_ptr<const PixelTree> shown_;
    std::shared_ptr<const RayTree<double>> tree_;
    std::shared_ptr<const Schedule> schedule_;
    std::size_t stop_ = 0;
};

/// What has just happened, in a sentence.
std::string event_text(const Playback& playback);

/// How many rays have been sent so far: "3 rays sent so far: 1 primary, 2 shadow".
std::string sent_text(const Playback& playback);

/// An open call in words.
struct CallText {
    std::size_t ray = 0;
    std::string title;      ///< "#3 refracted"
    std::string waits_for;  ///< "its hit", "#4 shadow → key"
    std::string sum;        ///< what has come in so far; empty before the hit
};
/// The innermost call last. Of very many (level by level), the first `most`.
std::vector<CallText> call_texts(const Playback& playback, std::size_t most = 200);

}  // namespace raytree::inspector
