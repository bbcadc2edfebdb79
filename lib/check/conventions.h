#pragma once

#include <string_view>
#include <vector>

#include "check/laws.h"
#include "check/names.h"
#include "check/submission.h"

/// What courses do differently without being wrong.
namespace raytree::check {

/// One choice of a convention: `apply` makes it part of the laws.
struct Convention {
    std::string_view axis, value, text;
    void (*apply)(Laws&);
};

/// A course's conventions, by axis; on the axes that it does not name, the scene's and the model's.
struct Profile {
    std::string_view name, text;
    std::vector<std::string_view> choices;  ///< "axis=value"
};

const std::vector<Convention>& conventions();
/// The first is `lecture`.
const std::vector<Profile>& profiles();
/// Throws InputError for a name that there is none of.
const Profile& profile_named(std::string_view name);
Laws laws_of(const Profile& profile);

/// The profile with the fewest causes of differences; the first of equals.
const Profile& best_profile(const Place& place, const Names& names, const Submission& submission);

}  // namespace raytree::check
