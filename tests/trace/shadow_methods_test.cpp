#include <doctest/doctest.h>

#include "folders.h"
#include "formats/scene_file.h"
#include "trace/depth_picture.h"
#include "trace/shading.h"
#include "trace/shadow_volume.h"
#include "tree/record.h"

using namespace raytree;

namespace {

Scene scene_of(const char* name, int width = 48, int height = 36) {
    SceneOptions options;
    options.size = {width, height};
    return load_scene(std::string(RAYTREE_DATA_DIR "/scenes/") + name, options).scene;
}

struct Compared {
    int points = 0, wrong = 0, inside = 0, crossings = 0;
};

/// The count along every primary ray of a picture against the shadow ray from its hit.
Compared compare_all(const Scene& scene, std::size_t light) {
    const World<double> world(scene);
    const ShadowVolumes volumes = shadow_volumes(world, light);
    Compared compared;
    NoTestCount none;
    for (int j = 0; j < scene.camera.height; ++j) {
        for (int i = 0; i < scene.camera.width; ++i) {
            const Ray<double> ray = world.camera.primary(i, j);
            const auto hit = world.shapes.closest(ray, no_primitive, {}, none);
            if (!hit) {
                continue;
            }
            const auto surface = world.shapes.shapes().surface_at(hit->primitive, ray, hit->t);
            const bool front = inner(ray.direction, surface.geometric_normal) < 0;
            const Vec3<double> n =
                front ? surface.geometric_normal.vec() : -surface.geometric_normal.vec();
            const auto at = illuminate(world.lights[light], surface.point, n);
            if (!at.in_front()) {
                continue;
            }
            const Ray<double> to_light{surface.point, at.towards, 0};
            const bool dark =
                world.shapes.any(to_light, hit->primitive, {0, at.distance * (1 - 1e-12)}, none);
            const VolumeCount count = count_volumes(volumes, ray, hit->t);
            ++compared.points;
            compared.wrong += dark != (count.end > 0) ? 1 : 0;
            compared.inside += count.start > 0 ? 1 : 0;
            compared.crossings += static_cast<int>(count.crossings.size());
        }
    }
    return compared;
}

void make_polygons(Scene& scene) {
    std::erase_if(scene.objects, [](const Object& object) {
        return std::holds_alternative<Sphere>(object.shape) ||
               std::holds_alternative<Cone>(object.shape);
    });
}

}  // namespace

TEST_CASE("shadow volumes give the answers of shadow rays, for polygons and meshes") {
    for (const char* const name : {"concave-polygon.json", "mesh.json", "prism.json",
                                   "glass-pane-shadow.json", "directional-light.json"}) {
        CAPTURE(std::string(name));
        Scene scene = scene_of(name);
        make_polygons(scene);
        for (std::size_t light = 0; light < scene.lights.size(); ++light) {
            const Compared compared = compare_all(scene, light);
            CHECK(compared.points > 100);
            CHECK(compared.wrong == 0);
        }
    }
}

TEST_CASE("with the eye inside a volume the count starts higher and is right all the same") {
    Scene scene = scene_of("concave-polygon.json");
    make_polygons(scene);
    // A lid over the eye, between it and every light.
    Object lid;
    lid.name = "lid";
    const Point eye = scene.camera.eye;
    const auto* lamp = std::get_if<PointLight>(&scene.lights[0].kind);
    REQUIRE(lamp != nullptr);
    const Point middle = 0.7 * eye + 0.3 * lamp->position;
    lid.shape = Polygon{{middle + Point(-0.3, 0, 0.3), middle + Point(0.3, 0, 0.3),
                         middle + Point(0.3, 0, -0.3), middle + Point(-0.3, 0, -0.3)},
                        {}};
    scene.objects.push_back(lid);
    const World<double> world(scene);
    CHECK(volumes_around(shadow_volumes(world, 0), eye) == 1);
    const Compared compared = compare_all(scene, 0);
    CHECK(compared.inside == compared.points);
    CHECK(compared.wrong == 0);
}

TEST_CASE("a square's shadow volume has four walls, and a ray through it enters and leaves") {
    Scene scene;
    scene.materials.push_back({});
    scene.lights.push_back({"lamp", Colour(1.0), PointLight{{0, 10, 0}, {}}});
    Object square;
    square.name = "square";
    square.shape = Polygon{{{-1, 5, 1}, {1, 5, 1}, {1, 5, -1}, {-1, 5, -1}}, {}};
    scene.objects.push_back(square);
    const World<double> world(scene);
    const ShadowVolumes volumes = shadow_volumes(world, 0);
    REQUIRE(volumes.volumes.size() == 1);
    CHECK(volumes.volumes[0].walls.size() == 4);
    // On the floor the shadow is twice as large as the square.
    const VolumeCount through = count_volumes(volumes, {{-5, 0, 0.1}, {1, 0, 0}, 0}, 100);
    REQUIRE(through.crossings.size() == 2);
    CHECK(through.crossings[0].t == doctest::Approx(3));
    CHECK(through.crossings[0].enters);
    CHECK(through.crossings[1].t == doctest::Approx(7));
    CHECK(through.end == 0);
    CHECK(count_volumes(volumes, {{-5, 0, 0.1}, {1, 0, 0}, 0}, 5).end == 1);
    CHECK(volumes_around(volumes, {1.9, 0, 0}) == 1);
    CHECK(volumes_around(volumes, {2.1, 0, 0}) == 0);
    CHECK(volumes_around(volumes, {0, 7, 0}) == 0);
}

