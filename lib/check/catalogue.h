#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "check/laws.h"

/// What students get wrong, each entry defined by what it does to the model.
///
/// Adding a mistake is adding a row to one of the families' tables (catalogue_*.cpp): an id, a
/// sentence on what is wrong, the lecture's topic, and the change to the laws. The submission is
/// worked through under the laws so changed; where that gives its numbers, it is this mistake.
namespace raytree::check {

using LawChange = void (*)(Laws&);

struct MistakeRow {
    std::string_view id;
    std::string_view text;
    std::string_view topic;
    LawChange apply;
    std::array<LawChange, 4> others{};  ///< other ways to make the same mistake; the rest null

    /// `apply`, then the others.
    std::vector<LawChange> ways() const;
};

/// All of them, family by family.
const std::vector<MistakeRow>& catalogue();
const MistakeRow* find_mistake(std::string_view id);

std::span<const MistakeRow> camera_mistakes();
std::span<const MistakeRow> sphere_mistakes();
std::span<const MistakeRow> hit_mistakes();
std::span<const MistakeRow> normal_mistakes();
std::span<const MistakeRow> shadow_mistakes();
std::span<const MistakeRow> light_mistakes();
std::span<const MistakeRow> fading_mistakes();
std::span<const MistakeRow> highlight_mistakes();
std::span<const MistakeRow> reflection_mistakes();
std::span<const MistakeRow> refraction_mistakes();
std::span<const MistakeRow> recursion_mistakes();

}  // namespace raytree::check
