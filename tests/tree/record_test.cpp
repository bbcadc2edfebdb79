#include "tree/record.h"

#include <doctest/doctest.h>

#include <cmath>

#include "scene/input_error.h"
#include "support/scenes.h"
#include "trace/render.h"

using namespace raytree;

namespace {

using doctest::Approx;

/// Seen through the one pixel of test::one_pixel_camera: its ray starts at (0, 0, 5) along -z.
Scene empty_scene() {
    Scene scene;
    scene.camera = test::one_pixel_camera();
    scene.background = {0.25, 0.5, 0.75};
    return scene;
}

Material matt() { return {}; }

Material mirror(double kr) {
    Material m;
    m.ka = m.kd = Colour(0.0);
    m.kr = Colour(kr);
    return m;
}

Material glass(double ior, double kt = 0.9, double kr = 0) {
    Material m = mirror(kr);
    m.kt = Colour(kt);
    m.ior = ior;
    return m;
}

void add_light(Scene& scene, const Point& position) {
    Light light;
    light.name = "light" + std::to_string(scene.lights.size());
    light.kind = PointLight{position, {}};
    scene.lights.push_back(light);
}

/// A square of half width `w` in the plane z = `z`, its front towards +z.
Polygon wall(double z, double w = 10) {
    return {{{-w, -w, z}, {w, -w, z}, {w, w, z}, {-w, w, z}}, {}};
}

RayTree<double> tree_of(const Scene& scene) {
    const World<double> world(scene);
    return record_tree(world, 0, 0);
}

Reason skipped(const TreeRay<double>& ray, RayKind kind) {
    for (const Skipped& s : ray.skipped) {
        if (s.kind == kind) {
            return s.reason;
        }
    }
    FAIL("no such branch was skipped");
    return {};
}

}  // namespace

TEST_CASE("tree: a ray that meets nothing sees the background") {
    const auto tree = tree_of(empty_scene());
    REQUIRE(tree.rays.size() == 1);
    const auto& ray = tree.rays[0];
    CHECK_FALSE(ray.hit);
    CHECK(ray.termination == Reason::no_intersection);
    CHECK(ray.intensity == Colour(0.25, 0.5, 0.75));
    CHECK(tree.intensity == ray.intensity);
    CHECK(tree.counts.full_tree == 63);  // no light: (0 + 1)(2^6 - 1)
}

TEST_CASE("tree: a matt ball lit from the eye, number by number") {
    Scene scene = empty_scene();
    Material m = matt();
    m.ks = Colour(0.5);
    test::add(scene, Sphere{{0, 0, 0}, 1}, test::add_material(scene, m));
    add_light(scene, {0, 0, 5});
    std::get<PointLight>(scene.lights[0].kind).attenuation = {0, 0.5, 0};
    const auto tree = tree_of(scene);
    REQUIRE(tree.rays.size() == 2);
    const auto& ray = tree.rays[0];
    REQUIRE(ray.hit);
    CHECK(ray.hit->t == 4);
    CHECK(ray.hit->point.z == 1);
    CHECK(ray.hit->side == Side::front);
    CHECK(ray.hit->cos_incident == 1);
    CHECK(ray.ambient.r == Approx(0.1 * 0.8));
    CHECK(ray.diffuse.r == Approx(0.7 * 0.8 / (0.5 * 4)));
    CHECK(ray.specular.r == Approx(0.5 / 2));
    CHECK(ray.termination == Reason::opaque);
    CHECK(skipped(ray, RayKind::reflected) == Reason::not_reflective);
    CHECK(skipped(ray, RayKind::refracted) == Reason::not_transmissive);
    const auto& shadow = tree.rays[1];
    CHECK(shadow.kind == RayKind::shadow);
    CHECK(shadow.shadow->distance == 4);
    CHECK_FALSE(shadow.shadow->blocked_by);
    CHECK(shadow.diffuse == ray.diffuse);
}

TEST_CASE("tree: Blinn's half vector and Phong's mirrored one differ as their formulas do") {
    Scene scene = empty_scene();
    Material m = matt();
    m.ks = Colour(1.0);
    m.shininess = 3;
    test::add(scene, wall(0), test::add_material(scene, m));
    add_light(scene, {5, 0, 5});  // L at 45 degrees, V along the normal
    CHECK(tree_of(scene).rays[0].specular.r == Approx(std::pow(std::sqrt(0.5), 3)));
    scene.settings.specular_model = SpecularModel::blinn;
    CHECK(tree_of(scene).rays[0].specular.r == Approx(std::pow(std::cos(M_PI / 8), 3)));
}

