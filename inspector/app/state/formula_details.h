#pragma once

#include "state/details.h"

namespace raytree::inspector {

/// What a lesson's formula says of the selected ray where the details do not have it already, and
/// its coordinates in eye space where these are asked for.
std::vector<DetailSection> formula_details(const State& state);

/// The formula that the lesson's step marks; none where nothing is marked.
std::optional<lesson::Formula> marked_formula(const State& state);

/// Whether a section of the details is about a formula.
bool is_about(const DetailSection& section, lesson::Formula formula);

}  // namespace raytree::inspector
