#include "state/thing.h"

#include <algorithm>

namespace raytree::inspector {
namespace {

/// A mesh's triangle k is "name#k"; no object's own name ends so unless it is an object's.
std::string without_part(const std::string& name) {
    const std::size_t mark = name.rfind('#');
    const bool part = mark != std::string::npos && mark + 1 < name.size() &&
                      std::all_of(name.begin() + static_cast<std::ptrdiff_t>(mark) + 1, name.end(),
                                  [](char c) { return c >= '0' && c <= '9'; });
    return part ? name.substr(0, mark) : name;
}

template <class Named>
std::optional<std::size_t> place_of(const std::vector<Named>& list, const std::string& name) {
    const auto found = std::ranges::find(list, name, &Named::name);
    return found == list.end()
               ? std::nullopt
               : std::optional<std::size_t>(static_cast<std::size_t>(found - list.begin()));
}

const std::string* end_of(const TreeRay<double>& ray) {
    if (ray.hit) {
        return &ray.hit->object;
    }
    return ray.shadow && ray.shadow->blocked_by ? &ray.shadow->blocked_by->object : nullptr;
}

}  // namespace

bool exists(const Scene& scene, Thing thing) {
    return thing.index <
           (thing.kind == Thing::Kind::object ? scene.objects.size() : scene.lights.size());
}

const std::string& name_of(const Scene& scene, Thing thing) {
    return thing.kind == Thing::Kind::object ? scene.objects[thing.index].name
                                             : scene.lights[thing.index].name;
}

std::optional<Thing> object_named(const Scene& scene, const std::string& name) {
    auto place = place_of(scene.objects, name);
    if (!place) {
        place = place_of(scene.objects, without_part(name));
    }
    return place ? std::optional(Thing{Thing::Kind::object, *place}) : std::nullopt;
}

std::optional<Thing> light_named(const Scene& scene, const std::string& name) {
    const auto place = place_of(scene.lights, name);
    return place ? std::optional(Thing{Thing::Kind::light, *place}) : std::nullopt;
}

std::optional<Thing> thing_at_end_of(const Scene& scene, const TreeRay<double>& ray) {
    if (const std::string* const name = end_of(ray)) {
        return object_named(scene, *name);
    }
    return ray.shadow ? light_named(scene, ray.shadow->light) : std::nullopt;
}

std::string met_by(const TreeRay<double>& ray) {
    const std::string* const name = end_of(ray);
    return name ? without_part(*name) : std::string();
}

bool concerns(const Scene& scene, Thing thing, const TreeRay<double>& ray) {
    const std::string& name = name_of(scene, thing);
    if (thing.kind == Thing::Kind::light) {
        return ray.shadow && ray.shadow->light == name;
    }
    const std::string* const end = end_of(ray);
    return end &&
           (*end == name || (std::holds_alternative<Mesh>(scene.objects[thing.index].shape) &&
                             without_part(*end) == name));
}

std::vector<std::size_t> rays_that_concern(const Scene& scene, const RayTree<double>& tree,
                                           Thing thing) {
    std::vector<std::size_t> rays;
    for (const TreeRay<double>& ray : tree.rays) {
        if (concerns(scene, thing, ray)) {
            rays.push_back(ray.id);
        }
    }
    return rays;
}

}  // namespace raytree::inspector
