#include "tree/error_bounds.h"

#include <doctest/doctest.h>

#include "folders.h"
#include "formats/scene_file.h"
#include "support/scenes.h"
#include "support/tree_comparison.h"
#include "tree/record.h"

using namespace raytree;

namespace {

using Vec = Vec3<double>;

/// What came of all pixels of a scene.
struct Verdicts {
    int wrong = 0, undecided = 0;
    std::string first;
};

Verdicts compare_all(const Scene& scene) {
    const World<double> own(scene);
    const World<Quad> reference(scene);
    Verdicts verdicts;
    for (int j = 0; j < scene.camera.height; ++j) {
        for (int i = 0; i < scene.camera.width; ++i) {
            const auto verdict = test::compare_trees(own, reference, i, j);
            verdicts.undecided += verdict.undecided ? 1 : 0;
            verdicts.wrong += verdict.wrong ? 1 : 0;
            if (verdict.wrong && verdicts.first.empty()) {
                verdicts.first = std::to_string(i) + "," + std::to_string(j) + " " + verdict.what;
            }
        }
    }
    return verdicts;
}

/// A frame that is along no axis, so that nothing comes out even.
struct Frame {
    Point origin{};
    double size = 1;
    UnitVec3<double> n = UnitVec3<double>::of(Vec(0.3, 0.8, 0.52));
    UnitVec3<double> u = UnitVec3<double>::of(outer(n.vec(), Vec(0.9, 0.1, -0.4)));
    Vec v = outer(n.vec(), u.vec());

    Point at(double x, double y, double z) const {
        return origin + size * (x * u.vec() + y * v + z * n.vec());
    }
    Polygon square(double z, double half) const {
        return {{at(-half, -half, z), at(half, -half, z), at(half, half, z), at(-half, half, z)},
                {}};
    }
};

constexpr int side = 12;

/// A picture of the frame's origin from above, a light beside the eye.
Scene scene_of(const Frame& frame) {
    Scene scene;
    scene.camera.eye = frame.at(1, -3, 4);
    scene.camera.look_at = frame.at(0, 0, 0);
    scene.camera.up = frame.n;
    scene.camera.width = scene.camera.height = side;
    Light light;
    light.name = "light";
    light.kind = PointLight{frame.at(2, 1, 6), {}};
    scene.lights.push_back(light);
    scene.settings.min_weight = 0;
    return scene;
}

Material matte() { return Material{}; }

Material glass() {
    Material material;
    material.kr = Colour(0.1);
    material.kt = Colour(0.85);
    material.ks = Colour(0.5);
    material.kd = Colour(0.1);
    return material;
}

/// In micrometres, metres and light-years, at the origin and 10^8 sizes from it.
std::vector<Frame> frames() {
    std::vector<Frame> list;
    for (const auto& [size, offset] :
         {std::pair(1e-9, 0.0), std::pair(1.0, 0.0), std::pair(1.0, 1e8), std::pair(1e9, 1e8)}) {
        Frame frame{};
        frame.size = size;
        frame.origin = offset * size * Vec(0.6, -0.48, 0.64);
        list.push_back(frame);
    }
    return list;
}

void expect_held(const Scene& scene) {
    const Verdicts verdicts = compare_all(scene);
    CAPTURE(verdicts.first);
    CHECK(verdicts.wrong == 0);
}

}  // namespace

TEST_CASE("error bounds: a highlight below the smallest number of double has a bound") {
    SceneOptions options;
    options.size = {97, 61};
    const auto loaded = load_scene(RAYTREE_DATA_DIR "/scenes/ray-budget.json", options);
    const World<double> own(loaded.scene);
    const World<Quad> reference(loaded.scene);
    const auto verdict = test::compare_trees(own, reference, 55, 39);
    CAPTURE(verdict.what);
    CHECK(!verdict.wrong);
}