TEST_CASE("tree: lights behind the surface and surfaces without anything to light send no ray") {
    Scene scene = empty_scene();
    test::add(scene, wall(0), test::add_material(scene, matt()));
    add_light(scene, {0, 0, -5});
    CHECK(skipped(tree_of(scene).rays[0], RayKind::shadow) == Reason::light_behind_surface);
    scene.materials[0].kd = Colour(0.0);
    CHECK(skipped(tree_of(scene).rays[0], RayKind::shadow) == Reason::light_behind_surface);
    scene.lights[0].kind = PointLight{{0, 0, 5}, {}};
    CHECK(skipped(tree_of(scene).rays[0], RayKind::shadow) == Reason::surface_unlit);
}

TEST_CASE("tree: a light on the very point that is lit adds nothing and is no NaN") {
    Scene scene = empty_scene();
    test::add(scene, wall(0), test::add_material(scene, matt()));
    add_light(scene, {0, 0, 0});
    const auto tree = tree_of(scene);
    CHECK(skipped(tree.rays[0], RayKind::shadow) == Reason::light_behind_surface);
    CHECK(tree.intensity.r == Approx(0.08));
}

TEST_CASE("tree: shadows of panes and balls in the three modes") {
    Scene scene = empty_scene();
    test::add(scene, wall(0), test::add_material(scene, matt()));
    const std::size_t half = test::add_material(scene, glass(1, 0.5));
    test::add(scene, Sphere{{4, 0, 4}, 0.5}, half);
    test::add(scene, Polygon{{{2, -1, 3}, {3.5, -1, 3}, {3.5, 1, 3}, {2, 1, 3}}, {}}, half);
    add_light(scene, {6, 0, 6});

    auto tree = tree_of(scene);
    REQUIRE(tree.rays.size() == 2);
    REQUIRE(tree.rays[1].shadow->blocked_by);
    CHECK(tree.rays[1].shadow->blocked_by->object == "object2");  // the pane is nearer
    CHECK(tree.rays[1].shadow->blocked_by->t == Approx(3 * std::sqrt(2.0)));
    CHECK(tree.rays[0].diffuse == Colour(0.0));

    scene.settings.shadows = ShadowMode::transmissive;
    tree = tree_of(scene);
    CHECK(tree.rays[1].shadow->transmittance == Colour(0.125));  // the pane once, the ball twice
    CHECK_FALSE(tree.rays[1].shadow->blocked_by);
    CHECK(tree.rays[0].diffuse.r == Approx(0.125 * 0.56 * std::sqrt(0.5)));

    scene.materials[half].kt = Colour(0, 0.5, 0);
    scene.objects[1].material = test::add_material(scene, glass(1, 0));
    tree = tree_of(scene);
    REQUIRE(tree.rays[1].shadow->blocked_by);
    CHECK(tree.rays[1].shadow->blocked_by->object == "object1");  // where the product becomes 0
    CHECK(tree.rays[1].shadow->transmittance == Colour(0.0));

    scene.settings.shadows = ShadowMode::none;
    tree = tree_of(scene);
    CHECK(tree.rays.size() == 1);
    CHECK(tree.rays[0].diffuse.r == Approx(0.56 * std::sqrt(0.5)));
}

TEST_CASE("tree: what lies beyond a light casts no shadow from it") {
    Scene scene = empty_scene();
    test::add(scene, wall(0), test::add_material(scene, matt()));
    test::add(scene, Sphere{{0, 0, 9}, 1}, 0);
    add_light(scene, {0, 0, 7});
    CHECK_FALSE(tree_of(scene).rays[1].shadow->blocked_by);
    add_light(scene, {0, 0, 11});
    CHECK(tree_of(scene).rays[2].shadow->blocked_by->object == "object1");
    Light sun;
    sun.name = "sun";
    sun.kind = DirectionalLight{{0, 0, -3}};
    scene.lights.push_back(sun);
    const auto tree = tree_of(scene);
    CHECK_FALSE(tree.rays[3].shadow->distance);
    CHECK(tree.rays[3].shadow->blocked_by->t == Approx(8));
}

