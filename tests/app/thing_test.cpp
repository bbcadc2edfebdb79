// Objects and lights that are selected, and the rays that have to do with them.

#include "state/thing.h"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include "app/scenes.h"
#include "drawing/picking.h"
#include "drawing/ray_mesh.h"
#include "drawing/standard_views.h"
#include "state/commands.h"
#include "state/emphasis.h"
#include "state/table.h"
#include "state/thing_details.h"

namespace raytree::inspector {
namespace {

constexpr auto object = Thing::Kind::object, light = Thing::Kind::light;

State shown() {
    State state;
    state.show(test::opened(test::glass_ball_scene()));
    state.pick({40, 30});
    state.poll(std::chrono::seconds(10));
    REQUIRE(state.tree());
    return state;
}

TEST_CASE("app: a ray ends at an object, at a light, or nowhere") {
    const State state = shown();
    const Scene& scene = state.document()->scene();
    for (const TreeRay<double>& ray : state.tree()->tree.rays) {
        const auto end = thing_at_end_of(scene, ray);
        if (ray.hit) {
            REQUIRE(end);
            CHECK(end->kind == object);
            CHECK(name_of(scene, *end) == ray.hit->object);
            CHECK(concerns(scene, *end, ray));
        } else if (!ray.shadow) {
            CHECK_FALSE(end);
        } else {
            CHECK(name_of(scene, *end) ==
                  (ray.shadow->blocked_by ? ray.shadow->blocked_by->object : ray.shadow->light));
            CHECK(concerns(scene, *light_named(scene, ray.shadow->light), ray));
        }
    }
}

TEST_CASE("app: a mesh's triangles are the mesh, and other names with a # are themselves") {
    Scene scene = test::glass_ball_scene();
    raytree::Mesh mesh;
    mesh.vertices = {{-1, 0, 2}, {1, 0, 2}, {0, 2, 2}};
    mesh.triangles = {{{{0, -1}, {1, -1}, {2, -1}}}};
    scene.objects.push_back({"gem", 1, {}, mesh});
    scene.objects.push_back({"ball #2", 0, {}, Sphere{{9, 9, 9}, 1}});
    CHECK(object_named(scene, "gem#0") == Thing{object, 3});
    CHECK(object_named(scene, "gem") == Thing{object, 3});
    CHECK(object_named(scene, "ball #2") == Thing{object, 4});
    CHECK_FALSE(object_named(scene, "ball#x"));
    TreeRay<double> ray;
    ray.hit.emplace();
    ray.hit->object = "gem#0";
    CHECK(concerns(scene, {object, 3}, ray));
    CHECK(met_by(ray) == "gem");
}

TEST_CASE("app: a thing stays selected from pixel to pixel, until a ray is") {
    State state = shown();
    int told = 0;
    state.observe([&](const Changes& changes) { told += changes.selection ? 1 : 0; });
    run_command(state, "object.select", "ball");
    CHECK(state.thing() == Thing{object, 0});
    CHECK(told == 1);
    state.pick({41, 30});
    CHECK(state.thing() == Thing{object, 0});
    run_command(state, "light.next");
    CHECK(state.thing() == Thing{light, 0});
    run_command(state, "light.next");
    run_command(state, "light.next");
    CHECK(state.thing() == Thing{light, 0});
    state.select(0);  // the ray that is selected beneath it
    CHECK_FALSE(state.thing());
    run_command(state, "thing.at_end");
    CHECK(name_of(state.document()->scene(), *state.thing()) == state.selected()->hit->object);
    run_command(state, "thing.none");
    CHECK_FALSE(state.thing());
    CHECK_THROWS_AS(run_command(state, "object.select", "no such ball"), InputError);
}

TEST_CASE("app: a thing that another scene does not have is no longer selected") {
    State state = shown();
    run_command(state, "object.select", "mirror");
    Scene smaller = test::glass_ball_scene();
    smaller.objects.resize(1);
    state.show(test::opened(smaller));
    CHECK_FALSE(state.thing());
}

TEST_CASE("app: the rays of a thing keep their colour and are listed in its details") {
    State state = shown();
    run_command(state, "light.select", "key");
    const auto aside = set_aside(state);
    const auto marked = emphasis_of(state).marked;
    std::size_t to_key = 0;
    for (const TreeRay<double>& ray : state.tree()->tree.rays) {
        const bool concerned = ray.shadow && ray.shadow->light == "key";
        CHECK(aside[ray.id] != concerned);
        CHECK(marked[ray.id] == concerned);
        to_key += concerned ? 1 : 0;
    }
    CHECK(to_key > 0);
    const auto sections = details_of(state.document()->scene(), state.tree().get(), *state.thing());
    CHECK(sections.front().rows.size() == to_key);
    for (const DetailRow& row : sections.front().rows) {
        CHECK(state.tree()->tree.rays[row.rays.front()].shadow->light == "key");
    }
}

TEST_CASE("app: a mesh's extent and a transform's columns are in an object's details") {
    Scene scene = test::glass_ball_scene();
    raytree::Mesh mesh;
    mesh.vertices = {{-1, 0, 2}, {3, 0, 2}, {0, 5, -4}};
    mesh.triangles = {
        {raytree::Mesh::Corner{0}, raytree::Mesh::Corner{1}, raytree::Mesh::Corner{2}}};
    // A quarter turn about z, and then 7 to the right.
    const Affine quarter_turn = {{{0, -1, 0, 7}, {1, 0, 0, 0}, {0, 0, 1, 0}}};
    scene.objects.push_back({"net", 0, quarter_turn, mesh});
    const auto sections = details_of(scene, nullptr, {object, scene.objects.size() - 1});
    const auto values = [&](const std::string& label) {
        for (const DetailSection& section : sections) {
            for (const DetailRow& row : section.rows) {
                if (row.label == label) {
                    return row.values;
                }
            }
        }
        return std::vector<double>();
    };
    CHECK(values("from") == std::vector<double>{-1, 0, -4});
    CHECK(values("to") == std::vector<double>{3, 5, 2});
    CHECK(values("x axis goes to") == std::vector<double>{0, 1, 0});
    CHECK(values("y axis goes to") == std::vector<double>{-1, 0, 0});
    CHECK(values("origin goes to") == std::vector<double>{7, 0, 0});
}

TEST_CASE("app: a point is hidden where something stands before it") {
    const auto document = test::document_of(test::glass_ball_scene());  // the ball: (0, 1, 0), 1
    View view;
    view.eye = {0, 1, 8};
    view.target = {0, 1, 0};
    CHECK_FALSE(is_hidden(*document, view, {0, 1, 1}));  // on the ball, in front
    CHECK_FALSE(is_hidden(*document, view, {0, 1, 3}));
    CHECK(is_hidden(*document, view, {0, 1, 0}));
    CHECK(is_hidden(*document, view, {0, 1, -1}));  // on the ball, behind
    CHECK_FALSE(is_hidden(*document, view, {1.5, 1, -1}));
    view.cut = 8;  // the half towards the viewer is cut away
    CHECK_FALSE(is_hidden(*document, view, {0, 1, -0.5}));
    CHECK_FALSE(is_hidden(*document, view, {0, 1, 7.9}));
}

TEST_CASE("app: lights and objects are found where they are drawn") {
    const auto document = test::document_of(test::glass_ball_scene());
    const Extent extent = extent_of(*document);
    View view;
    view.width = 800;
    view.height = 600;
    view = camera_view(*document, extent, view);
    const auto ball = project(view, {0, 1, 0});
    CHECK(object_at(*document, view, ball->x, ball->y) == Thing{object, 0});
    const auto mirror = project(view, {1.6, 2.5, -3});
    CHECK(object_at(*document, view, mirror->x, mirror->y) == Thing{object, 2});
    CHECK_FALSE(object_at(*document, view, 5, 5));
    view = side_view(*document, extent, {}, view);
    for (std::size_t k = 0; k < 2; ++k) {
        const auto at = project(view, place_of(document->scene().lights[k], extent));
        CHECK(light_at(document->scene(), extent, view, at->x + 3, at->y, 9) == Thing{light, k});
        CHECK_FALSE(light_at(document->scene(), extent, view, at->x + 30, at->y, 9));
    }
    // What is projected to a place is in the direction through it.
    const Point3 p{0.3, 0.8, -1};
    const auto at = project(view, p);
    CHECK(glm::length(glm::cross(direction_through(view, at->x, at->y),
                                 glm::normalize(p - view.eye))) < 1e-12);
}

bool is_inside(const View& view, const Box& box) {
    for (int k = 0; k < 8; ++k) {
        const Point3 corner{k & 1 ? box.max.x : box.min.x, k & 2 ? box.max.y : box.min.y,
                            k & 4 ? box.max.z : box.min.z};
        const auto at = project(view, corner);
        if (!at || at->x < 0 || at->x > view.width || at->y < 0 || at->y > view.height) {
            return false;
        }
    }
    return true;
}

TEST_CASE("app: the first view shows what stands in the midst of the scene whole") {
    View view;
    view.width = 640;
    view.height = 410;
    const auto document = test::document_of(test::glass_ball_scene());
    view = side_view(*document, extent_of(*document), {}, view);
    CHECK(is_inside(view, document->world().shapes.shapes().bounds(0)));
}

TEST_CASE("app: what the near plane cuts away is not taken for what the camera sees") {
    Scene scene = test::glass_ball_scene();
    const double cut = length(scene.camera.look_at - scene.camera.eye);
    scene.camera.near = cut;  // the front half of the ball is gone
    const Extent whole = extent_of(*test::document_of(test::glass_ball_scene()));
    const Extent behind = extent_of(*test::document_of(scene));
    CHECK(behind.plane_distance > whole.plane_distance);
}

TEST_CASE("app: a thing fills the view that is fitted to it") {
    const auto document = test::document_of(test::glass_ball_scene());
    const Extent extent = extent_of(*document);
    const auto corners = corners_of(*document, extent, {object, 0});
    REQUIRE(corners.size() == 8);
    for (const Point3& corner : corners) {
        CHECK(glm::length(corner - Point3(0, 1, 0)) == doctest::Approx(std::sqrt(3)).epsilon(1e-5));
    }
    // A floor far larger than the scene is not fitted as a whole.
    for (const Point3& corner : corners_of(*document, extent, {object, 1})) {
        CHECK(glm::length(corner - extent.seen.centre()) < 2 * extent.diagonal);
    }
}

TEST_CASE("app: the selected object is drawn in the colour of the selection") {
    const auto document = test::document_of(test::glass_ball_scene());
    const Extent extent = extent_of(*document);
    const SceneMesh mesh = scene_mesh(*document, extent, 0.002 * extent.diagonal);
    const Palette& palette = palette_of(Theme::light);
    const auto lines = [&](std::optional<Thing> thing) {
        return landmarks({*document, nullptr, {40, 30}, extent, View(), palette, thing, &mesh})
            .lines.segments.size();
    };
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(lines(Thing{object, k}) == lines({}) + 2 * mesh.objects[k].wires);
        CHECK(mesh.objects[k].wires > 3);
    }
}

}  // namespace
}  // namespace raytree::inspector
