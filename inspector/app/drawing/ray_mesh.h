#pragma once

#include "drawing/mesh.h"
#include "drawing/ray_paths.h"
#include "drawing/scene_mesh.h"

namespace raytree::inspector {

/// How many rays are drawn as tubes; more of them become lines.
inline constexpr std::size_t most_tubes = 1500;

/// A tree's rays as they stand in the 3D view. Their thickness keeps within a range of pixels, so
/// they are made anew for each view.
struct RayMeshes {
    Mesh solid;
    Mesh fading;  ///< partly transparent: rays beside the selected ones, ends that fade out
    Mesh halo;    ///< around the selected ray: wider, to be seen from its inside only
    Lines lines;  ///< instead of tubes, where there are too many
};

struct RayMeshInput {
    const std::vector<RayPath>& paths;
    const PixelTree& tree;
    std::size_t selected = 0;
    const Extent& extent;
    const View& view;
    const Palette& palette;
    /// Of each ray of the tree, whether it is faded; empty: those that do not belong to the
    /// selected one are.
    const std::vector<bool>& set_aside = {};
    bool halo = true;  ///< whether the selected ray is marked: not where a thing is selected
};
RayMeshes ray_meshes(const RayMeshInput& input);

/// Rays of other pixels' trees, as thin faint lines.
void add_thin(Lines& lines, const std::vector<RayPath>& paths, const Palette& palette);

/// The eye, the lights, the frustum with the frame of the picture, the chosen pixel on it, the
/// normal at the selected ray's hit, and a mark on the selected object or light.
struct Landmarks {
    Mesh solid;
    Lines lines;
};
struct LandmarkInput {
    const Document& document;
    const TreeRay<double>* selected = nullptr;
    Pixel pixel;
    const Extent& extent;
    const View& view;
    const Palette& palette;
    std::optional<Thing> thing = std::nullopt;
    const SceneMesh* mesh = nullptr;  ///< there where an object is selected
};
Landmarks landmarks(const LandmarkInput& input);

/// Where a light's mark stands; far ones are drawn in to the edge of the scene.
Point3 place_of(const Light& light, const Extent& extent);
/// The tip of the normal that is drawn at a hit.
Point3 normal_tip(const TreeHit<double>& hit, const Extent& extent, const View& view);

}  // namespace raytree::inspector
