#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace raytree {

/// The kinds of rays of a Whitted ray tree.
enum class RayKind { primary, reflected, refracted, shadow };

/// Every reason for which a ray ends or is not sent.
enum class Reason {
    light_behind_surface,
    surface_unlit,
    not_reflective,
    not_transmissive,
    total_internal_reflection,
    max_depth,
    low_intensity,
    ray_budget,
    no_intersection,
    max_distance,
    opaque,
};

inline constexpr std::size_t reason_count = 11;

/// What the programs say of a reason, everywhere alike.
struct ReasonText {
    Reason reason;
    std::string_view word;      ///< in the ray-tree format
    std::string_view sentence;  ///< for people: why the ray was not sent or went no further
    std::string_view topic;     ///< of the lecture
};

/// One row for each reason, in the order of the enumeration.
const std::array<ReasonText, reason_count>& reason_texts();

const ReasonText& text_of(Reason reason);
std::string_view word_of(Reason reason);
std::string_view word_of(RayKind kind);

/// The reason or kind that a word of the format names, if any does.
std::optional<Reason> reason_from(std::string_view word);
std::optional<RayKind> ray_kind_from(std::string_view word);

}  // namespace raytree