TEST_CASE("tree: two mirrors that face each other stop at the depth, the weight or the budget") {
    Scene scene = empty_scene();
    test::add(scene, wall(0), test::add_material(scene, mirror(0.5)));
    test::add(scene, wall(6), 0);
    scene.settings.min_weight = 0;
    auto tree = tree_of(scene);
    REQUIRE(tree.rays.size() == 6);
    CHECK(tree.counts.levels == 6);
    CHECK(tree.rays[5].termination == Reason::max_depth);
    CHECK(tree.rays[5].weight == Colour(1.0 / 32));
    CHECK(tree.rays[4].termination == std::nullopt);
    CHECK(tree.rays[1].direction.z == 1);
    CHECK(tree.rays[1].hit->side == Side::back);

    scene.settings.min_weight = 0.1;
    tree = tree_of(scene);
    REQUIRE(tree.rays.size() == 4);  // weights 1, 1/2, 1/4, 1/8; 1/16 is below
    CHECK(tree.rays[3].termination == Reason::low_intensity);

    scene.settings.min_weight = 0;
    scene.settings.ray_budget = 3;
    tree = tree_of(scene);
    REQUIRE(tree.rays.size() == 3);
    CHECK(tree.rays[2].termination == Reason::ray_budget);
}

TEST_CASE("tree: the budget counts shadow rays and is asked when a branch's turn comes") {
    Scene scene = empty_scene();
    Material m = glass(1, 0.5, 0.5);
    m.kd = Colour(0.1);
    test::add(scene, wall(0), test::add_material(scene, m));
    add_light(scene, {0, 0, 5});
    scene.settings.ray_budget = 3;
    const auto tree = tree_of(scene);
    REQUIRE(tree.rays.size() == 3);  // primary, shadow, reflected; then the refracted one's turn
    CHECK(tree.rays[2].kind == RayKind::reflected);
    CHECK(skipped(tree.rays[0], RayKind::refracted) == Reason::ray_budget);
    CHECK(tree.rays[0].termination == std::nullopt);
}

TEST_CASE("tree: attenuation and the distance limit follow the path") {
    Scene scene = empty_scene();
    test::add(scene, wall(0), test::add_material(scene, mirror(0.5)));
    Material lamp = matt();
    lamp.ka = Colour(1.0);
    lamp.kd = Colour(0.0);
    lamp.color = Colour(1.0);
    test::add(scene, wall(7), test::add_material(scene, lamp));
    scene.settings.attenuation = {1, 0, 0.01};
    auto tree = tree_of(scene);
    REQUIRE(tree.rays.size() == 2);
    CHECK(tree.rays[0].attenuation == 1);
    CHECK(tree.rays[1].attenuation == Approx(1 / 1.49));
    CHECK(tree.rays[1].weight == Colour(0.5));
    CHECK(tree.intensity.r == Approx(0.5 / 1.49));

    scene.settings.max_distance = 12;  // 5 to the mirror and 7 back: exactly that long
    tree = tree_of(scene);
    CHECK_FALSE(tree.rays[1].hit);
    CHECK(tree.rays[1].termination == Reason::max_distance);
    CHECK(tree.rays[1].attenuation == 1);
    scene.settings.max_distance = 12.001;
    CHECK(tree_of(scene).rays[1].hit);
}

TEST_CASE("tree: a secondary ray that escapes sees its own background where the scene has one") {
    Scene scene = empty_scene();
    test::add(scene, wall(0), test::add_material(scene, mirror(1)));
    CHECK(tree_of(scene).intensity == Colour(0.25, 0.5, 0.75));
    scene.settings.secondary_background = Colour(0.0);
    CHECK(tree_of(scene).intensity == Colour(0.0));
}

TEST_CASE("tree: the near distance hides from primary rays alone what is closer") {
    Scene scene = empty_scene();
    test::add(scene, Sphere{{0, 0, 0}, 1}, test::add_material(scene, mirror(0.5)));
    test::add(scene, wall(4.5), 0);  // half a unit before the eye
    scene.camera.near = 4.5;         // past the front of the ball as well
    const auto tree = tree_of(scene);
    CHECK(tree.rays[0].origin.z == 5);
    CHECK(tree.rays[0].hit->t == 6);
    CHECK(tree.rays[0].hit->side == Side::back);
    CHECK(tree.rays[1].hit->t == 2);  // reflected inside the ball: no near rule
}

