#include "accel/intersector.h"
#include "bodies.h"

namespace raytree::stress {
namespace {

/// A closed mesh, and a point inside it.
struct Hull {
    Scene scene;
    Point inside;
    double size = 1;

    const Mesh& mesh() const { return std::get<Mesh>(scene.objects[0].shape); }
};

Hull make_hull(Random& random) {
    Hull hull;
    hull.size = random.log_uniform(1e-6, 1e6);
    const double offset = random.chance(0.4) ? 0 : hull.size * random.log_uniform(1, 1e4);
    const Point center = offset * random.direction().vec();
    hull.inside = center + 0.05 * hull.size * random.in_cube();
    const std::size_t kind = random.below(4);
    Mesh mesh;
    if (kind < 2) {
        mesh = rough_ball(random, center, hull.size, 3, 0.4);
    } else if (kind == 2) {
        mesh = needle_fan(center, hull.size, 2000, 0.3 * hull.size);
    } else {
        mesh = sliver_ball(center, hull.size, 400);
    }
    add(hull.scene, std::move(mesh));
    if (kind == 1) {
        const Point there = center + offset * random.in_cube();
        hull.scene.objects[0].transform = stretched(random, 1, 4, there);
        const Affine& m = *hull.scene.objects[0].transform;
        Point inside;
        for (int k = 0; k < 3; ++k) {
            const auto& row = m[static_cast<std::size_t>(k)];
            inside[k] = row[0] * center.x + row[1] * center.y + row[2] * center.z + row[3];
        }
        hull.inside = inside;
    }
    return hull;
}

/// A point of an edge, as exactly as doubles have it: more often than not a vertex.
Point target(Random& random, const Hull& hull) {
    const Mesh::Triangle& t = hull.mesh().triangles[random.below(hull.mesh().triangles.size())];
    const auto at = [&](std::size_t corner) {
        return hull.mesh().vertices[static_cast<std::size_t>(t[corner].vertex)];
    };
    const std::size_t corner = random.below(3);
    Point p = at(corner);
    if (random.chance(0.5)) {
        p += (random.chance(0.3) ? 0.5 : random.uniform(0, 1)) * (at((corner + 1) % 3) - p);
    }
    if (hull.scene.objects[0].transform) {
        const Affine& m = *hull.scene.objects[0].transform;
        const Point own = p;
        for (int k = 0; k < 3; ++k) {
            const auto& row = m[static_cast<std::size_t>(k)];
            p[k] = row[0] * own.x + row[1] * own.y + row[2] * own.z + row[3];
        }
    }
    return p;
}

/// A ray that must meet the mesh.
struct Line {
    Point eye, at;
};

/// From inside through a point of an edge; or from outside, along an axis, through a vertex: what
/// no rounding of the direction keeps from passing through it exactly.
Line any_line(Random& random, const Hull& hull) {
    if (hull.scene.objects[0].transform || random.chance(0.75)) {
        return {hull.inside, target(random, hull)};
    }
    const Mesh& mesh = hull.mesh();
    const Point vertex = mesh.vertices[random.below(mesh.vertices.size())];
    Point eye = vertex;
    const int axis = static_cast<int>(random.below(3));
    eye[axis] += (random.chance(0.5) ? 5 : -5) * hull.size;
    return {eye, vertex};
}

template <class T>
void shoot(const Intersector<T>& shapes, const Hull& hull, const Line& line, Tally& tally) {
    const Vec3<T> eye = vector_cast<T>(line.eye);
    const Vec3<T> at = vector_cast<T>(line.at);
    const Vec3<T> way = at - eye;
    if (!(largest_component(way) > 0)) {
        return;
    }
    const Ray<T> ray{eye, UnitVec3<T>::of(way).vec(), T(0)};
    NoTestCount count;
    if (!shapes.any(ray, no_primitive, {}, count)) {
        ++tally.in<T>().wrong;
        tally.describe<T>([&](std::ostream& out) {
            out << "a mesh of " << hull.mesh().triangles.size() << " triangles, size " << hull.size
                << ", from " << line.eye << " towards " << line.at;
        });
    }
}

Tally run(Random& random, std::uint64_t trials) {
    Tally tally;
    const Hull hull = make_hull(random);
    const Intersector<double> in_double(hull.scene);
    const auto in_float = if_accepted<Intersector<float>>(hull.scene);
    for (; tally.trials < trials; ++tally.trials) {
        const Line line = any_line(random, hull);
        shoot(in_double, hull, line, tally);
        if (in_float) {
            shoot(*in_float, hull, line, tally);
        }
    }
    return tally;
}

}  // namespace

Row meshes() {
    return {"meshes",
            "closed meshes (rough balls, fans of 4,000 needles, slivers) up to 10^4 sizes from the "
            "origin, aimed at through vertices and edges from inside, and from outside exactly "
            "through vertices",
            "rays",
            "no ray leaks out",
            "",
            20'000,
            100'000'000,
            10'000,
            run};
}

}  // namespace raytree::stress
