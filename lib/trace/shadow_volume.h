#pragma once

#include <string>
#include <vector>

#include "trace/world.h"

/// Shadow volumes (Crow, "Shadow algorithms for computer graphics", 1977): the space behind an
/// object as seen from a light, and the count of its walls along a ray.
namespace raytree {

/// A wall of a volume: from the edge a to b of the object away from the light, without end. Seen
/// from the light, the volume lies to the left of the way from a to b.
struct VolumeWall {
    Vec3<double> a{}, b{};
};

/// The shadow of one polygon or of one mesh.
struct ShadowVolume {
    std::size_t object = 0;  ///< place in Scene::objects
    std::vector<VolumeWall> walls;
    /// What the light meets: polygons turned so that they run counter-clockwise as seen from it.
    std::vector<std::vector<Vec3<double>>> caps;
};

struct ShadowVolumes {
    bool directional = false;
    Vec3<double> light{};  ///< its position, or of a directional one the unit way towards it
    std::vector<ShadowVolume> volumes;
    std::vector<std::size_t> left_out;  ///< objects that have no edges: spheres and cones
};

/// One wall that a ray goes through.
struct WallCrossing {
    double t = 0;
    std::size_t volume = 0;  ///< place in ShadowVolumes::volumes
    bool enters = true;      ///< the ray goes into the volume: the count rises
};

struct VolumeCount {
    int start = 0;                        ///< volumes that the ray's origin is inside of
    std::vector<WallCrossing> crossings;  ///< in the order of t
    int end = 0;  ///< start, plus those entered, less those left; more than 0: in shadow
};

/// The volumes of polygons and meshes under one light. Of a closed mesh the silhouette alone has
/// walls: edges between a triangle that faces the light and one that does not.
ShadowVolumes shadow_volumes(const World<double>& world, std::size_t light);

/// Counts the walls between the ray's origin and the point at `t`.
VolumeCount count_volumes(const ShadowVolumes& volumes, const Ray<double>& ray, double t);

/// How many volumes a point is inside of: what a count has to start with.
int volumes_around(const ShadowVolumes& volumes, const Vec3<double>& point);

/// The far corner of a wall's side, for drawing it: `reach` beyond the point.
Vec3<double> far_corner(const ShadowVolumes& volumes, const Vec3<double>& point, double reach);

}  // namespace raytree
