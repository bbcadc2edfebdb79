#include "accel/kernels.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "accel/growing_hierarchy.h"
#include "accel/intersector.h"
#include "accel/space_between.h"
#include "support/scenes.h"

using namespace raytree;

namespace {

/// A scene's shapes and what the kernels search them with.
struct Subject {
    explicit Subject(const Scene& scene)
        : shapes(scene), searched(searched_of(shapes)), growing(shapes) {}
    ShapeSet<double> shapes;
    Searched searched;
    GrowingHierarchy growing;
};

Hit<double> brute_force(const ShapeSet<double>& shapes, const Query<double>& query) {
    Hit<double> best{Real<double>::infinity, no_primitive};
    for (PrimitiveId id = 0; id < shapes.size(); ++id) {
        const auto roots = shapes.intersect(id, query.ray, query.leaving);
        for (std::size_t k = 0; k < static_cast<std::size_t>(roots.count); ++k) {
            const Hit<double> hit{roots.t[k], id};
            best = query.interval.contains(hit.t) && hit < best ? hit : best;
        }
    }
    return best.primitive == no_primitive ? Hit<double>{} : best;
}

/// What grows where its rays go gives what brute force gives, to the last bit.
void check_growing(const Subject& s, const std::vector<Query<double>>& queries,
                   const std::vector<Hit<double>>& expected) {
    std::size_t differ = 0;
    for (std::size_t k = 0; k < queries.size(); ++k) {
        const Hit<double> hit = s.growing.closest(queries[k], nullptr);
        const bool met = expected[k].primitive != no_primitive;
        differ += hit.primitive != expected[k].primitive || hit.t != expected[k].t ? 1 : 0;
        differ += (s.growing.any(queries[k], nullptr) != no_primitive) != met ? 1 : 0;
    }
    CHECK(differ == 0);
}

/// How many instruction sets that the processor has say that something may lie between the queries.
std::size_t may_meet(const WideBvh& bvh, Kernels::Queries queries) {
    std::size_t count = plain::may_meet_between(bvh, queries) ? 1 : 0;
#if defined(__x86_64__) && defined(__GNUC__)
    if (runnable_kernels().size() > 1) {
        count += avx2::may_meet_between(bvh, queries) ? 1 : 0;
    }
    if (runnable_kernels().size() > 2) {
        count += avx512::may_meet_between(bvh, queries) ? 1 : 0;
    }
#endif
    return count;
}

/// Every way to ask gives what brute force gives, to the last bit.
void check_all(const Scene& scene, const std::vector<Query<double>>& queries) {
    const Subject s(scene);
    std::vector<Hit<double>> expected;
    for (const auto& query : queries) {
        expected.push_back(brute_force(s.shapes, query));
    }
    check_growing(s, queries, expected);
    for (const Kernels* kernels : runnable_kernels()) {
        CAPTURE(kernels == &plain_kernels);
        std::vector<Hit<double>> each(queries.size()), packets(queries.size());
        std::vector<std::uint8_t> any_each(queries.size()), any_packets(queries.size());
        kernels->closest_of_each(s.searched, queries, each);
        kernels->closest_in_packets(s.searched, queries, packets);
        kernels->any_of_each(s.searched, queries, any_each);
        kernels->any_in_packets(s.searched, queries, any_packets);
        std::size_t differ = 0;
        for (std::size_t k = 0; k < queries.size(); ++k) {
            std::size_t tests = 0;
            Hit<double> one = kernels->closest(s.searched, queries[k], &tests);
            one = one.primitive == no_primitive ? Hit<double>{} : one;
            const bool met = expected[k].primitive != no_primitive;
            for (const Hit<double>& hit : {one, each[k], packets[k]}) {
                differ += hit.primitive != expected[k].primitive || hit.t != expected[k].t ? 1 : 0;
            }
            differ +=
                (kernels->any(s.searched, queries[k], nullptr) != no_primitive) != met ? 1 : 0;
            differ += (any_each[k] != 0) != met || (any_packets[k] != 0) != met ? 1 : 0;
        }
        CHECK(differ == 0);
    }
    for (std::size_t first = 0; first < queries.size(); first += 16) {
        const std::size_t count = std::min<std::size_t>(16, queries.size() - first);
        const auto met = [](const Hit<double>& hit) { return hit.primitive != no_primitive; };
        if (std::ranges::any_of(std::span(expected).subspan(first, count), met)) {
            CHECK(may_meet(s.searched.bvh, std::span(queries).subspan(first, count)) ==
                  runnable_kernels().size());
        }
    }
}

class Rays {
  public:
    Rays(unsigned seed, double reach, const Point& center)
        : random_(seed), reach_(reach), center_(center) {}

