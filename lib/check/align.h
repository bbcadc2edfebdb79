#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "check/finding.h"

/// Two trees side by side, ray by ray.
namespace raytree::check {

/// Which rays correspond: those of the same kind, shadow rays of the same light, sent from hits
/// that correspond. Of a kind that a hit has twice, the first.
struct Alignment {
    std::vector<std::optional<std::size_t>> of_first;   ///< for each ray of the first tree
    std::vector<std::optional<std::size_t>> of_second;  ///< and of the second
};
Alignment align(const RayTree<double>& first, const RayTree<double>& second);

/// The first of `children` that is of this kind and, where it is a shadow ray, of this light.
std::optional<std::size_t> corresponding(const RayTree<double>& tree,
                                         const std::vector<std::size_t>& children, RayKind kind,
                                         const std::string& light);

/// What a ray says of a field in numbers or in a word ("nothing" where it hits nothing and where
/// nothing blocks it); none where it says nothing.
Value value_of(const RayTree<double>& tree, std::size_t ray, Field field);

/// A field of which two rays say different things.
struct FieldDifference {
    Field field = Field::intensity;
    Value first, second;
    double error = 0;  ///< relative to the size of the quantity; 1 for words
};
/// Every field that both rays have, in the order of computation. `rtol` is relative to the size of
/// the quantity; of directions and cosines to 1; of what an intensity is summed up from to the
/// whole of it, and that is at least 1e-12 of the pixel's.
std::vector<FieldDifference> differences(const RayTree<double>& first, std::size_t ray,
                                         const RayTree<double>& second, std::size_t other,
                                         double rtol);

}  // namespace raytree::check