TEST_CASE("error bounds: what is multiplied by 0 has no error, and is no less than nothing") {
    Scene scene = scene_of({});
    test::add_material(scene, matte());  // ks is 0
    test::add(scene, Sphere{{0, 0, 0}, 1});
    const World<double> own(scene);
    const World<Quad> reference(scene);
    const auto tree = record_tree(own, side / 2, side / 2);
    const auto bounds = error_bounds(own, reference, tree, Real<double>::unit_roundoff);
    REQUIRE(tree.rays[0].hit);
    CHECK(bounds[0].specular == Colour(0.0));
    CHECK(bounds[0].diffuse.r > 0);
}

TEST_CASE("error bounds: weights, transmittance and light far below the range of double") {
    Scene scene = scene_of({});
    Material material = glass();
    material.kr = material.kt = Colour(1e-120, 1e-80, 0.5);
    material.shininess = 3000;
    test::add_material(scene, material);
    test::add_material(scene, matte());
    const Frame frame{};
    for (int k = 0; k < 4; ++k) {
        test::add(scene, Sphere{frame.at(0.3 * k, 0.2, 0.5 * k), 0.6});
    }
    test::add(scene, frame.square(-0.7, 9), 1);
    scene.settings.shadows = ShadowMode::transmissive;
    scene.settings.max_depth = 7;
    expect_held(scene);
    scene.materials[0].kt = Colour(1e-120);
    expect_held(scene);
}

TEST_CASE("error bounds: faces that coincide, seen straight on and not") {
    for (const Frame& frame : frames()) {
        Scene scene = scene_of(frame);
        test::add_material(scene, glass());
        test::add_material(scene, matte());
        test::add(scene, frame.square(0, 1), 0);
        test::add(scene,
                  Polygon{{frame.at(-2, -2, 0), frame.at(2.5, -1.3, 0), frame.at(0, 2, 0)}, {}}, 1);
        test::add(scene, frame.square(-0.5, 1), 1);
        CAPTURE(frame.size);
        expect_held(scene);
        scene.camera.eye = frame.at(0, 0, 4);
        scene.camera.up = frame.u;
        expect_held(scene);
    }
}

TEST_CASE("error bounds: faces in one plane, met together on the recorded ray") {
    Scene scene;
    scene.camera.eye = {0.3, 1.7, 6};
    scene.camera.look_at = {0, 0.7, 0};
    scene.camera.window = HorizontalFov{45};
    scene.camera.width = 97;
    scene.camera.height = 61;
    Material clear;
    clear.kr = Colour(0.08);
    clear.kt = Colour(0.9);
    Material mirror;
    mirror.kr = Colour(0.2);
    test::add_material(scene, clear);
    test::add_material(scene, matte());
    test::add_material(scene, mirror);
    test::add(scene, Polygon{{{-9, 0, 9}, {9, 0, 9}, {9, 0, -9}, {-9, 0, -9}}, {}}, 1);
    test::add(scene, Polygon{{{-1, 0, 2}, {1.1, 0, 2.1}, {1, 0, 0.9}}, {}}, 2);
    test::add(scene, Sphere{{0, 0.3, 1.3}, 0.3});
    const World<double> own(scene);
    const World<Quad> reference(scene);
    const auto verdict = test::compare_trees(own, reference, 45, 39);
    CAPTURE(verdict.what);
    CHECK(!verdict.wrong);
}

TEST_CASE("error bounds: a ball that rests on a plane, and glass balls that touch") {
    for (const Frame& frame : frames()) {
        Scene scene = scene_of(frame);
        test::add_material(scene, glass());
        test::add_material(scene, matte());
        test::add(scene, frame.square(0, 3), 1);
        test::add(scene, Sphere{frame.at(0, 0, 1), frame.size});
        test::add(scene, Sphere{frame.at(2, 0, 1), frame.size});
        test::add(scene, Sphere{frame.at(1, 0, 1), 2 * frame.size});  // touches both inside
        CAPTURE(frame.size);
        expect_held(scene);
        scene.camera.look_at = frame.at(0, 0, 0);  // where it rests
        scene.camera.window = HorizontalFov{1e-6};
        expect_held(scene);
        scene.camera.look_at = frame.at(1, 0, 1);  // where they touch
        expect_held(scene);
    }
}

