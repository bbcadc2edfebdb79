#include "tree/crossing_walk.h"

namespace raytree {
namespace {

bool is_flat(const World<double>& world, PrimitiveId id) {
    const Shape& shape = world.scene().objects[world.shapes.shapes()[id].object].shape;
    return std::holds_alternative<Polygon>(shape) || std::holds_alternative<Mesh>(shape);
}

PrimitiveId flat_named(const World<double>& world, std::string_view name) {
    const PrimitiveId id = primitive_named(world, name);
    return id != no_primitive && is_flat(world, id) ? id : no_primitive;
}

/// Nothing where the plane is not met.
std::optional<CrossingWalk> walk_of(const World<double>& world, const TreeRay<double>& ray,
                                    PrimitiveId id) {
    const Primitive primitive = world.shapes.shapes()[id];
    const Object& object = world.scene().objects[primitive.object];
    Ray<double> own{ray.origin, ray.direction, 0};
    if (object.transform) {
        own = AffineMap<double>(*object.transform).ray_to_own_space(own);
    }
    const std::vector<Vec3<double>> corners = corners_of(object.shape, primitive.part);
    CrossingWalk walk{primitive_name(world.scene(), primitive),
                      derive_polygon(corners, own),
                      {},
                      {},
                      corners.size(),
                      object.transform.has_value()};
    if (walk.test.speed == 0 || !(walk.test.t > 0)) {
        return std::nullopt;
    }
    const int u = (walk.test.dropped + 1) % 3;
    for (const OutlineCrossing& crossing : outline_crossings(corners, walk.test)) {
        walk.crossed.push_back({crossing.edge, crossing.at[u], corners[crossing.edge],
                                corners[(crossing.edge + 1) % corners.size()], crossing.at});
    }
    walk.point = along(ray.origin, walk.test.t, ray.direction);
    if (object.transform) {
        const AffineMap<double> map(*object.transform);
        for (CrossingWalk::Crossed& crossed : walk.crossed) {
            for (Vec3<double>* const place : {&crossed.from, &crossed.to, &crossed.at}) {
                *place = map.point_to_world(*place);
            }
        }
    }
    return walk;
}

}  // namespace

std::optional<CrossingWalk> crossing_walk(const World<double>& world, const TreeRay<double>& ray,
                                          std::string_view name) {
    if (name.empty() && ray.hit) {
        name = ray.hit->object;
        if (flat_named(world, name) == no_primitive) {
            name = {};
        }
    }
    if (!name.empty()) {
        const PrimitiveId id = flat_named(world, name);
        return id == no_primitive ? std::nullopt : walk_of(world, ray, id);
    }
    std::optional<CrossingWalk> nearest;
    for (std::size_t k = 0; k < world.shapes.shapes().size(); ++k) {
        const auto id = static_cast<PrimitiveId>(k);
        const Shape& shape = world.scene().objects[world.shapes.shapes()[id].object].shape;
        if (std::holds_alternative<Polygon>(shape)) {
            auto walk = walk_of(world, ray, id);
            if (walk && (!nearest || walk->test.t < nearest->test.t)) {
                nearest = std::move(walk);
            }
        }
    }
    return nearest;
}

bool has_polygon(const World<double>& world, std::string_view name) {
    return flat_named(world, name) != no_primitive;
}

}  // namespace raytree