    Point point() { return {uniform_(random_), uniform_(random_), uniform_(random_)}; }

    /// Some towards each other's neighbourhood, some along an axis, some cut short.
    std::vector<Query<double>> any_order(std::size_t count) {
        std::vector<Query<double>> queries(count);
        for (std::size_t k = 0; k < count; ++k) {
            Point direction = point();
            if (k % 5 == 0) {
                direction[static_cast<int>(k % 3)] = 0;
            }
            queries[k].ray = {center_ + reach_ * point(), UnitVec3<double>::of(direction).vec(), 0};
            if (k % 4 == 0) {
                queries[k].interval = {0.1 * reach_, reach_};
            }
        }
        return queries;
    }

    /// From one point in nearly one direction, which goes across all octants.
    std::vector<Query<double>> coherent(std::size_t count, const Point& eye, double angle) {
        std::vector<Query<double>> queries(count);
        for (Query<double>& query : queries) {
            const Point towards = center_ - eye + angle * reach_ * point();
            query.ray = {eye, UnitVec3<double>::of(towards).vec(), 0};
        }
        return queries;
    }

  private:
    std::mt19937_64 random_;
    std::uniform_real_distribution<double> uniform_{-1, 1};
    double reach_;
    Point center_;
};

void check_scene(const Scene& scene, double reach, const Point& center) {
    Rays rays(3, reach, center);
    check_all(scene, rays.any_order(203));
    check_all(scene, rays.coherent(100, center + Point(0, 0, 3 * reach), 0.3));
    check_all(scene, rays.coherent(50, center + Point(1e4 * reach, 20, 0), 0.3));
    check_all(scene, rays.coherent(50, center + Point(0.01 * reach, 0, 0), 2));
}

/// A closed ball of triangles about `center`; coordinates are floats if asked for.
Mesh ball(const Point& center, double radius, bool floats) {
    Mesh mesh;
    constexpr int columns = 24, rows = 12;
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const double a = 6.283185307179586 * i / columns, b = 3.141592653589793 * j / rows;
            const Point p = center + radius * Point(std::sin(b) * std::cos(a),
                                                    std::sin(b) * std::sin(a), std::cos(b));
            mesh.vertices.push_back(floats ? vector_cast<double>(vector_cast<float>(p)) : p);
        }
    }
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const int a = j * columns + i, b = j * columns + (i + 1) % columns;
            mesh.triangles.push_back({{{a}, {b}, {b + columns}}});
            mesh.triangles.push_back({{{a}, {b + columns}, {a + columns}}});
        }
    }
    return mesh;
}

}  // namespace

TEST_CASE("kernels: every one of them finds what brute force finds, at every scale and offset") {
    for (const double scale : {1e-9, 1.0, 1e9}) {
        for (const double offset : {0.0, 1e3, 1e8}) {
            CAPTURE(scale);
            CAPTURE(offset);
            const Point center(offset * scale);
            check_scene(test::random_shapes(300, 11, scale, center), 2 * scale, center);
        }
    }
}

TEST_CASE("kernels: meshes whose vertices are floats, and whose are not") {
    for (const bool floats : {true, false}) {
        for (const double offset : {0.0, 3.0, 1e5}) {
            CAPTURE(floats);
            CAPTURE(offset);
            Scene scene;
            scene.materials.push_back({});
            test::add(scene, ball(Point(offset), 1, floats));
            test::add(scene, ball(Point(offset + 0.5), 0.01, floats));
            test::add(scene, Sphere{Point(offset - 0.5), 0.2});
            check_scene(scene, 1.5, Point(offset));
        }
    }
}

