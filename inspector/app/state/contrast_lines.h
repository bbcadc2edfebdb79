#pragma once

#include "check/check.h"
#include "state/details.h"
#include "state/pixel_tree.h"

/// What there is to say of two trees that are laid over each other.
namespace raytree::inspector {

/// By what `check` has found; `of_shown`: whether the shown tree is the one it judged.
void mark_by_findings(const PixelTree& shown, Contrast& contrast, const check::Report& report,
                      bool of_shown);
/// By the numbers themselves; of two pixels, by what is met and how it ends alone.
void mark_by_numbers(const PixelTree& shown, Contrast& contrast);

/// "5 rays differ: 1 cause, 4 follow from it; 2 are missing, none is extra."
std::string summary_of(const Contrast& contrast);

/// Of a ray that is compared: each quantity in which the two are different, here and there.
std::vector<DetailSection> contrast_details(const PixelTree& tree, std::size_t ray);
/// Of a ray as a file has recorded it: what the file says, at full precision, and what it does not.
DetailSection recorded_details(const PixelTree& tree, std::size_t ray);

}  // namespace raytree::inspector
