#include "tree/crossing_walk.h"

#include <limits>

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

/// The ray in the object's own space.
Ray<double> own_ray(const TreeRay<double>& ray, const Object& object) {
    const Ray<double> in_world{ray.origin, ray.direction, 0};
    return object.transform ? AffineMap<double>(*object.transform).ray_to_own_space(in_world)
                            : in_world;
}

/// Where the ray meets the polygon's plane, infinite where it does not.
double plane_distance(const TreeRay<double>& ray, const Object& object) {
    const Ray<double> own = own_ray(ray, object);
    const Plane<double> plane =
        supporting_plane(std::span<const Vec3<double>>(corners_of(object.shape, -1)));
    const double t =
        inner(plane.normal, plane.point - own.origin) / inner(plane.normal, own.direction);
    return t > 0 ? t : std::numeric_limits<double>::infinity();
}

/// Nothing where the plane is not met.
std::optional<CrossingWalk> walk_of(const World<double>& world, const TreeRay<double>& ray,
                                    PrimitiveId id) {
    const Primitive primitive = world.shapes.shapes()[id];
    const Object& object = world.scene().objects[primitive.object];
    const Ray<double> own = own_ray(ray, object);
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
    PrimitiveId nearest = no_primitive;
    double nearest_t = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < world.shapes.shapes().size(); ++k) {
        const auto id = static_cast<PrimitiveId>(k);
        const Object& object = world.scene().objects[world.shapes.shapes()[id].object];
        if (std::holds_alternative<Polygon>(object.shape)) {
            const double t = plane_distance(ray, object);
            if (t < nearest_t) {
                nearest_t = t;
                nearest = id;
            }
        }
    }
    return nearest == no_primitive ? std::nullopt : walk_of(world, ray, nearest);
}

bool has_polygon(const World<double>& world, std::string_view name) {
    return flat_named(world, name) != no_primitive;
}

}  // namespace raytree