TEST_CASE("tree: a glass ball is entered and left with inverse indices") {
    Scene scene = empty_scene();
    test::add(scene, Sphere{{0.5, 0, 0}, 1}, test::add_material(scene, glass(1.5)));
    const auto tree = tree_of(scene);
    REQUIRE(tree.rays.size() == 3);
    const auto& in = *tree.rays[0].hit;
    CHECK(in.interface->eta1 == 1);
    CHECK(in.interface->eta2 == 1.5);
    CHECK(in.interface->sin2_transmitted == Approx(0.25 / 2.25));
    const auto& out = *tree.rays[1].hit;
    CHECK(out.side == Side::back);
    CHECK(out.interface->eta1 == 1.5);
    CHECK(out.interface->eta2 == 1);
    CHECK(out.interface->sin2_transmitted == Approx(0.25));  // as it came in
    // Deflected twice by asin(1/2) - asin(1/3), towards the axis.
    const double turn = 2 * (std::asin(0.5) - std::asin(1 / 3.0));
    CHECK(tree.rays[2].direction.x == Approx(std::sin(turn)));
    CHECK(tree.rays[2].direction.z == Approx(-std::cos(turn)));
}

TEST_CASE("tree: media are a list: a bubble, and the last of overlapping media") {
    Scene scene = empty_scene();
    const std::size_t outer = test::add_material(scene, glass(1.5));
    const std::size_t bubble = test::add_material(scene, glass(1.0));
    test::add(scene, Sphere{{0, 0, 0}, 2}, outer);
    test::add(scene, Sphere{{0, 0, 0}, 1}, bubble);
    const auto tree = tree_of(scene);
    REQUIRE(tree.rays.size() == 5);
    const double expected[4][2] = {{1, 1.5}, {1.5, 1}, {1, 1.5}, {1.5, 1}};
    for (std::size_t k = 0; k < 4; ++k) {
        CHECK(tree.rays[k].hit->interface->eta1 == expected[k][0]);
        CHECK(tree.rays[k].hit->interface->eta2 == expected[k][1]);
    }
    // Leaving a medium that was never entered: the list stays as it is.
    scene.objects.erase(scene.objects.begin());
    scene.camera.near = 5;  // starts inside the bubble
    const auto inside = tree_of(scene);
    CHECK(inside.rays[0].hit->interface->eta1 == 1);
    CHECK(inside.rays[0].hit->interface->eta2 == 1);
}

TEST_CASE("tree: total internal reflection drops the refracted ray or adds it to the reflected") {
    Scene scene = empty_scene();
    // The back of a wall tilted by 45 degrees: sin2 = 1.5^2 / 2 > 1.
    test::add(scene, Polygon{{{-9, 0, -9}, {-9, 0, 9}, {9, 0, 9}, {9, 0, -9}}, {}},
              test::add_material(scene, glass(1.5, 0.7, 0.2)));
    scene.objects[0].transform = {{{1, 0, 0, 0},
                                   {0, std::sqrt(0.5), -std::sqrt(0.5), 0},
                                   {0, std::sqrt(0.5), std::sqrt(0.5), 0}}};
    auto tree = tree_of(scene);
    if (tree.rays[0].hit->side == Side::front) {
        std::get<Polygon>(scene.objects[0].shape).vertices = {
            {9, 0, -9}, {9, 0, 9}, {-9, 0, 9}, {-9, 0, -9}};
        tree = tree_of(scene);
    }
    REQUIRE(tree.rays[0].hit->side == Side::back);
    CHECK(tree.rays[0].hit->interface->sin2_transmitted == Approx(1.125));
    CHECK(skipped(tree.rays[0], RayKind::refracted) == Reason::total_internal_reflection);
    REQUIRE(tree.rays.size() == 2);
    CHECK(tree.rays[1].weight.r == Approx(0.2));
    scene.settings.total_internal_reflection = TotalReflection::reflect;
    tree = tree_of(scene);
    CHECK(tree.rays[1].weight.r == Approx(0.9));
    CHECK(tree.intensity.g == Approx(0.9 * 0.5));

    scene.settings.total_internal_reflection = TotalReflection::drop;
    scene.materials[0].kr = Colour(0.0);
    tree = tree_of(scene);
    CHECK(tree.rays[0].termination == Reason::total_internal_reflection);
}

TEST_CASE("tree: intensities beyond the range of numbers are an error, not an infinity") {
    Scene scene = empty_scene();
    test::add(scene, wall(0), test::add_material(scene, mirror(1e200)));
    test::add(scene, wall(6), 0);
    scene.settings.min_weight = 0;
    CHECK_THROWS_AS(tree_of(scene), InputError);
    scene.background = Colour(0.0);  // only the weights grow
    CHECK_THROWS_AS(tree_of(scene), InputError);
}

