#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <optional>
#include <string_view>

/// Which of a ray's quantities a file gave, where a file may give as few as it likes.
namespace raytree {

/// What a ray of the format raytree/1.0 may say of itself, in the order in which it is computed.
enum class Field {
    origin,
    direction,
    weight,
    hit,  ///< whether the ray hits at all: an object, or `null`
    object,
    t,
    point,
    normal,
    side,
    cos_incident,
    eta,
    sin2_transmitted,
    ambient,
    light,
    distance,
    blocked_by,  ///< an object, or `null`
    transmittance,
    diffuse,
    specular,
    attenuation,
    intensity,
    termination,
};

inline constexpr std::size_t field_count = 22;

using Given = std::bitset<field_count>;

constexpr std::size_t place_of(Field field) { return static_cast<std::size_t>(field); }

/// The field's key in the format.
inline constexpr std::array<std::string_view, field_count> field_words = {
    "origin",   "direction",   "weight",    "hit",          "object",        "t",
    "point",    "normal",      "side",      "cos_incident", "eta",           "sin2_transmitted",
    "ambient",  "light",       "distance",  "blocked_by",   "transmittance", "diffuse",
    "specular", "attenuation", "intensity", "termination"};

constexpr std::string_view word_of(Field field) { return field_words[place_of(field)]; }

}  // namespace raytree