TEST_CASE("kernels: rays at the vertices and edges of a closed mesh all meet it") {
    Scene scene;
    scene.materials.push_back({});
    test::add(scene, ball({0.3, 0.2, 0.1}, 1, false));
    const Mesh& mesh = std::get<Mesh>(scene.objects[0].shape);
    const Subject s(scene);
    std::vector<Query<double>> queries;
    for (const Mesh::Triangle& triangle : mesh.triangles) {
        for (const double share : {0.0, 0.5, 0.37}) {
            const Point a = mesh.vertices[static_cast<std::size_t>(triangle[0].vertex)];
            const Point b = mesh.vertices[static_cast<std::size_t>(triangle[1].vertex)];
            const Point inside(0.31, 0.17, 0.12);
            const Point aim = a + share * (b - a);
            queries.push_back(
                {{inside, UnitVec3<double>::of(aim - inside).vec(), 0}, no_primitive, {}});
        }
    }
    for (const Kernels* kernels : runnable_kernels()) {
        std::vector<Hit<double>> hits(queries.size());
        std::vector<std::uint8_t> met(queries.size());
        kernels->closest_of_each(s.searched, queries, hits);
        kernels->any_in_packets(s.searched, queries, met);
        CHECK(std::count(met.begin(), met.end(), 0) == 0);
        CHECK(std::count_if(hits.begin(), hits.end(), [](const Hit<double>& hit) {
                  return hit.primitive == no_primitive;
              }) == 0);
    }
}

TEST_CASE("kernels: rays that start or end just before, on and just behind what they meet") {
    for (const bool floats : {true, false}) {
        CAPTURE(floats);
        Scene scene = test::random_shapes(200, 7, 1, Point(0.0));
        test::add(scene, ball({0.4, 0.1, 0}, 0.5, floats));
        test::add(scene, ball({-0.4, 0.1, 0.2}, 0.01, floats));
        const Subject s(scene);
        Rays rays(9, 1.5, Point(0.0));
        std::vector<Query<double>> queries;
        for (const Query<double>& query : rays.any_order(150)) {
            const Hit<double> hit = brute_force(s.shapes, query);
            if (hit.primitive == no_primitive) {
                continue;
            }
            for (const double off : {0.0, 1e-15, 1e-12, 1e-9, 1e-7, 1e-6, 1e-5, 1e-3}) {
                for (const double t : {hit.t * (1 - off), hit.t * (1 + off)}) {
                    Query<double> from = query, to = query;
                    from.ray.origin = along(query.ray.origin, t, query.ray.direction);
                    to.interval.to = t;
                    queries.insert(queries.end(), {from, to});
                    from.leaving = hit.primitive;
                    queries.push_back(from);
                }
            }
        }
        check_all(scene, queries);
    }
}

TEST_CASE("kernels: rays in the planes of triangles, and nearly so") {
    Scene scene;
    scene.materials.push_back({});
    test::add(scene, ball({0, 0, 0}, 1, true));
    const Subject s(scene);
    std::vector<Query<double>> queries;
    for (PrimitiveId id = 0; id < s.shapes.size(); id += 3) {
        const auto& [a, b, c] = s.shapes.triangle(s.shapes[id]).vertices;
        const Point normal = outer<double>(b - a, c - a);
        if (length(normal) == 0) {
            continue;
        }
        for (const double tilt : {0.0, 1e-16, 1e-9, 1e-7, 1e-6, 1e-4}) {
            const Point direction = (b + c) / 2.0 - a + tilt * normal / length(normal);
            const auto d = UnitVec3<double>::of(direction).vec();
            queries.push_back({{a - 2.0 * d, d, 0}, no_primitive, {}});
            queries.push_back({{a + 0.3 * direction, d, 0}, no_primitive, {}});
        }
    }
    check_all(scene, queries);
}

TEST_CASE("kernels: narrow bundles of rays, most of which meet little or nothing") {
    for (const double scale : {1.0, 1e-7, 1e7}) {
        for (const Point& center : {Point(0.0), scale * Point(3e3, -2e5, 1e4)}) {
            CAPTURE(scale);
            Scene scene = test::random_shapes(12, 5, scale, center);
            const auto corner = [&](double x, double y) {
                return center + scale * Point(x, y, -1.5);
            };
            test::add(scene,
                      Polygon{{corner(-9, -9), corner(9, -9), corner(9, 9), corner(-9, 9)}, {}});
            const auto floor = static_cast<PrimitiveId>(scene.objects.size() - 1);
            Rays rays(8, scale, center);
            std::vector<Query<double>> queries;
            for (int bundle = 0; bundle < 300; ++bundle) {
                const Point from = center + scale * 3.0 * rays.point();
                const Point light = center + scale * 6.0 * rays.point();
                // From points of the floor to a light, from one point, along one axis.
                for (int k = 0; k < 16; ++k) {
                    Query<double> query;
                    const Point near = from + scale * 0.02 * rays.point();
                    Point towards = center + scale * 0.1 * rays.point() - from;
                    if (bundle % 3 == 0) {
                        query.ray.origin = {near.x, near.y, corner(0, 0).z};
                        towards = light - query.ray.origin;
                        query.leaving = floor;
                        query.ray.going = towards.z > 0 ? Going::outwards : Going::inwards;
                        query.interval.to = length(towards);
                    } else if (bundle % 3 == 1) {
                        query.ray.origin = from;
                    } else {
                        query.ray.origin = near;
                        towards = Point(0.0);
                        towards[bundle / 3 % 3] = bundle % 2 == 0 ? 1 : -1;
                    }
                    query.ray.direction = UnitVec3<double>::of(towards).vec();
                    queries.push_back(query);
                }
            }
            check_all(scene, queries);
        }
    }
}

