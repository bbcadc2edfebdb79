#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "tree/ray_tree.h"

namespace raytree::inspector {

/// A thing of the scene that is selected besides a ray.
struct Thing {
    enum class Kind { object, light };
    Kind kind = Kind::object;
    std::size_t index = 0;  ///< place in Scene::objects or Scene::lights
    friend bool operator==(const Thing&, const Thing&) = default;
};

bool exists(const Scene& scene, Thing thing);
const std::string& name_of(const Scene& scene, Thing thing);

/// The object that goes by a name in a tree: of a mesh's triangle "gem#3" that is the mesh.
std::optional<Thing> object_named(const Scene& scene, const std::string& name);
std::optional<Thing> light_named(const Scene& scene, const std::string& name);

/// What the ray ends at: the object that it meets or is stopped by, or the light that it reaches.
std::optional<Thing> thing_at_end_of(const Scene& scene, const TreeRay<double>& ray);

/// The name of what the ray meets or is stopped by; empty where it is nothing. Of a mesh's triangle
/// the mesh's.
std::string met_by(const TreeRay<double>& ray);

/// Whether the ray meets the object or is stopped by it, or is sent to the light.
bool concerns(const Scene& scene, Thing thing, const TreeRay<double>& ray);
std::vector<std::size_t> rays_that_concern(const Scene& scene, const RayTree<double>& tree,
                                           Thing thing);

}  // namespace raytree::inspector
