#include "tree/schedule.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "support/scenes.h"
#include "tree/record.h"

using namespace raytree;

namespace {

using doctest::Approx;
using Kind = TreeEvent::Kind;

TreeRay<double> ray(std::optional<std::size_t> parent, RayKind kind, int level) {
    TreeRay<double> made;
    made.parent = parent;
    made.kind = kind;
    made.level = level;
    if (kind == RayKind::shadow) {
        made.shadow.emplace();
    } else {
        made.hit.emplace();
    }
    return made;
}

/// 0 hits; a shadow ray to `b` (1), none to `a`; it is reflected (2), which meets nothing, and
/// refracted (3), which hits something opaque that no light is asked about.
RayTree<double> small_tree() {
    RayTree<double> tree;
    tree.rays = {ray(std::nullopt, RayKind::primary, 1), ray(0, RayKind::shadow, 1),
                 ray(0, RayKind::reflected, 2), ray(0, RayKind::refracted, 2)};
    for (std::size_t k = 0; k < tree.rays.size(); ++k) {
        tree.rays[k].id = k;
    }
    TreeRay<double>& root = tree.rays[0];
    root.skipped = {{RayKind::shadow, "a", Reason::light_behind_surface}};
    root.ambient = Rgb<double>(0.1);
    root.hit->kr = Rgb<double>(0.5);
    root.hit->kt = Rgb<double>(0.25);
    root.intensity = Rgb<double>(0.1 + 0.2 + 0.5 * 0.4 + 0.25 * 0.8 * 0.6);
    tree.rays[1].shadow->light = "b";
    tree.rays[1].diffuse = Rgb<double>(0.15);
    tree.rays[1].specular = Rgb<double>(0.05);
    tree.rays[2].hit.reset();
    tree.rays[2].intensity = Rgb<double>(0.4);
    tree.rays[3].attenuation = 0.8;
    tree.rays[3].ambient = tree.rays[3].intensity = Rgb<double>(0.6);
    tree.rays[3].skipped = {{RayKind::reflected, "", Reason::not_reflective},
                            {RayKind::refracted, "", Reason::not_transmissive}};
    return tree;
}

const std::vector<std::string> lights = {"a", "b"};

/// Balls of glass that also mirror, between two walls that do, before the one pixel's camera.
Scene mirrors_and_glass(double aside) {
    Scene scene;
    scene.camera = test::one_pixel_camera();
    Material glass;
    glass.kr = Colour(0.3);
    glass.kt = {0.6, 0.7, 0.5};
    test::add_material(scene, glass);
    test::add(scene, Sphere{{aside, 0.2, 0}, 1});
    test::add(scene, Sphere{{-aside, 0.1, -3}, 0.7});
    for (const double z : {-5.0, 7.0}) {
        test::add(scene, Polygon{{{-9, -9, z}, {9, -9, z}, {9, 9, z}, {-9, 9, z}}, {}});
    }
    scene.lights.push_back({"a", Colour(0.8), PointLight{{3, 4, 5}, {}}});
    scene.lights.push_back({"b", Colour(0.3), DirectionalLight{{0, -1, -1}}});
    return scene;
}

}  // namespace

TEST_CASE("schedule: depth first, every branch is followed to its end before the next") {
    const Schedule schedule(small_tree(), StepOrder::depth_first, lights);
    const std::vector<TreeEvent> expected = {
        {Kind::sent, 0, 0},    {Kind::found, 0, 0},     {Kind::skipped, 0, 0},
        {Kind::sent, 1, 0},    {Kind::found, 1, 0},     {Kind::evaluated, 1, 0},
        {Kind::sent, 2, 0},    {Kind::found, 2, 0},     {Kind::evaluated, 2, 0},
        {Kind::sent, 3, 0},    {Kind::found, 3, 0},     {Kind::skipped, 3, 0},
        {Kind::skipped, 3, 1}, {Kind::evaluated, 3, 0}, {Kind::evaluated, 0, 0}};
    CHECK(schedule.events() == expected);
    CHECK(schedule.stops().front() == 1);
    CHECK(schedule.stops().size() == expected.size());
}

TEST_CASE("schedule: lights are asked in the scene's order; of unknown ones, rays come first") {
    const std::vector<std::string> other_way = {"b", "a"};
    const RayTree<double> tree = small_tree();
    const TreeEvent skip{Kind::skipped, 0, 0};
    CHECK(Schedule(tree, StepOrder::depth_first, other_way).events()[5] == skip);
    CHECK(Schedule(tree, StepOrder::depth_first).events()[5] == skip);
}

