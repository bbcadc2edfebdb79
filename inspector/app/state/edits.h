#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "state/history.h"
#include "state/knobs.h"

namespace raytree::inspector {

/// What has been changed of a scene, change by change, and where in that one is. Changes of one
/// value on the way, such as a slider's, are one change.
class Edits {
  public:
    /// Begins anew with a scene as it is in its file.
    void begin(Values values);
    /// Forgets what had been undone.
    void add(Values values, const std::string& place, Pick how);
    /// What comes next is a change of its own.
    void let_go() { on_the_way_.clear(); }
    /// Whether a change of this place goes on with the last one.
    bool goes_on(const std::string& place) const { return on_the_way_ == place; }

    bool can_undo() const { return here_ > 0; }
    bool can_redo() const { return here_ + 1 < steps_.size(); }
    bool can_reset() const { return !steps_.empty() && steps_[here_] != steps_.front(); }
    void undo() { go_to(here_ - 1); }
    void redo() { go_to(here_ + 1); }
    /// As the scene was opened; that can be undone as well.
    void reset();

    const Values& values() const { return *steps_[here_]; }
    /// Whether the values are not those of the file.
    bool unsaved() const { return !steps_.empty() && steps_[here_] != saved_; }
    void mark_saved() { saved_ = steps_[here_]; }

  private:
    void go_to(std::size_t place);

    static constexpr std::size_t most_ = 500;
    std::vector<std::shared_ptr<const Values>> steps_;
    std::size_t here_ = 0;
    std::shared_ptr<const Values> saved_;
    std::string on_the_way_;  ///< place of the value that is being dragged
};

}  // namespace raytree::inspector
