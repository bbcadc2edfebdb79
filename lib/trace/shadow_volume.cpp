#include "trace/shadow_volume.h"

#include <algorithm>
#include <glm/common.hpp>
#include <map>

namespace raytree {
namespace {

using Vec = Vec3<double>;
using Outline = std::vector<Vec>;

Vec in_world(const Object& object, const Vec& p) {
    if (!object.transform) {
        return p;
    }
    Vec result;
    for (int row = 0; row < 3; ++row) {
        const auto& m = (*object.transform)[static_cast<std::size_t>(row)];
        result[row] = m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3];
    }
    return result;
}

/// Newell's normal, of any length.
Vec normal_of(const Outline& outline) {
    Vec normal(0.0);
    for (std::size_t k = 0, j = outline.size() - 1; k < outline.size(); j = k++) {
        normal += outer(outline[j] - outline[0], outline[k] - outline[0]);
    }
    return normal;
}

Vec towards_light(const ShadowVolumes& volumes, const Vec& p) {
    return volumes.directional ? volumes.light : Vec(volumes.light - p);
}

/// Over 0 where the outline runs counter-clockwise as seen from the light.
double facing(const ShadowVolumes& volumes, const Outline& outline) {
    return inner(normal_of(outline), towards_light(volumes, outline[0]));
}

/// The walls that remain when edges shared by two outlines that face the light are taken out: the
/// silhouette.
void add_outlines(const std::vector<Outline>& outlines, ShadowVolume& volume) {
    const auto key = [](const Vec& p) { return std::array{p.x, p.y, p.z}; };
    using Key = std::array<double, 3>;
    std::map<std::pair<Key, Key>, int> edges;
    for (const Outline& outline : outlines) {
        for (std::size_t k = 0, j = outline.size() - 1; k < outline.size(); j = k++) {
            const auto back = edges.find({key(outline[k]), key(outline[j])});
            if (back != edges.end() && back->second > 0) {
                --back->second;
            } else {
                ++edges[{key(outline[j]), key(outline[k])}];
            }
        }
    }
    for (const auto& [edge, count] : edges) {
        for (int k = 0; k < count; ++k) {
            const auto point = [](const Key& p) { return Vec(p[0], p[1], p[2]); };
            volume.walls.push_back({point(edge.first), point(edge.second)});
        }
    }
}

/// Turns an outline to the light; nothing is left of one that the light sees from its edge.
void turn(const ShadowVolumes& volumes, Outline outline, std::vector<Outline>& into) {
    const double side = facing(volumes, outline);
    if (side < 0) {
        std::ranges::reverse(outline);
    }
    if (side != 0) {
        into.push_back(std::move(outline));
    }
}

/// Whether every edge is shared by two triangles that run along it in opposite directions.
bool is_closed(const Mesh& mesh) {
    std::map<std::pair<int, int>, int> edges;
    for (const Mesh::Triangle& triangle : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            ++edges[{triangle[k].vertex, triangle[(k + 1) % 3].vertex}];
        }
    }
    return std::ranges::all_of(edges, [&](const auto& edge) {
        const auto back = edges.find({edge.first.second, edge.first.first});
        return edge.second == 1 && back != edges.end() && back->second == 1;
    });
}

std::vector<Outline> outlines_of(const ShadowVolumes& volumes, const Object& object) {
    std::vector<Outline> outlines;
    if (const auto* polygon = std::get_if<Polygon>(&object.shape)) {
        Outline outline;
        for (const Point& vertex : polygon->vertices) {
            outline.push_back(in_world(object, vertex));
        }
        turn(volumes, std::move(outline), outlines);
    }
    if (const auto* mesh = std::get_if<Mesh>(&object.shape)) {
        const bool closed = is_closed(*mesh);
        for (const Mesh::Triangle& triangle : mesh->triangles) {
            Outline outline;
            for (const Mesh::Corner& corner : triangle) {
                outline.push_back(
                    in_world(object, mesh->vertices[static_cast<std::size_t>(corner.vertex)]));
            }
            // Of a closed mesh the sides that face the light hide all that the others hide.
            if (!closed || facing(volumes, outline) > 0) {
                turn(volumes, std::move(outline), outlines);
            }
        }
    }
    return outlines;
}

