#pragma once

#include "check/replay.h"
#include "check/rulebook.h"
#include "check/submission.h"

namespace raytree::check {

/// The axes that trees show: how colours are made 8 bits, or curved, is seen in pictures alone.
Choices seen_in_trees(Choices choices);

/// Which courses' conventions a submission was computed by.
class ProfileFit {
  public:
    /// All must outlive it.
    ProfileFit(const Rulebooks& books, const Submission& submission, double rtol)
        : books_(books), submission_(submission), rtol_(rtol) {}

    /// The profile with the fewest causes of differences; the first of equals, and the lecture's
    /// where rounding alone is why it has any.
    const Profile& best() const;

    /// Of a profile that explains the submission: the conventions by which it differs from the
    /// lecture and without which it would not. All of them where one makes up for another.
    Choices shown(const Profile& profile) const;

    /// What other courses do that would make all of it right: one convention, or a course's; none
    /// where nothing would. `first` is the first cause of a difference by `base`; where it is
    /// surely `mistake`, only what is that mistake elsewhere is tried.
    Choices excuses(const Choices& base, const Finding& first, std::string_view mistake) const;

  private:
    bool explained_by(const Choices& choices) const {
        return explained_by(choices, nullptr, most_);
    }
    bool explained_by(const Choices& choices, const Finding* first, std::size_t less_than) const;
    Replay replayed(const Rulebook& book, const ReplayOptions& options) const;
    std::size_t causes(const Choices& choices, std::size_t enough) const;

    static constexpr std::size_t most_ = 20;  // causes that rounding alone may make
    const Rulebooks& books_;
    const Submission& submission_;
    double rtol_;
};

}  // namespace raytree::check
