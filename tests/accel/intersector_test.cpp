#include "accel/intersector.h"

#include <doctest/doctest.h>

#include <random>

#include "support/scenes.h"

using namespace raytree;

namespace {

/// What `closest` and `all` say, found by testing every shape.
std::vector<Hit<double>> brute_force(const ShapeSet<double>& shapes, const Ray<double>& ray,
                                     PrimitiveId leaving, Interval<double> interval) {
    std::vector<Hit<double>> hits;
    for (PrimitiveId id = 0; id < shapes.size(); ++id) {
        const auto roots = shapes.intersect(id, ray, leaving);
        for (std::size_t k = 0; k < static_cast<std::size_t>(roots.count); ++k) {
            if (roots.t[k] >= interval.from && roots.t[k] < interval.to) {
                hits.push_back({roots.t[k], id});
            }
        }
    }
    std::sort(hits.begin(), hits.end());
    return hits;
}

void check_same(const Scene& scene, unsigned seed, double reach, int rays) {
    const Intersector<double> intersector(scene);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    NoTestCount count;
    for (int k = 0; k < rays; ++k) {
        const auto point = [&] { return Point(uniform(random), uniform(random), uniform(random)); };
        Point direction = point();
        if (k % 5 == 0) {
            direction[k % 3] = 0;  // along the planes of the boxes
        }
        Ray<double> ray{reach * point(), UnitVec3<double>::of(direction).vec(), 0};
        PrimitiveId leaving = no_primitive;
        const auto start = intersector.closest(ray, no_primitive, {}, count);
        if (k % 3 == 0 && start) {  // go on from a surface, in a new direction
            leaving = start->primitive;
            ray.origin = intersector.shapes().surface_at(leaving, ray, start->t).point;
            ray.origin_error = 0x1p-51 * largest_component(ray.origin);
            ray.direction = UnitVec3<double>::of(point());
        }
        const Interval<double> interval{0, k % 4 == 0 ? reach : Real<double>::infinity};
        const auto expected = brute_force(intersector.shapes(), ray, leaving, interval);
        const auto all = intersector.all(ray, leaving, interval, count);
        const auto closest = intersector.closest(ray, leaving, interval, count);
        REQUIRE(all.size() == expected.size());
        for (std::size_t h = 0; h < all.size(); ++h) {
            CHECK(all[h].t == expected[h].t);
            CHECK(all[h].primitive == expected[h].primitive);
        }
        REQUIRE(closest.has_value() == !expected.empty());
        if (closest) {
            CHECK(closest->t == expected.front().t);
            CHECK(closest->primitive == expected.front().primitive);
        }
        CHECK(intersector.any(ray, leaving, interval, count) == !expected.empty());
    }
}

}  // namespace

TEST_CASE("intersector: the hierarchy finds what brute force finds, at every scale and offset") {
    for (const double scale : {1e-9, 1.0, 1e9}) {
        for (const double offset : {0.0, 1e3, 1e8}) {
            CAPTURE(scale);
            CAPTURE(offset);
            const Scene scene = test::random_shapes(300, 11, scale, Point(offset * scale));
            check_same(scene, 5, 3 * scale, 300);
        }
    }
}

TEST_CASE("intersector: from as far away as a scene's numbers go") {
    const Scene scene = test::random_shapes(300, 11, 1, Point(0.0));
    const Intersector<double> intersector(scene);
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    NoTestCount count;
    for (const double away : {1e7, 1e9, 1e11, 1e13, 1e15, 1e16, 1e17, 1e20, 1e36, 1e60, 1e150}) {
        CAPTURE(away);
        for (int k = 0; k < 200; ++k) {
            const auto point = [&] {
                return Point(uniform(random), uniform(random), uniform(random));
            };
            const Point aim = point();
            Point eye = away * UnitVec3<double>::of(point()).vec();
            if (k % 2 == 0) {  // on an axis, where a ray from any distance can be aimed
                eye = Point(0.0);
                eye[k % 3] = away;
            }
            const Point way = k % 2 == 0 ? -eye : aim - eye;
            const Ray<double> ray{eye, UnitVec3<double>::of(way).vec(), 0};
            const auto expected = brute_force(intersector.shapes(), ray, no_primitive, {});
            const auto all = intersector.all(ray, no_primitive, {}, count);
            const auto closest = intersector.closest(ray, no_primitive, {}, count);
            REQUIRE(all.size() == expected.size());
            REQUIRE(closest.has_value() == !expected.empty());
            if (closest) {
                CHECK(closest->t == expected.front().t);
                CHECK(closest->primitive == expected.front().primitive);
            }
        }
    }
}

TEST_CASE("intersector: coincident, nested and flat shapes") {
    Scene scene;
    scene.materials.push_back({});
    for (int k = 0; k < 100; ++k) {
        test::add(scene, Sphere{{0, 0, 0}, 1});
        test::add(scene, Sphere{{0, 0, 0}, 1.0 / (k + 1)});
        test::add(scene, Polygon{{{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}}, {}});
        test::add(scene, Polygon{{{-1, -1, 0.5}, {1, -1, 0.5}, {0, 1, 0.5}}, {}});
    }
    check_same(scene, 3, 2, 300);
}