TEST_CASE("schedule: level by level, rays go down and intensities come up") {
    const Schedule schedule(small_tree(), StepOrder::level_by_level, lights);
    const std::vector<TreeEvent> expected = {
        {Kind::sent, 0, 0},      {Kind::found, 0, 0},     {Kind::skipped, 0, 0},
        {Kind::sent, 1, 0},      {Kind::found, 1, 0},     {Kind::evaluated, 1, 0},
        {Kind::sent, 2, 0},      {Kind::sent, 3, 0},      {Kind::found, 2, 0},
        {Kind::found, 3, 0},     {Kind::skipped, 3, 0},   {Kind::skipped, 3, 1},
        {Kind::evaluated, 2, 0}, {Kind::evaluated, 3, 0}, {Kind::evaluated, 0, 0}};
    CHECK(schedule.events() == expected);
    CHECK(schedule.stops() == std::vector<std::size_t>{1, 6, 8, 12, 14, 15});
}

TEST_CASE("schedule: how much of a ray has happened") {
    const Schedule schedule(small_tree(), StepOrder::depth_first, lights);
    CHECK(schedule.stage(0, 0) == Stage::unsent);
    CHECK(schedule.stage(0, 1) == Stage::sent);
    CHECK(schedule.stage(0, 2) == Stage::found);
    CHECK(schedule.stage(0, 14) == Stage::found);
    CHECK(schedule.stage(0, 15) == Stage::evaluated);
    CHECK(schedule.stage(2, 6) == Stage::unsent);
    CHECK(schedule.stage(2, 7) == Stage::sent);
    CHECK(schedule.stage(2, 9) == Stage::evaluated);
    CHECK(schedule.stage(99, 15) == Stage::unsent);
    CHECK_FALSE(schedule.decided(3, 1, 12));
    CHECK(schedule.decided(3, 1, 13));
}

TEST_CASE("schedule: the call stack and what its sums have come to") {
    const RayTree<double> tree = small_tree();
    const Schedule schedule(tree, StepOrder::depth_first, lights);
    CHECK(open_calls(tree, schedule, 0).empty());
    const auto begun = open_calls(tree, schedule, 1);
    REQUIRE(begun.size() == 1);
    CHECK_FALSE(begun[0].child);
    CHECK(begun[0].sum == Rgb<double>());

    const auto to_light = open_calls(tree, schedule, 4);
    REQUIRE(to_light.size() == 2);
    CHECK(to_light[0].child == 1);
    CHECK(to_light[0].sum.r == Approx(0.1));
    CHECK(open_calls(tree, schedule, 6)[0].sum.r == Approx(0.3));
    CHECK(open_calls(tree, schedule, 9)[0].sum.r == Approx(0.3 + 0.2));

    const auto last = open_calls(tree, schedule, 12);
    REQUIRE(last.size() == 2);
    CHECK(last[1].ray == 3);
    CHECK(last[1].sum.r == Approx(0.6));
    const auto summed = open_calls(tree, schedule, 14);
    REQUIRE(summed.size() == 1);
    CHECK_FALSE(summed[0].child);
    CHECK(summed[0].sum.r == Approx(tree.rays[0].intensity.r));
    CHECK(open_calls(tree, schedule, 15).empty());
}

TEST_CASE("schedule: without shadow rays the lights' share is there with the hit") {
    RayTree<double> tree = small_tree();
    tree.rays.resize(1);
    tree.rays[0].diffuse = Rgb<double>(0.3);
    const Schedule schedule(tree, StepOrder::depth_first, lights);
    CHECK(open_calls(tree, schedule, 2)[0].sum.r == Approx(0.4));
}

TEST_CASE("schedule: of traced trees, sums come to the intensities that the tracer found") {
    std::size_t most = 0;
    for (const double aside : {0.0, 0.2, 0.5}) {
        const Scene scene = mirrors_and_glass(aside);
        const World<double> world(scene);
        const auto tree = record_tree(world, 0, 0);
        most = std::max(most, tree.rays.size());
        for (const auto order : {StepOrder::depth_first, StepOrder::level_by_level}) {
            const Schedule schedule(tree, order, lights);
            std::size_t events = 3 * tree.rays.size();
            for (const auto& one : tree.rays) {
                events += one.skipped.size();
            }
            REQUIRE(schedule.events().size() == events);
            for (std::size_t happened = 0; happened < events; ++happened) {
                const TreeEvent& next = schedule.events()[happened];
                const TreeRay<double>& of = tree.rays[next.ray];
                if (next.kind == Kind::evaluated && of.hit) {
                    const auto calls = open_calls(tree, schedule, happened);
                    const auto call = std::ranges::find(calls, next.ray, &OpenCall::ray);
                    REQUIRE(call != calls.end());
                    CHECK(call->sum.g == Approx(of.intensity.g).epsilon(1e-12));
                }
            }
        }
    }
    CHECK(most > 20);
}
