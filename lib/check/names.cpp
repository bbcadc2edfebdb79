#include "check/names.h"

namespace raytree::check {

Names::Names(const Place& place) : place_(place) {
    const Scene& scene = place.scene();
    const auto& shapes = place.shapes.shapes();
    for (std::size_t k = 0; k < shapes.size(); ++k) {
        const auto id = static_cast<PrimitiveId>(k);
        names_.push_back(primitive_name(scene, shapes[id]));
        by_name_.emplace(names_.back(), id);
        by_name_.emplace(scene.objects[shapes[id].object].name, id);
    }
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        lights_.emplace(scene.lights[k].name, k);
    }
}

bool Names::means(const std::string& name, PrimitiveId primitive) const {
    const std::size_t object = place_.shapes.shapes()[primitive].object;
    return name == names_[primitive] || name == place_.scene().objects[object].name;
}

std::optional<PrimitiveId> Names::find(const std::string& name) const {
    const auto found = by_name_.find(name);
    return found == by_name_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::size_t> Names::light(const std::string& name) const {
    const auto found = lights_.find(name);
    return found == lights_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace raytree::check