TEST_CASE("kernels: nothing lies between rays that pass beside every shape or away from it") {
    Scene scene;
    test::add(scene, Sphere{{0, 0, 0}, 1});
    test::add(scene, Cone{{4, 0, -1}, {4, 0, 1}, 0.5, 0.25});
    test::add(scene, ball({-4, 0, 0}, 1, true));
    const Subject subject(scene);
    const auto between = [&](const Point& eye, const Point& low, const Point& high) {
        const std::vector<Query<double>> queries = {{{eye, low - eye, 0}, no_primitive, {}},
                                                    {{eye, high - eye, 0}, no_primitive, {}}};
        return may_meet(subject.searched.bvh, queries);
    };
    const Point eye(0, -8, 0);
    const std::size_t all = runnable_kernels().size();
    CHECK(between(eye, {-0.1, 0, -0.1}, {0.1, 0, 0.1}) == all);
    CHECK(between(eye, {3.9, 0, -0.1}, {4.1, 0, 0.1}) == all);
    CHECK(between(eye, {-4.1, 0, -0.1}, {-3.9, 0, 0.1}) == all);
    CHECK(between(eye, {1.5, 0, -0.1}, {9, 0, 0.1}) == all);
    CHECK(between(eye, {-9, 0, 1.5}, {9, 0, 3}) == 0);
    CHECK(between(eye, {-1, -16, -1}, {1, -16, 1}) == 0);
    CHECK(plain::may_meet_between(WideBvh(), {}) == false);
}

TEST_CASE("kernels: no queries, few queries, and a scene without shapes") {
    Rays rays(1, 1, Point(0.0));
    Scene scene;
    scene.materials.push_back({});
    check_all(scene, rays.any_order(20));
    test::add(scene, Sphere{{0, 0, 0}, 1});
    check_all(scene, {});
    check_all(scene, rays.any_order(1));
    check_all(scene, rays.any_order(17));
}

TEST_CASE("kernels: shapes that all but coincide, in a scene that is much larger") {
    Scene scene;
    scene.materials.push_back({});
    for (int k = 0; k < 40; ++k) {
        test::add(scene, Sphere{Point(k * 3e-41, 0, 0), 1e-41});
    }
    test::add(scene, Sphere{{0, 0, 0}, 1});
    check_scene(scene, 2, Point(0.0));
}

TEST_CASE("kernels: a shape's copies give it back to the last bit") {
    for (const bool floats : {true, false}) {
        Scene scene;
        scene.materials.push_back({});
        test::add(scene, ball({0.1, 0, 2}, 1, floats));
        test::add(scene, Sphere{{0.1, 0.25, 2}, 0.1});
        test::add(scene, Cone{{0.1, 0.2, 0.3}, {0.5, 0.6, 2}, 0.1, 0.2});
        const Subject s(scene);
        s.searched.bvh.for_each_leaf([&](WideBvh::Ref leaf) {
            for (std::size_t lane = 0; lane < leaf.count(); ++lane) {
                const Primitive shape = s.shapes[s.searched.bvh.items()[leaf.first() + lane]];
                if (leaf.kind() == LeafFilter::triangle) {
                    CHECK(s.searched.filter.triangle_of(leaf, lane).vertices ==
                          s.shapes.triangle(shape).vertices);
                } else if (leaf.kind() == LeafFilter::sphere) {
                    CHECK(s.searched.filter.sphere_of(leaf, lane).center ==
                          s.shapes.sphere(shape).center);
                    CHECK(s.searched.filter.sphere_of(leaf, lane).radius ==
                          s.shapes.sphere(shape).radius);
                } else {
                    CHECK(s.searched.filter.cone_of(leaf, lane).base == s.shapes.cone(shape).base);
                    CHECK(s.searched.filter.cone_of(leaf, lane).slope ==
                          s.shapes.cone(shape).slope);
                }
            }
        });
    }
}
