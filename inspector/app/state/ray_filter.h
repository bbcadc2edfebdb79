#pragma once

#include <compare>
#include <map>
#include <string>
#include <vector>

#include "state/pixel_tree.h"

/// Which rays of a tree are dimmed or left out of the 3D view; the other panes show them faded.
namespace raytree::inspector {

enum class Shown { full, dimmed, hidden };

/// What rays have in common: that they are of a kind or level, sent to a light, or meet an object.
struct RayGroup {
    enum class By { kind, level, light, object };
    By by = By::kind;
    std::string name;  ///< "reflected", "3", "key", "glass ball"
    friend auto operator<=>(const RayGroup&, const RayGroup&) = default;
};

struct RayFilter {
    std::map<RayGroup, Shown> groups;  ///< those that are not shown in full
    double least_weight = 0;           ///< rays with a smaller share of the pixel are `lighter`
    Shown lighter = Shown::hidden;

    Shown of(const RayGroup& group) const;
    void set(const RayGroup& group, Shown shown);
    bool empty() const { return groups.empty() && least_weight == 0; }
    friend bool operator==(const RayFilter&, const RayFilter&) = default;
};

inline RayGroup group_of(RayKind kind) { return {RayGroup::By::kind, std::string(word_of(kind))}; }

/// "kind", "level", "light", "object"
std::string_view word_of(RayGroup::By by);
std::string_view word_of(Shown shown);

/// How much of the pixel a ray carries, the largest channel, 0 to 1. A shadow ray's weight is that
/// of the ray from whose hit it goes out.
double weight_of(const PixelTree& tree, const TreeRay<double>& ray);

/// What is least of all that the filter says of the ray.
Shown shown(const RayFilter& filter, const PixelTree& tree, const TreeRay<double>& ray);

/// A group, and how many of a tree's own rays are of it.
struct CountedGroup {
    RayGroup group;
    std::size_t rays = 0;
};
/// The groups that a tree has, and those that the filter names, without a ray of this tree though
/// they be: what is hidden at one pixel can be shown again at the next.
std::vector<CountedGroup> groups_of(const PixelTree& tree, const RayFilter& filter);

/// "hidden: shadow rays, level 4 · dimmed: rays to key"; empty where all are shown.
std::string text_of(const RayFilter& filter);

}  // namespace raytree::inspector