TEST_CASE("error bounds: a wall at just the largest distance, and at the near plane") {
    for (const Frame& frame : frames()) {
        Scene scene = scene_of(frame);
        test::add_material(scene, glass());
        test::add(scene, frame.square(0, 3));
        test::add(scene, frame.square(1, 3));
        scene.camera.eye = frame.at(0, 0, 4);
        scene.camera.up = frame.u;
        scene.camera.window = HorizontalFov{1e-6};
        for (const double distance : {3.0, 4.0, 5.0}) {
            scene.settings.max_distance = distance * frame.size;
            expect_held(scene);
        }
        scene.settings.max_distance.reset();
        scene.camera.near = 3 * frame.size;
        expect_held(scene);
    }
}

TEST_CASE("error bounds: a light in the plane of a ceiling") {
    for (const Frame& frame : frames()) {
        for (const ShadowMode shadows : {ShadowMode::opaque, ShadowMode::transmissive}) {
            Scene scene = scene_of(frame);
            test::add_material(scene, matte());
            test::add_material(scene, glass());
            test::add(scene, frame.square(0, 3));
            test::add(scene, frame.square(6, 8), 1);
            scene.settings.shadows = shadows;
            CAPTURE(frame.size);
            expect_held(scene);
        }
    }
}

TEST_CASE("error bounds: a light within rounding of a surface") {
    for (const Frame& frame : frames()) {
        Scene scene = scene_of(frame);
        test::add_material(scene, matte());
        scene.materials[0].ks = Colour(0.5);
        test::add(scene, frame.square(0, 3));
        scene.camera.eye = frame.at(0, 0, 4);
        scene.camera.up = frame.u;
        scene.camera.window = HorizontalFov{1e-6};
        scene.lights[0].kind = PointLight{frame.at(0, 0, 0), {0, 0, 1 / (frame.size * frame.size)}};
        expect_held(scene);
    }
}

TEST_CASE("error bounds: an interpolated normal that jumps beside a vertex") {
    Frame frame{};
    Scene scene = scene_of(frame);
    test::add_material(scene, matte());
    scene.materials[0].ks = Colour(0.5);
    // Concave; the line through the inner vertex is the picture's middle row.
    Polygon polygon{{{-2, -1, 0}, {2, -1, 0}, {0.25, 0, 0}, {2, 1, 0}, {-2, 1, 0}}, {}};
    for (std::size_t k = 0; k < polygon.vertices.size(); ++k) {
        polygon.normals.push_back(Point(0.1 * static_cast<double>(k), -0.2, 1));
    }
    test::add(scene, polygon);
    scene.camera.eye = {0.1, 0, 3};
    scene.camera.look_at = {0.1, 0, 0};
    scene.camera.up = {0, 1, 0};
    scene.camera.width = scene.camera.height = 33;
    expect_held(scene);
    scene.camera.eye = {0.3, 0.7, 3};
    scene.camera.window = HorizontalFov{1e-12};
    for (const double x : {-1.0, 0.1, 0.25, 1.0}) {
        scene.camera.look_at = {x, 0, 0};
        expect_held(scene);
    }
}

TEST_CASE("error bounds: of faces that coincide, a ray says that it could meet the other one") {
    const Frame frame{};
    Scene scene = scene_of(frame);
    test::add_material(scene, matte());
    test::add(scene, frame.square(0, 1));
    test::add(scene, Polygon{{frame.at(-2, -2, 0), frame.at(2.5, -1.3, 0), frame.at(0, 2, 0)}, {}});
    const World<double> own(scene);
    const World<Quad> reference(scene);
    const auto tree = record_tree(own, side / 2, side / 2);
    const auto bounds = error_bounds(own, reference, tree, Real<double>::unit_roundoff);
    REQUIRE(!bounds[0].doubts.empty());
    CHECK(bounds[0].doubts[0].ulps < 32);
}