TEST_CASE("intersector: of equal t the first object wins") {
    Scene scene;
    scene.materials.push_back({});
    for (int k = 0; k < 50; ++k) {
        test::add(scene, Sphere{{0, 0, 0}, 1});
    }
    NoTestCount count;
    const Intersector<double> intersector(scene);
    const auto hit = intersector.closest({{0, 0.1, 5}, {0, 0, -1}, 0}, no_primitive, {}, count);
    REQUIRE(hit);
    CHECK(hit->primitive == 0);
}

TEST_CASE("intersector: an empty scene is met by nothing") {
    const Intersector<double> intersector{Scene()};
    TestCount count;
    CHECK_FALSE(intersector.closest({{0, 0, 0}, {0, 0, -1}, 0}, no_primitive, {}, count));
    CHECK(count.tests == 0);
}

TEST_CASE("intersector: the hierarchy spares most tests") {
    const Scene scene = test::random_shapes(10'000, 4, 1, Point(0.0));
    const Intersector<double> intersector(scene);
    TestCount count;
    for (int k = 0; k < 100; ++k) {
        const Ray<double> ray{{0, 0, 3}, UnitVec3<double>::of({0.01 * k - 0.5, 0.1, -1}).vec(), 0};
        intersector.closest(ray, no_primitive, {}, count);
    }
    CHECK(count.tests < 100 * 500);
}

TEST_CASE("intersector: shapes closer together than a float's inverse, in a scene far larger") {
    Scene scene;  // building its hierarchy ran out of its bins before
    scene.materials.push_back({});
    for (int k = 0; k < 20; ++k) {
        test::add(scene, Sphere{{0, 0, 1e-40 * k}, 1e-41});
    }
    test::add(scene, Sphere{{1e5, 0, 0}, 1});
    const Intersector<double> intersector(scene);
    NoTestCount count;
    const Ray<double> ray{{0, 0, -1}, {0, 0, 1}, 0};
    const auto hit = intersector.closest(ray, no_primitive, {}, count);
    REQUIRE(hit);
    CHECK(hit->primitive == 0);
}

TEST_CASE("intersector: built where rays go, it answers as the whole does, and becomes it") {
    const Scene scene = test::random_shapes(12'000, 4, 1, Point(3.0));
    const Intersector<double> whole(scene);
    const Intersector<double> growing(scene, Build::where_rays_go);
    std::vector<Query<double>> queries(200);
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto point = [&] { return Point(uniform(random), uniform(random), uniform(random)); };
    for (Query<double>& query : queries) {
        query.ray = {Point(3.0) + 2.0 * point(), UnitVec3<double>::of(point()).vec(), 0};
    }
    NoTestCount count;
    const auto compare = [&] {
        for (const auto& [ray, leaving, interval] : queries) {
            const auto expected = whole.closest(ray, leaving, interval, count);
            const auto hit = growing.closest(ray, leaving, interval, count);
            REQUIRE(hit.has_value() == expected.has_value());
            CHECK((!hit || (hit->t == expected->t && hit->primitive == expected->primitive)));
            CHECK(growing.any(ray, leaving, interval, count) == expected.has_value());
            const auto all = growing.all(ray, leaving, interval, count);
            const auto all_expected = whole.all(ray, leaving, interval, count);
            CHECK(std::ranges::equal(all, all_expected, [](const auto& a, const auto& b) {
                return a.t == b.t && a.primitive == b.primitive;
            }));
        }
    };
    compare();
    CHECK(growing.hierarchy().node_count() == whole.hierarchy().node_count());
    compare();
}

TEST_CASE("growing hierarchy: it grows where rays go, and nowhere else") {
    const Scene scene = test::random_shapes(20'000, 4, 1, Point(0.0));
    const ShapeSet<double> shapes(scene);
    const GrowingHierarchy growing(shapes);
    CHECK(growing.cells() > 100);
    CHECK(growing.grown() == 0);
    growing.closest({{{0, 0, 5}, {0, 0, 1}, 0}, no_primitive, {}}, nullptr);
    CHECK(growing.grown() == 0);
    growing.closest({{{0, 0, 5}, {0, 0, -1}, 0}, no_primitive, {}}, nullptr);
    CHECK(growing.grown() > 0);
    CHECK(growing.grown() < growing.cells() / 10);
}

TEST_CASE("growing hierarchy: no shapes, one, and many in one place") {
    Scene scene;
    scene.materials.push_back({});
    const Query<double> query{{{0, 0, 5}, {0, 0, -1}, 0}, no_primitive, {}};
    for (const int count : {0, 1, 3000}) {
        while (scene.objects.size() < static_cast<std::size_t>(count)) {
            test::add(scene, Sphere{{0, 0, 0}, 1});
        }
        const ShapeSet<double> shapes(scene);
        const GrowingHierarchy growing(shapes);
        CHECK((growing.any(query, nullptr) != no_primitive) == (count > 0));
        CHECK(growing.closest(query, nullptr).primitive == (count > 0 ? 0 : no_primitive));
    }
}