/// By the crossing rule, in the two axes that the normal is shortest along.
bool inside(const Outline& outline, const Vec& normal, const Vec& p) {
    const Vec size = glm::abs(normal);
    const int dropped = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int u = (dropped + 1) % 3;
    const int v = (dropped + 2) % 3;
    bool odd = false;
    for (std::size_t k = 0, j = outline.size() - 1; k < outline.size(); j = k++) {
        const Vec& a = outline[j];
        const Vec& b = outline[k];
        if ((a[v] > p[v]) != (b[v] > p[v]) &&
            p[u] < a[u] + (p[v] - a[v]) / (b[v] - a[v]) * (b[u] - a[u])) {
            odd = !odd;
        }
    }
    return odd;
}

/// Whether the way from `p` to the light goes through the cap.
bool hidden_by(const ShadowVolumes& volumes, const Outline& cap, const Vec& p) {
    const Vec normal = normal_of(cap);
    const Vec way = towards_light(volumes, p);
    const double speed = inner(normal, way);
    const double s = inner(normal, cap[0] - p) / speed;
    const bool between = s > 0 && (volumes.directional || s < 1);
    return speed != 0 && between && inside(cap, normal, p + s * way);
}

/// Where the ray goes through the wall, if it does.
std::optional<WallCrossing> cross(const ShadowVolumes& volumes, const VolumeWall& wall,
                                  const Ray<double>& ray) {
    const Vec edge = wall.b - wall.a;
    const Vec out = -towards_light(volumes, wall.a);  // from the light, along the wall
    const Vec normal = outer(out, edge);              // out of the volume
    const double speed = inner(normal, ray.direction);
    if (speed == 0) {
        return std::nullopt;
    }
    const double t = inner(normal, wall.a - ray.origin) / speed;
    const Vec p =
        along(ray.origin, t, ray.direction) - (volumes.directional ? wall.a : volumes.light);
    const Vec first = volumes.directional ? edge : Vec(wall.a - volumes.light);
    const Vec second = volumes.directional ? out : Vec(wall.b - volumes.light);
    // p = alpha first + beta second, in the wall's plane.
    const Vec across = outer(first, second);
    const double size = inner(across, across);
    const double alpha = inner(outer(p, second), across) / size;
    const double beta = inner(outer(first, p), across) / size;
    const bool on_wall = volumes.directional ? alpha >= 0 && alpha < 1 && beta >= 0
                                             : alpha >= 0 && beta > 0 && alpha + beta >= 1;
    return on_wall ? std::optional(WallCrossing{t, 0, speed < 0}) : std::nullopt;
}

}  // namespace

ShadowVolumes shadow_volumes(const World<double>& world, std::size_t light) {
    ShadowVolumes volumes;
    const WorldLight<double>& from = world.lights[light];
    volumes.directional = from.directional;
    volumes.light = from.directional ? from.towards : from.position;
    for (std::size_t k = 0; k < world.scene().objects.size(); ++k) {
        const Object& object = world.scene().objects[k];
        if (!std::holds_alternative<Polygon>(object.shape) &&
            !std::holds_alternative<Mesh>(object.shape)) {
            volumes.left_out.push_back(k);
            continue;
        }
        ShadowVolume volume;
        volume.object = k;
        volume.caps = outlines_of(volumes, object);
        add_outlines(volume.caps, volume);
        volumes.volumes.push_back(std::move(volume));
    }
    return volumes;
}

VolumeCount count_volumes(const ShadowVolumes& volumes, const Ray<double>& ray, double t) {
    VolumeCount count;
    count.start = volumes_around(volumes, ray.origin);
    for (std::size_t k = 0; k < volumes.volumes.size(); ++k) {
        for (const VolumeWall& wall : volumes.volumes[k].walls) {
            auto crossing = cross(volumes, wall, ray);
            if (crossing && crossing->t > 0 && crossing->t < t) {
                crossing->volume = k;
                count.crossings.push_back(*crossing);
            }
        }
    }
    std::ranges::sort(count.crossings, {}, &WallCrossing::t);
    count.end = count.start;
    for (const WallCrossing& crossing : count.crossings) {
        count.end += crossing.enters ? 1 : -1;
    }
    return count;
}

int volumes_around(const ShadowVolumes& volumes, const Vec3<double>& point) {
    int around = 0;
    for (const ShadowVolume& volume : volumes.volumes) {
        for (const Outline& cap : volume.caps) {
            around += hidden_by(volumes, cap, point) ? 1 : 0;
        }
    }
    return around;
}

Vec3<double> far_corner(const ShadowVolumes& volumes, const Vec3<double>& point, double reach) {
    return along(point, -reach, UnitVec3<double>::of(towards_light(volumes, point)).vec());
}

}  // namespace raytree
