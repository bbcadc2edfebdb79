#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "check/laws.h"

/// What courses do differently without being wrong: named axes, on each of which a course has a
/// value.
namespace raytree::check {

/// A value on an axis. Most are settings or a window that a scene could have; the rest are other
/// laws. The default value of an axis has neither: it is as the scene and the model have it.
struct Convention {
    std::string_view axis, value, text;
    void (*on_scene)(Scene&);
    void (*on_laws)(Laws&);
    std::string_view mistake;  ///< of the catalogue, that it would be in another course; or empty
};

/// All of them, axis by axis, the default of each axis first.
const std::vector<Convention>& conventions();

/// A value for each axis, in the order of the axes.
using Choices = std::vector<const Convention*>;
Choices default_choices();
/// `choices` with the value that "axis=value" says.
Choices with_choice(Choices choices, std::string_view choice);
/// "sample=corner near=all", without the defaults.
std::string text_of(const Choices& choices);

/// A course: on the axes that it does not name it has the default.
struct Profile {
    std::string_view name, text;
    std::vector<std::string_view> named;  ///< "axis=value"
};

/// The first is `lecture`.
const std::vector<Profile>& profiles();
/// Throws InputError for a name that there is none of.
const Profile& profile_named(std::string_view name);

/// What the lecture says where a scene's settings are not its author's but those of the course text
/// format: they are then one course's conventions.
inline constexpr std::string_view lecture_for_course_text[] = {"sample=centre", "near=none",
                                                               "miss=background"};

}  // namespace raytree::check
