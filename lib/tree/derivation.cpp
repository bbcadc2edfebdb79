#include "tree/derivation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <ranges>

namespace raytree {
namespace {

using Tree = RayTree<double>;
using Node = TreeRay<double>;

Ray<double> ray_of(const Node& node) {
    const double error =
        node.parent ? 4 * Real<double>::unit_roundoff * largest_component(node.origin) : 0.0;
    return {node.origin, node.direction, error};
}

Interval<double> interval_of(const World<double>& world, const Node& node) {
    Interval<double> interval;
    if (!node.parent) {
        interval.from = world.camera.near_along(node.direction);
    }
    if (node.shadow && node.shadow->distance) {
        interval.to = *node.shadow->distance;
    }
    return interval;
}

/// Where the tree says that the ray ends at a shape: its hit, or what blocks it.
std::optional<Blocker<double>> end_of(const Node& node) {
    if (node.hit) {
        return Blocker<double>{node.hit->object, node.hit->t};
    }
    return node.shadow ? node.shadow->blocked_by : std::nullopt;
}

void derive_hit(const World<double>& world, PrimitiveId id, Ray<double> ray, double t,
                Derivation& result) {
    const Primitive primitive = world.shapes.shapes()[id];
    const Object& object = world.scene().objects[primitive.object];
    result.own_space = object.transform.has_value();
    if (object.transform) {
        ray = AffineMap<double>(*object.transform).ray_to_own_space(ray);
    }
    if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
        result.how = derive_sphere(*sphere, ray, t);
    } else if (const auto* cone = std::get_if<Cone>(&object.shape)) {
        result.how = derive_cone(*cone, ray, t);
    } else {
        result.how = derive_polygon(corners_of(object.shape, primitive.part), ray);
    }
}

/// Enters and leaves what the rays from the eye to this one do.
std::vector<Medium> media_of(const Scene& scene, const World<double>& world, const Tree& tree,
                             const Node& node) {
    std::vector<const Node*> way;
    for (const Node* at = &node; at->parent; at = &tree.rays[*at->parent]) {
        way.push_back(at);
    }
    std::vector<std::size_t> inside;
    for (const Node* const at : way | std::views::reverse) {
        const TreeHit<double>& hit = *tree.rays[*at->parent].hit;
        const PrimitiveId id = primitive_named(world, hit.object);
        if (at->kind != RayKind::refracted || id == no_primitive) {
            continue;
        }
        const std::size_t material = scene.objects[world.shapes.shapes()[id].object].material;
        if (hit.side == Side::front) {
            inside.push_back(material);
        } else if (const auto last = std::find(inside.rbegin(), inside.rend(), material);
                   last != inside.rend()) {
            inside.erase(std::next(last).base());
        }
    }
    std::vector<Medium> media;
    for (const std::size_t material : inside) {
        media.push_back({scene.materials[material].name, scene.materials[material].ior});
    }
    return media;
}

}  // namespace

SphereDerivation derive_sphere(const Sphere& sphere, const Ray<double>& ray, double t) {
    const Vec3<double> f =
        ray.origin - Vec3<double>{sphere.center.x, sphere.center.y, sphere.center.z};
    SphereDerivation result;
    result.a = inner(ray.direction, ray.direction);
    result.b = 2 * inner(ray.direction, f);
    result.c = inner(f, f) - sphere.radius * sphere.radius;
    result.discriminant = result.b * result.b - 4 * result.a * result.c;
    const double root = std::sqrt(std::max(0.0, result.discriminant));
    result.roots = {(-result.b - root) / (2 * result.a), (-result.b + root) / (2 * result.a)};
    result.taken = std::abs(result.roots[0] - t) <= std::abs(result.roots[1] - t) ? 0 : 1;
    return result;
}

ConeDerivation derive_cone(const Cone& cone, const Ray<double>& ray, double t) {
    const ConeShape<double> shape =
        make_cone<double>(cone.base, cone.base_radius, cone.apex, cone.apex_radius);
    const ConeQuadratic<double> q = quadratic(shape, ray.origin - shape.base, ray.direction);
    ConeDerivation result{shape.base_radius, shape.slope, shape.height, q.a, 2 * q.b, q.c};
    result.discriminant = result.b * result.b - 4 * result.a * result.c;
    const double root = std::sqrt(std::max(0.0, result.discriminant));
    if (result.a == 0) {  // along a line of the cone: one root, that of B t + C = 0
        result.roots = {-result.c / result.b, std::numeric_limits<double>::quiet_NaN()};
    } else {
        result.roots = {(-result.b - root) / (2 * result.a), (-result.b + root) / (2 * result.a)};
    }
    if (result.roots[1] < result.roots[0]) {  // A may be negative: the ray is steeper than the cone
        std::swap(result.roots[0], result.roots[1]);
    }
    for (std::size_t k = 0; k < 2; ++k) {
        result.heights[k] = q.z + result.roots[k] * q.dz;
    }
    result.taken = std::abs(result.roots[1] - t) < std::abs(result.roots[0] - t) ? 1 : 0;
    return result;
}

