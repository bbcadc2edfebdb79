#include "accel/lecture_hierarchy.h"

#include <doctest/doctest.h>

#include <random>

#include "formats/scene_file.h"

using namespace raytree;

namespace {

/// Balls, triangles and a large floor, at random places.
Scene crowd(unsigned seed, int count) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-5, 5), size(0.05, 0.6);
    Scene scene;
    scene.materials.push_back({});
    const auto add = [&](Shape shape) {
        Object object;
        object.name = "object" + std::to_string(scene.objects.size());
        object.shape = std::move(shape);
        scene.objects.push_back(std::move(object));
    };
    for (int k = 0; k < count; ++k) {
        const Point at{place(random), place(random), place(random)};
        if (k % 2 == 0) {
            add(Sphere{at, size(random)});
        } else {
            const auto corner = [&] {
                return at + Point{size(random), size(random), size(random)};
            };
            add(Polygon{{corner(), corner(), corner()}, {}});
        }
    }
    add(Polygon{{{-9, -5, 9}, {9, -5, 9}, {9, -5, -9}, {-9, -5, -9}}, {}});
    return scene;
}

Ray<double> random_ray(std::mt19937& random) {
    std::uniform_real_distribution<double> place(-7, 7);
    std::uniform_int_distribution<int> axis(-1, 2);
    Ray<double> ray{{place(random), place(random), place(random)}, {}, 0};
    Vec3<double> direction{place(random), place(random), place(random)};
    if (const int zero = axis(random); zero >= 0) {
        direction[zero] = 0;  // parallel to boxes' sides
    }
    ray.direction = UnitVec3<double>::of(direction).vec();
    return ray;
}

bool operator==(const Hit<double>& a, const Hit<double>& b) {
    return a.t == b.t && a.primitive == b.primitive;
}

constexpr LectureKind kinds[] = {LectureKind::brute_force, LectureKind::spheres, LectureKind::boxes,
                                 LectureKind::octree};

}  // namespace

TEST_CASE("the lecture's hierarchies find the same hits as the production one") {
    const Scene scene = crowd(7, 150);
    const Intersector<double> production(scene);
    std::mt19937 random(11);
    for (const LectureKind kind : kinds) {
        const LectureIntersector lecture(kind, production.shapes());
        LectureCount count;
        NoTestCount none;
        for (int k = 0; k < 400; ++k) {
            const Ray<double> ray = random_ray(random);
            const Interval<double> interval{0, k % 3 == 0 ? 4.0 : Real<double>::infinity};
            const auto expected = production.closest(ray, no_primitive, interval, none);
            const auto found = lecture.closest(ray, no_primitive, interval, count);
            REQUIRE(expected.has_value() == found.has_value());
            CHECK((!expected || *expected == *found));
            CHECK(lecture.any(ray, no_primitive, interval, count) == expected.has_value());
            const auto all = production.all(ray, no_primitive, interval, none);
            const auto all_found = lecture.all(ray, no_primitive, interval, count);
            CHECK(std::equal(all.begin(), all.end(), all_found.begin(), all_found.end(),
                             [](const auto& a, const auto& b) { return a == b; }));
        }
    }
}

TEST_CASE("a hierarchy spares tests, and brute force tests every shape once") {
    const Scene scene = crowd(3, 300);
    const ShapeSet<double> shapes(scene);
    std::mt19937 random(5);
    LectureCount counts[4];
    for (int k = 0; k < 200; ++k) {
        const Ray<double> ray = random_ray(random);
        for (std::size_t kind = 0; kind < 4; ++kind) {
            const LectureIntersector lecture(kinds[kind], shapes);
            lecture.closest(ray, no_primitive, {}, counts[kind]);
        }
    }
    CHECK(counts[0].shapes == 200 * shapes.size());
    CHECK(counts[0].volumes == 0);
    for (std::size_t kind = 1; kind < 4; ++kind) {
        CHECK(counts[kind].shapes < counts[0].shapes / 5);
        CHECK(counts[kind].volumes > 0);
    }
}

TEST_CASE("every shape is in a leaf, and within each volume above it") {
    const Scene scene = crowd(9, 80);
    const ShapeSet<double> shapes(scene);
    for (const LectureKind kind : {LectureKind::spheres, LectureKind::boxes}) {
        const LectureIntersector lecture(kind, shapes);
        const auto& nodes = lecture.hierarchy().nodes();
        std::vector<int> seen(shapes.size());
        for (const auto& node : nodes) {
            for (const PrimitiveId item : node.items) {
                ++seen[item];
            }
        }
        CHECK(std::ranges::all_of(seen, [](int n) { return n == 1; }));
        CHECK(nodes[0].depth == 0);
    }
}

TEST_CASE("the replay of a ray tells each volume and ends with the closest hit") {
    const Scene scene = crowd(21, 60);
    const ShapeSet<double> shapes(scene);
    std::mt19937 random(2);
    for (const LectureKind kind : kinds) {
        const LectureIntersector lecture(kind, shapes);
        for (int k = 0; k < 50; ++k) {
            const Ray<double> ray = random_ray(random);
            LectureCount count;
            const auto closest = lecture.closest(ray, no_primitive, {}, count);
            const auto steps = lecture.replay(ray, no_primitive, {});
            std::size_t volumes = 0, tested = 0;
            for (const auto& step : steps) {
                volumes += step.tested.empty() ? 1 : 0;
                tested += step.tested.size();
            }
            CHECK(volumes == count.volumes);
            CHECK(tested == count.shapes);
            if (closest) {
                REQUIRE(steps.back().nearest.has_value() == true);
                CHECK(*steps.back().nearest == *closest);
            }
        }
    }
}

TEST_CASE("a ray passes a box and a sphere where geometry says") {
    const Box box{{-1, -1, -1}, {1, 1, 1}};
    const VolumePassage through = pass(box, {-3, 0, 0}, {1, 0, 0});
    CHECK(through.enter == doctest::Approx(2));
    CHECK(through.leave == doctest::Approx(4));
    CHECK(!pass(box, {-3, 2, 0}, {1, 0, 0}).met());
    const VolumePassage ball = pass(BoundingSphere{{0, 0, 0}, 2}, {-3, 0, 0}, {1, 0, 0});
    CHECK(ball.enter == doctest::Approx(1));
    CHECK(ball.leave == doctest::Approx(5));
    CHECK(!pass(BoundingSphere{{0, 0, 0}, 2}, {-3, 2.1, 0}, {1, 0, 0}).met());
}
