#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "drawing/extent.h"
#include "drawing/mesh.h"

namespace raytree::inspector {

/// The triangles of one object within SceneMesh::faces, and its segments within SceneMesh::wires.
struct ObjectFaces {
    std::size_t object = 0;  ///< its place in Scene::objects
    std::size_t first = 0;   ///< of the triangles
    std::size_t count = 0;
    std::size_t first_point = 0;
    std::size_t points = 0;
    std::size_t first_wire = 0;
    std::size_t wires = 0;
    Point3 centre{0, 0, 0};
    double radius = 0;       ///< of a ball around the centre that holds it
    bool flat = false;       ///< a polygon that is large beside the rest
    bool tiny = false;       ///< so few pixels large that its far side is not drawn
    Point3 normal{0, 0, 0};  ///< of a flat one
};

/// A scene's shapes as they stand in the 3D view. The alpha of a colour
/// tells how firm a shape is where it is looked at straight on: from 0 to 127 that of a round
/// shape, which gets firmer towards its rim, from 128 to 255 that of a flat one, which does not.
struct SceneMesh {
    Mesh faces;
    Lines edges;  ///< of polygons
    Lines wires;  ///< of all shapes
    std::vector<ObjectFaces> objects;
    std::size_t thinned_from = 0;  ///< triangles of meshes, where fewer are drawn; else 0
};

/// Round shapes have as many facets as they need where a pixel is `pixel` long.
SceneMesh scene_mesh(const Document& document, const Extent& extent, double pixel);

/// The length of a pixel in the middle of the scene, rounded to a power of two of the diagonal: the
/// mesh need not be made anew for each view.
double mesh_pixel(const Extent& extent, const View& view);

/// Places in SceneMesh::objects in an order in which see-through ones may be drawn, the farthest
/// first.
std::vector<std::size_t> drawing_order(const SceneMesh& mesh, const Extent& extent,
                                       const Point3& eye);

/// The triangles of these objects, in this order; of each, those that face the eye last, of a tiny
/// one alone.
std::vector<std::int32_t> triangles_of(const SceneMesh& mesh, std::span<const std::size_t> objects,
                                       const Point3& eye);

/// These objects alone, in the same order.
Mesh part_of(const SceneMesh& mesh, std::span<const std::size_t> objects, const Point3& eye);

}  // namespace raytree::inspector
