#include <doctest/doctest.h>

#include "folders.h"
#include "formats/scene_file.h"
#include "trace/eye_space.h"
#include "trace/light_shower.h"
#include "trace/ray_list.h"
#include "trace/render.h"
#include "trace/self_hits.h"
#include "trace/time_share.h"
#include "trace/work_precision.h"
#include "trace/z_buffer.h"

using namespace raytree;

namespace {

Scene scene_of(const char* name, int width = 40, int height = 30) {
    SceneOptions options;
    options.size = {width, height};
    return load_scene(std::string(RAYTREE_DATA_DIR "/scenes/") + name, options).scene;
}

}  // namespace

TEST_CASE("the list of a picture's rays has every ray that rendering counts") {
    for (const char* const name : {"glass-ball.json", "max-distance.json", "cut-open.json"}) {
        const Scene scene = scene_of(name);
        const World<double> world(scene);
        const RayCounts counts = render_measured(world, Measure::rays).counts;
        std::array<std::size_t, 4> rays{}, hits{};
        NoTestCount none;
        for (const auto& listed : rays_of_picture(world)) {
            const auto kind = static_cast<std::size_t>(listed.kind);
            ++rays[kind];
            hits[kind] +=
                world.shapes.closest(listed.ray, listed.leaving, listed.interval, none) ? 1 : 0;
        }
        for (const RayKind kind : {RayKind::primary, RayKind::reflected, RayKind::refracted}) {
            CHECK(rays[static_cast<std::size_t>(kind)] == counts[kind].rays);
            CHECK(hits[static_cast<std::size_t>(kind)] == counts[kind].hits);
        }
        CHECK(rays[3] == counts[RayKind::shadow].rays);
    }
}

TEST_CASE("eye space keeps lengths and angles, and has the look-at point straight ahead") {
    const Scene scene = scene_of("glass-ball.json");
    const EyeSpace<double> space(scene.camera, scene.settings.pixel_sample);
    const Vec3<double> ahead = space.point(scene.camera.look_at);
    CHECK(ahead.x == doctest::Approx(0).epsilon(1e-12));
    CHECK(ahead.y == doctest::Approx(0).epsilon(1e-12));
    CHECK(ahead.z == doctest::Approx(length(scene.camera.look_at - scene.camera.eye)));
    const Vec3<double> p{1, -2, 0.5};
    CHECK(length(space.point(p)) == doctest::Approx(length(p - scene.camera.eye)));
    CHECK(length(space.point_in_world(space.point(p)) - p) < 1e-12);
    // Left-handed: x cross y is -z when it is worked out by the right hand's rule in the world.
    const Vec3<double> x = space.direction({1, 0, 0}), y = space.direction({0, 1, 0}),
                       z = space.direction({0, 0, 1});
    CHECK(inner(outer(x, y), z) == doctest::Approx(-1));
}

TEST_CASE("of a light's shower the share that meets a ball is the ball's solid angle") {
    Scene scene;
    scene.camera.eye = {0, 0, 50};
    scene.materials.push_back({});
    scene.lights.push_back({"lamp", Colour(1.0), PointLight{{0, 0, 0}, {}}});
    Object ball;
    ball.name = "ball";
    ball.shape = Sphere{{0, 4, 0}, 2};
    scene.objects.push_back(ball);
    const World<double> world(scene);
    ShowerOptions options;
    options.rays = 20000;
    const LightShower sent = shower(world, 0, options);
    const double share = (1 - std::sqrt(1 - 0.25)) / 2;
    CHECK(static_cast<double>(sent.hits) / 20000 == doctest::Approx(share).epsilon(0.01));
    CHECK(sent.paths.size() >= options.kept);
    // Straight to the eye: the share of the sphere that a disc around the eye takes.
    options.eye_radius = 5;
    const double direct = 25.0 / (4 * 2500);
    CHECK(static_cast<double>(shower(world, 0, options).reach_eye) / 20000 ==
          doctest::Approx(direct).epsilon(0.1));
    CHECK(shower(world, 0, options).reach_eye == shower(world, 0, options).reach_eye);
}

TEST_CASE("the z-buffer ends with the object that the ray hits, in every pixel") {
    for (const char* const name : {"glass-ball.json", "mesh.json", "cut-open.json"}) {
        const Scene scene = scene_of(name);
        const World<double> world(scene);
        NoTestCount none;
        for (int j = 0; j < scene.camera.height; ++j) {
            for (int i = 0; i < scene.camera.width; ++i) {
                const Ray<double> ray = world.camera.primary(i, j);
                const auto hit = world.shapes.closest(
                    ray, no_primitive, {world.camera.near_along(ray.direction)}, none);
                const auto steps = z_buffer_at(world, i, j);
                std::optional<std::size_t> seen;
                for (const ZBufferStep& step : steps) {
                    seen = step.written ? step.object : seen;
                }
                REQUIRE(seen.has_value() == hit.has_value());
                CHECK((!hit || *seen == world.shapes.shapes()[hit->primitive].object));
            }
        }
    }
}

TEST_CASE("intersection takes a share of the time, and more of it without a hierarchy") {
    const Scene scene = scene_of("sphereflake.json", 24, 18);
    const World<double> world(scene);
    const TimeShare share = measure_time_share(world);
    CHECK(share.rays > 24 * 18);
    CHECK(share.share() > 0);
    CHECK(share.brute_force_share() > 0.9);  // of 7,381 balls
    CHECK(share.brute_force_intersection > share.intersection);
}

TEST_CASE("more digits and more levels give a smaller error, and the reference takes longest") {
    Scene scene = scene_of("hall-of-mirrors.json", 24, 18);
    scene.settings.min_weight = 0;
    scene.settings.max_depth = 6;
    const WorkPrecision measured = measure_work_precision(scene);
    REQUIRE(measured.arithmetics.size() == 3);
    CHECK(measured.pixels >= 64);
    CHECK(measured.pixels <= 24 * 18);
    const WorkPoint& in_float = measured.arithmetics[0];
    const WorkPoint& in_double = measured.arithmetics[1];
    const WorkPoint& reference = measured.arithmetics[2];
    CHECK(reference.label == "reference");
    CHECK(reference.error == 0);
    CHECK(in_double.error > 0);
    CHECK(in_double.error < 1e-6 * in_float.error);
    CHECK(reference.seconds > in_double.seconds);
    // A tree that is cut off has a larger error than any rounding; the deepest is the scene's own.
    REQUIRE(measured.levels.size() == 5);
    CHECK(measured.levels[0].label == "1 level");
    for (std::size_t k = 0; k < measured.levels.size(); ++k) {
        CHECK(measured.levels[k].error > in_float.error);
        CHECK((k == 0 || measured.levels[k].error < measured.levels[k - 1].error));
    }
}

TEST_CASE("rays that do not know the surface they leave meet it again, in every arithmetic") {
    const Scene scene = scene_of("glass-ball.json");
    const World<double> in_double(scene);
    const World<float> in_float(scene);
    CHECK(self_hits(in_double).rays > 1000);
    CHECK(self_hits(in_double).share() > 0.05);
    CHECK(self_hits(in_float).share() > 0.05);
}