PolygonDerivation derive_polygon(std::span<const Vec3<double>> vertices, const Ray<double>& ray) {
    const PolygonShape<double> polygon = make_polygon<double>(vertices, {});
    PolygonDerivation result;
    result.normal = polygon.plane.normal.vec();
    result.offset = inner(result.normal, polygon.plane.point);
    result.start = inner(result.normal, ray.origin);
    result.speed = inner(result.normal, ray.direction);
    result.t = (result.offset - result.start) / result.speed;
    result.dropped = 3 - polygon.axes.u - polygon.axes.v;
    result.u = ray.origin[polygon.axes.u] + result.t * ray.direction[polygon.axes.u];
    result.v = ray.origin[polygon.axes.v] + result.t * ray.direction[polygon.axes.v];
    result.crossings = static_cast<int>(outline_crossings(vertices, result).size());
    return result;
}

std::vector<OutlineCrossing> outline_crossings(std::span<const Vec3<double>> vertices,
                                               const PolygonDerivation& polygon) {
    const int u = (polygon.dropped + 1) % 3, v = (polygon.dropped + 2) % 3;
    std::vector<OutlineCrossing> crossed;
    for (std::size_t k = 0; k < vertices.size(); ++k) {
        const Vec3<double>&from = vertices[k], &to = vertices[(k + 1) % vertices.size()];
        if ((from[v] > polygon.v) == (to[v] > polygon.v)) {
            continue;
        }
        const double share = (polygon.v - from[v]) / (to[v] - from[v]);
        const Vec3<double> at = from + share * (to - from);
        if (at[u] > polygon.u) {
            crossed.push_back({k, at});
        }
    }
    std::ranges::sort(crossed, {}, [&](const OutlineCrossing& each) { return each.at[u]; });
    return crossed;
}

PrimitiveId primitive_named(const World<double>& world, std::string_view name) {
    const auto& shapes = world.shapes.shapes();
    for (std::size_t k = 0; k < shapes.size(); ++k) {
        const auto id = static_cast<PrimitiveId>(k);
        if (name.starts_with(world.scene().objects[shapes[id].object].name) &&
            primitive_name(world.scene(), shapes[id]) == name) {
            return id;
        }
    }
    return no_primitive;
}

std::vector<Vec3<double>> corners_of(const Shape& shape, int part) {
    std::vector<Vec3<double>> vertices;
    if (const auto* polygon = std::get_if<Polygon>(&shape)) {
        for (const Point& vertex : polygon->vertices) {
            vertices.push_back({vertex.x, vertex.y, vertex.z});
        }
    } else if (const auto* mesh = std::get_if<Mesh>(&shape)) {
        for (const Mesh::Corner& corner : mesh->triangles[static_cast<std::size_t>(part)]) {
            const Point& vertex = mesh->vertices[static_cast<std::size_t>(corner.vertex)];
            vertices.push_back({vertex.x, vertex.y, vertex.z});
        }
    }
    return vertices;
}

Derivation derive(const World<double>& world, const RayTree<double>& tree, std::size_t id) {
    const Node& node = tree.rays[id];
    const PrimitiveId leaving =
        node.parent ? primitive_named(world, tree.rays[*node.parent].hit->object) : no_primitive;
    const Ray<double> ray = ray_of(node);
    const auto end = end_of(node);
    Derivation result;
    NoTestCount count;
    for (const Hit<double>& hit : world.shapes.all(ray, leaving, interval_of(world, node), count)) {
        std::string name = primitive_name(world.scene(), world.shapes.shapes()[hit.primitive]);
        const bool taken = end && end->t == hit.t && end->object == name;
        if (taken) {
            result.starts_on_it = hit.primitive == leaving;
            derive_hit(world, hit.primitive, ray, hit.t, result);
        }
        result.along.push_back({std::move(name), hit.t, taken});
    }
    result.media = media_of(world.scene(), world, tree, node);
    return result;
}

}  // namespace raytree