TEST_CASE("a light's depth picture knows distances, and agrees with shadow rays when it is fine") {
    const Scene scene = scene_of("concave-polygon.json");
    const World<double> world(scene);
    const DepthAgreement coarse = agreement(world, 0, DepthPicture(world, 0, 16), 0.05);
    const DepthAgreement fine = agreement(world, 0, DepthPicture(world, 0, 512), 0.05);
    CHECK(fine.compared == coarse.compared);
    CHECK(fine.compared > 500);
    CHECK(fine.differ() < coarse.differ());
    CHECK(fine.differ() < fine.compared / 20);
    // Without a bias a surface shades itself.
    const DepthAgreement acne = agreement(world, 0, DepthPicture(world, 0, 128), 0);
    const DepthAgreement cured = agreement(world, 0, DepthPicture(world, 0, 128), 0.1);
    CHECK(acne.wrongly_dark > 4 * cured.wrongly_dark);
}

TEST_CASE("pixel by pixel the depth picture and the shadow ray say what the tree knows") {
    const Scene scene = scene_of("concave-polygon.json");
    const World<double> world(scene);
    const DepthPicture picture(world, 0, 64);
    const auto answers = shadow_answers(world, 0, picture, 0);
    const int width = scene.camera.width;
    REQUIRE(answers.size() == static_cast<std::size_t>(width * scene.camera.height));
    std::array<std::size_t, 5> counts{};
    for (std::size_t k = 0; k < answers.size(); ++k) {
        ++counts[static_cast<std::size_t>(answers[k])];
        const int i = static_cast<int>(k) % width, j = static_cast<int>(k) / width;
        const RayTree<double> tree = record_tree(world, i, j);
        const auto shadow = std::ranges::find_if(tree.rays, [&](const TreeRay<double>& ray) {
            return ray.kind == RayKind::shadow && ray.parent == 0 &&
                   ray.shadow->light == scene.lights[0].name;
        });
        REQUIRE((shadow != tree.rays.end()) == (answers[k] != ShadowAnswers::none));
        if (shadow == tree.rays.end()) {
            continue;
        }
        const bool reached =
            answers[k] == ShadowAnswers::both_lit || answers[k] == ShadowAnswers::wrongly_dark;
        const bool lit =
            answers[k] == ShadowAnswers::both_lit || answers[k] == ShadowAnswers::wrongly_lit;
        CHECK(reached == !shadow->shadow->blocked_by);
        CHECK(lit == compare(picture, tree.rays[0].hit->point, 0).lit);
    }
    const DepthAgreement agreed = agreement(world, 0, picture, 0);
    CHECK(agreed.wrongly_dark == counts[static_cast<std::size_t>(ShadowAnswers::wrongly_dark)]);
    CHECK(agreed.wrongly_lit == counts[static_cast<std::size_t>(ShadowAnswers::wrongly_lit)]);
    CHECK(agreed.compared == answers.size() - counts[0]);
}

TEST_CASE("around a light amid the scene the depth picture has six sides") {
    Scene scene;
    scene.materials.push_back({});
    scene.lights.push_back({"lamp", Colour(1.0), PointLight{{0, 0, 0}, {}}});
    for (const Point& at : {Point(4, 0, 0), Point(-4, 0.5, 0), Point(0, 4, 1), Point(0, -4, 0),
                            Point(1, 0, 4), Point(0, 0, -4)}) {
        Object ball;
        ball.name = "ball" + std::to_string(scene.objects.size());
        ball.shape = Sphere{at, 1};
        scene.objects.push_back(ball);
    }
    const World<double> world(scene);
    const DepthPicture picture(world, 0, 33);
    CHECK(picture.sides().size() == 6);
    for (const Object& object : scene.objects) {
        const Point center = std::get<Sphere>(object.shape).center;
        const DepthComparison at = compare(picture, center, 0);
        CHECK(at.distance == doctest::Approx(length(center)));
        CHECK(at.stored == doctest::Approx(length(center) - 1).epsilon(0.02));
        CHECK(!at.lit);
    }
}
