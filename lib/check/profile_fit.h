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

    /// The profile with the fewest causes of differences; the first of equals.
    const Profile& best() const;

    /// The conventions by which the profile differs from the lecture and without which it would not
    /// explain the submission.
    Choices shown(const Profile& profile) const;

    /// Whether `shown` is too little to know the course by: one convention of several that it has
    /// may as well be a mistake in another course.
    static bool is_doubtful(const Profile& profile, const Choices& shown);

    /// What other courses do that would make all of it right: one convention, or a course's; none
    /// where nothing would.
    Choices excuses(const Choices& base) const;

  private:
    bool explained_by(const Choices& choices) const;
    std::size_t causes(const Choices& choices, std::size_t enough,
                       const Slacks* slacks = nullptr) const;

    const Rulebooks& books_;
    const Submission& submission_;
    double rtol_;
};

}  // namespace raytree::check
