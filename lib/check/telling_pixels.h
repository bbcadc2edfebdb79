#pragma once

#include <span>
#include <string>
#include <vector>

#include "check/catalogue.h"
#include "check/picture_values.h"
#include "tree/ray_tree.h"

/// Pixels at which mistakes can be seen.
namespace raytree::check {

/// Whether a check would call one of the trees by the other: another shape, another object, or a
/// number that differs by more than a millionth.
bool differ(const RayTree<double>& a, const RayTree<double>& b);

struct TellingPixel {
    PixelPlace at;
    std::size_t rays = 0;                    ///< of its true tree
    std::vector<const MistakeRow*> exposes;  ///< that change its tree
};

struct TellingOptions {
    std::size_t count = 3;        ///< pixels to find, at most
    std::size_t looked_at = 240;  ///< pixels, spread over the picture
    std::size_t most_rays = 60;   ///< of a tree: they are worked through by students
};

/// Pixels that together expose as many of `mistakes` as possible, the most telling first; once none
/// exposes more, others that expose them again. Of equally telling ones that with the smaller tree.
/// Depends on the scene alone.
std::vector<TellingPixel> exposing_pixels(const Place& place,
                                          std::span<const MistakeRow* const> mistakes,
                                          const TellingOptions& options = {});

/// Sentences that name such pixels in this scene and, where they are not enough, in others.
struct NamedScene {
    std::string name;
    const Scene* scene;
};
std::vector<std::string> suggestions(const Place& place, const Laws& laws,
                                     const std::vector<std::string>& mistakes,
                                     std::span<const NamedScene> others);

/// Pixels at which these mistakes give different trees, so that a second submission tells which of
/// them it is; `told` are the pairs that they tell apart, of `pairs`.
struct TellingApart {
    std::vector<PixelPlace> at;
    std::size_t told = 0, pairs = 0;
};
TellingApart pixels_that_tell_apart(const Place& place, const Laws& laws,
                                    std::span<const MistakeRow* const> mistakes,
                                    const TellingOptions& options = {});

}  // namespace raytree::check