TEST_CASE("tree: a pixel outside the picture is an error that says what is allowed") {
    const Scene scene = empty_scene();
    const World<double> world(scene);
    CHECK_THROWS_WITH_AS(record_tree(world, 1, 0),
                         "pixel 1,0: lies outside the picture; allowed are 0,0 to 0,0", InputError);
    CHECK_THROWS_AS(record_tree(world, 0, -1), InputError);
}

namespace {

/// Everything at once, many rays a pixel.
Scene rich_scene() {
    Scene scene = test::random_shapes(60, 3, 2, Point(0.0));
    scene.camera.eye = {0.3, 0.4, 6};
    scene.camera.look_at = {0, 0, 0};
    scene.camera.width = 24;
    scene.camera.height = 18;
    scene.background = {0.1, 0.2, 0.3};
    scene.settings.attenuation = {1, 0.02, 0.001};
    scene.settings.shadows = ShadowMode::transmissive;
    scene.settings.total_internal_reflection = TotalReflection::reflect;
    scene.materials[0] = glass(1.4, 0.6, 0.3);
    scene.materials[0].kd = Colour(0.3, 0.2, 0.1);
    scene.materials[0].ks = Colour(0.4);
    test::add_material(scene, matt());
    for (std::size_t k = 0; k < scene.objects.size(); k += 3) {
        scene.objects[k].material = 1;
    }
    add_light(scene, {3, 5, 6});
    add_light(scene, {-4, 2, 3});
    return scene;
}

}  // namespace

TEST_CASE("tree: every hit's intensity is the sum of its parts") {
    const Scene scene = rich_scene();
    const World<double> world(scene);
    std::size_t rays = 0;
    for (int k = 0; k < scene.camera.width * scene.camera.height; ++k) {
        const auto tree = record_tree(world, k % scene.camera.width, k / scene.camera.width);
        rays += tree.rays.size();
        std::vector<Colour> sum(tree.rays.size());
        for (std::size_t r = tree.rays.size(); r-- > 0;) {
            const auto& ray = tree.rays[r];
            if (ray.kind == RayKind::shadow) {
                continue;
            }
            if (ray.hit) {
                const Colour all = sum[r] + ray.ambient + ray.diffuse + ray.specular;
                CHECK(all.r == Approx(ray.intensity.r).epsilon(1e-14));
                CHECK(all.b == Approx(ray.intensity.b).epsilon(1e-14));
            }
            if (ray.parent) {
                const auto& parent = *tree.rays[*ray.parent].hit;
                const Colour& coefficient = ray.kind == RayKind::reflected ? parent.kr : parent.kt;
                sum[*ray.parent] += ray.attenuation * (coefficient * ray.intensity);
            }
        }
    }
    CHECK(rays > 500);
}

TEST_CASE("tree: every pixel of the picture is its tree's root, on any number of threads") {
    const Scene scene = rich_scene();
    const World<double> world(scene);
    const Picture one = render(world, {1, {}});
    const Picture four = render(world, {4, {}});
    const Measurement measured = render_measured(world, Measure::rays, {3, {}});
    CHECK(one.pixels == four.pixels);
    CHECK(one.pixels == measured.picture.pixels);
    std::size_t rays = 0;
    for (int j = 0; j < scene.camera.height; ++j) {
        for (int i = 0; i < scene.camera.width; ++i) {
            const auto tree = record_tree(world, i, j);
            CHECK(tree.intensity == one.at(i, j));
            rays += tree.rays.size();
            CHECK(measured.map[static_cast<std::size_t>(j * scene.camera.width + i)] ==
                  static_cast<double>(tree.rays.size()));
        }
    }
    CHECK(measured.counts.rays() == rays);
}

TEST_CASE("tree: double and the reference arithmetic trace the same tree") {
    const Scene scene = rich_scene();
    const World<double> world(scene);
    const World<Quad> reference(scene);
    for (int i = 1; i < scene.camera.width; i += 4) {
        const auto tree = record_tree(world, i, 8);
        const auto exact = record_tree(reference, i, 8);
        REQUIRE(tree.rays.size() == exact.rays.size());
        for (std::size_t k = 0; k < tree.rays.size(); ++k) {
            CHECK(tree.rays[k].kind == exact.rays[k].kind);
            CHECK(tree.rays[k].termination == exact.rays[k].termination);
            REQUIRE(tree.rays[k].hit.has_value() == exact.rays[k].hit.has_value());
            if (tree.rays[k].hit) {
                CHECK(tree.rays[k].hit->object == exact.rays[k].hit->object);
            }
        }
        CHECK(tree.intensity.g == Approx(static_cast<double>(exact.intensity.g)).epsilon(1e-9));
    }
}
