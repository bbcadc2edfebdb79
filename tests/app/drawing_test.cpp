#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include "app/scenes.h"
#include "drawing/coverage.h"
#include "drawing/ground.h"
#include "drawing/polygon_fill.h"
#include "drawing/ray_mesh.h"
#include "drawing/scene_mesh.h"
#include "support/scenes.h"
#include "tree/explain.h"
#include "tree/record.h"

namespace raytree::inspector {
namespace {

View square_view() {
    View view;
    view.eye = {0, 0, 5};
    view.width = view.height = 400;
    view.fov_degrees = 2 * 180 / std::acos(-1.0) * std::atan(0.2);  // 2 units high at the origin
    return view;
}

double area_of(const std::vector<std::array<Point3, 3>>& triangles) {
    double area = 0;
    for (const auto& [a, b, c] : triangles) {
        area += glm::length(glm::cross(b - a, c - a)) / 2;
    }
    return area;
}

TEST_CASE("app: the target is in the middle of the screen, up is up, right is right") {
    const View view = square_view();
    const auto middle = project(view, {0, 0, 0});
    CHECK(middle->x == doctest::Approx(200));
    CHECK(middle->y == doctest::Approx(200));
    CHECK(project(view, {0, 1, 0})->y == doctest::Approx(0));
    CHECK(project(view, {1, 0, 0})->x == doctest::Approx(400));
    CHECK(length_per_pixel(view, {0, 0, 0}) == doctest::Approx(0.005));
    CHECK_FALSE(project(view, {0, 0, 6}));
}

TEST_CASE("app: turning keeps the distance, moving moves by pixels, zooming doubles") {
    const View view = square_view();
    const View turned = orbited(view, 30, 20);
    CHECK(glm::length(turned.eye - turned.target) == doctest::Approx(5));
    CHECK(turned.eye.y > 0);  // dragged down: seen from further above
    CHECK(project(panned(view, 10, 20), {0, 0, 0})->x == doctest::Approx(210));
    CHECK(project(panned(view, 10, 20), {0, 0, 0})->y == doctest::Approx(180));
    CHECK(project(zoomed(view, 2), {0.25, 0, 0})->x == doctest::Approx(300));
    // Straight down is not gone beyond.
    CHECK(orbited(view, 0, 500).eye.y < 5);
}

TEST_CASE("app: what is fitted fills the screen but for the margin") {
    View view = square_view();
    view.width = 800;
    for (const View& from : {view, orbited(view, 40, 25), orbited(view, -120, -10)}) {
        const Span3 box{{-1, -2, -0.5}, {3, 1, 4}};
        const auto corners = box.corners();
        const View fit = fitted(from, corners, 0.1);
        double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
        for (const Point3& corner : corners) {
            const auto at = project(fit, corner);
            REQUIRE(at);
            left = std::min(left, at->x);
            right = std::max(right, at->x);
            top = std::min(top, at->y);
            bottom = std::max(bottom, at->y);
        }
        CHECK(left >= 39.9);
        CHECK(right <= 760.1);
        CHECK(top >= 19.9);
        CHECK(bottom <= 380.1);
        // It touches the margin in one direction.
        CHECK((bottom - top > 355 || right - left > 715));
    }
}

TEST_CASE("app: balls are told to stand before a thing where they may hide some of it") {
    const View view = square_view();
    Mesh thing;
    add_ball(thing, {0.2, 0.1, 0}, 0.1, {});
    Coverage covered(view);
    CHECK_FALSE(covered.is_behind({0.2, 0.1, 1}, 0.1));
    covered.add(thing);
    for (std::size_t k = 0; k < thing.points.size(); k += 3) {
        const Point3 point(thing.points[k], thing.points[k + 1], thing.points[k + 2]);
        for (const double nearer : {0.02, 0.3, 0.9}) {
            CHECK(covered.is_behind(point + nearer * (view.eye - point), 0.01));
        }
    }
    CHECK_FALSE(covered.is_behind({0.2, 0.1, -1}, 0.1));  // farther away
    CHECK_FALSE(covered.is_behind({-0.5, 0.1, 2}, 0.1));  // beside it
    CHECK(covered.is_behind({0.2, 0.1, -1}, 1.5));        // around it
}

TEST_CASE("app: convex and concave polygons are filled with their own area") {
    const Polygon square{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, {}};
    CHECK(filled(square).size() == 2);
    CHECK(area_of(filled(square)) == doctest::Approx(4));
    const Polygon arrow{{{0, 0, 1}, {2, 2, 1}, {4, 0, 1}, {2, 5, 1}}, {}};
    CHECK(area_of(filled(arrow)) == doctest::Approx(6));
    for (const auto& triangle : filled(arrow)) {
        for (const Point3& corner : triangle) {
            CHECK(corner.z == doctest::Approx(1));
        }
    }
    // A five-pointed star drawn in one line: its middle is outside by the crossing rule.
    Polygon star;
    for (int k = 0; k < 5; ++k) {
        const double angle = 4 * std::acos(-1.0) * k / 5;
        star.vertices.emplace_back(std::sin(angle), 0, std::cos(angle));
    }
    const double outer = 5 * std::sin(0.4 * std::acos(-1.0)) / 2;
    CHECK(area_of(filled(star)) < 0.6 * outer);
    CHECK(area_of(filled(star)) > 0.2 * outer);
}

TEST_CASE("app: an outline is clipped where a plane cuts it") {
    const std::vector<Point3> square = {{-9, 0, -9}, {9, 0, -9}, {9, 0, 9}, {-9, 0, 9}};
    const auto kept = clipped(square, {1, 0, 0}, 2);
    CHECK(kept.size() == 4);
    for (const Point3& p : kept) {
        CHECK(p.x <= 2);
    }
    CHECK(clipped(square, {0, -1, 0}, 1).size() == 4);
    CHECK(clipped(square, {0, 1, 0}, -1).empty());
}

TEST_CASE("app: a floor that goes on for ever fades to nothing on a circle") {
    Extent extent;
    extent.seen = {{-3, 0, -4}, {3, 0, 4}};
    extent.diagonal = 10;
    const Ground ground(extent);
    const Ground::Triangle floor{Point3(-1e3, 0, -1e3), Point3(1e3, 0, -1e3), Point3(0, 0, 2e3)};
    CHECK_FALSE(ground.is_firm(floor));
    CHECK(ground.is_firm({Point3(-1, 0, -1), Point3(1, 0, -1), Point3(0, 0, 2)}));
    double farthest = 0;
    const auto facets = ground.facets(floor, {0, 1, 0});
    for (const Ground::Triangle& facet : facets) {
        for (const Point3& corner : facet) {
            farthest = std::max(farthest, glm::length(corner));
            CHECK(corner.y == 0);
        }
    }
    // Nothing lies beyond the rim but the corners of the outline around its circle.
    CHECK(farthest < 9.02);
    CHECK(ground.firmness({0, 0, 9}) == 0);
    CHECK(ground.firmness({0, 0, 3}) == 1);
    const double pi = std::acos(-1.0);
    CHECK(area_of(facets) == doctest::Approx(81 * pi).epsilon(0.002));
    for (const auto& [from, to] : ground.grid(floor, {0, 1, 0})) {
        CHECK(glm::length(to - from) < 0.61);
        CHECK(std::abs(std::remainder(from.x, 1)) + std::abs(std::remainder(from.z, 1)) < 1.01);
    }
}

TEST_CASE("app: of a see-through ball the far side is drawn before the near one") {
    const auto document = test::document_of(test::glass_ball_scene());
    const Extent extent = extent_of(*document);
    const SceneMesh mesh = scene_mesh(*document, extent, 0.002 * extent.diagonal);
    for (const Point3& eye : {Point3(0, 3, 9), Point3(8, 1, -4), Point3(-6, 7, 0.5)}) {
        for (std::size_t k = 0; k < mesh.objects.size(); ++k) {
            if (mesh.objects[k].flat || mesh.objects[k].count < 100) {
                continue;
            }
            const std::vector<std::size_t> one{k};
            const auto triangles = triangles_of(mesh, one, eye);
            bool near_side = false;
            for (std::size_t at = 0; at < triangles.size(); at += 3) {
                const auto corner = 3 * static_cast<std::size_t>(triangles[at]);
                const Point3 p(mesh.faces.points[corner], mesh.faces.points[corner + 1],
                               mesh.faces.points[corner + 2]);
                const bool faces_eye = glm::dot(p - mesh.objects[k].centre, eye - p) > 1e-5;
                CHECK_FALSE((near_side && glm::dot(p - mesh.objects[k].centre, eye - p) < -1e-5));
                near_side |= faces_eye;
            }
            CHECK(near_side);
        }
    }
}

TEST_CASE("app: the extent is of what is seen, not of a floor that goes on for ever") {
    Scene scene = test::glass_ball_scene();
    auto& floor = std::get<Polygon>(scene.objects[1].shape);
    for (Point3& vertex : floor.vertices) {
        vertex *= 1000;
    }
    const Extent extent = extent_of(*test::document_of(scene));
    CHECK(extent.diagonal > 2);
    CHECK(extent.diagonal < 40);
    CHECK(extent.seen.contains({0, 1, 0}));
    CHECK(extent.plane_distance > 0);
    CHECK(extent.plane_distance < 5);
}

TEST_CASE("app: things far behind others count where they take a good part of the picture") {
    Scene scene = test::glass_ball_scene();
    scene.objects.clear();
    scene.camera.eye = {0, 0, 0};
    scene.camera.look_at = {0, 0, -1};
    raytree::test::add(scene, Sphere{{0.3, 0, -2}, 0.5}, 0);
    const auto with_balls = [&](double radius) {
        Scene both = scene;
        for (const double x : {-8.0, -4.0}) {
            raytree::test::add(both, Sphere{{x, 1, -24}, radius}, 0);
        }
        return extent_of(*test::document_of(std::move(both)));
    };
    const Extent large = with_balls(3), small = with_balls(0.3);
    CHECK(large.seen.contains({-4, 1, -24}));
    CHECK(large.seen.contains({0.3, 0, -2}));
    CHECK_FALSE(small.seen.contains({-4, 1, -24}));
    CHECK(small.diagonal < 4);
}

TEST_CASE("app: a scene without anything to see still has an extent") {
    Scene scene = test::glass_ball_scene();
    scene.objects.clear();
    const auto document = test::document_of(scene);
    const Extent extent = extent_of(*document);
    CHECK(extent.diagonal > 0);
    CHECK(scene_mesh(*document, extent, 0.002 * extent.diagonal).faces.triangle_count() == 0);
}

TEST_CASE("app: the picture stands where its rays pass through its pixels") {
    for (const PixelSample sample : {PixelSample::center, PixelSample::corner}) {
        Scene scene = test::glass_ball_scene();
        scene.settings.pixel_sample = sample;
        const auto document = test::document_of(scene);
        const auto corners = picture_corners(*document, 2);
        const Point3 across = corners[1] - corners[0], down = corners[3] - corners[0];
        const double off = sample == PixelSample::center ? 0.5 : 0;
        const Point3 place = place_on_picture(*document, {20, 45}, 2);
        const Point3 expected = corners[0] + across * ((20 + off) / 80) + down * ((45 + off) / 60);
        CHECK(glm::length(place - expected) < 1e-12);
        const auto ray = document->world().camera.primary(20, 45);
        CHECK(glm::length(glm::cross(place - ray.origin, ray.direction)) < 1e-12);
    }
}

struct Traced {
    std::shared_ptr<const Document> document;
    PixelTree tree;
    Extent extent;
};

Traced traced() {
    Traced result;
    result.document = test::document_of(test::glass_ball_scene());
    result.tree.tree = record_tree(result.document->world(), 40, 30);
    result.tree.children = children_of(result.tree.tree);
    result.extent = extent_of(*result.document);
    return result;
}

TEST_CASE("app: rays are drawn from where they start to what they meet") {
    const Traced t = traced();
    const auto paths = ray_paths(t.tree, t.extent, {});
    REQUIRE(paths.size() == t.tree.tree.rays.size());
    for (const RayPath& path : paths) {
        const TreeRay<double>& ray = t.tree.tree.rays[path.ray];
        CHECK(path.from == ray.origin);
        if (ray.hit) {
            CHECK(path.to == ray.hit->point);
            CHECK(path.end == RayPath::End::hit);
        } else if (!ray.shadow) {
            CHECK(path.end == RayPath::End::open);
            CHECK(path.fades);
            CHECK(glm::length(path.to - path.from) == doctest::Approx(0.25 * t.extent.diagonal));
        } else if (ray.shadow->blocked_by) {
            CHECK(path.end == RayPath::End::blocked);
            CHECK(glm::length(path.to - path.from) == doctest::Approx(ray.shadow->blocked_by->t));
        } else if (ray.shadow->light == "key") {
            CHECK(glm::length(path.to - Point3(3, 6, 4)) < 1e-9);
        } else {
            CHECK(path.fades);  // the sun is infinitely far away
        }
    }
}

TEST_CASE("app: hidden kinds are not drawn, and of too many rays the weightiest are") {
    const Traced t = traced();
    RayFilter filter;
    filter.set(group_of(RayKind::shadow), Shown::hidden);
    for (const RayPath& path : ray_paths(t.tree, t.extent, filter)) {
        CHECK_FALSE(path.dashed());
    }
    const auto few = ray_paths(t.tree, t.extent, {}, 3);
    REQUIRE(few.size() == 3);
    CHECK(few[0].ray == 0);
}

TEST_CASE("app: the ray that is drawn at a place on the screen is found there") {
    const View view = square_view();
    const std::vector<RayPath> paths = {{0, RayLook::primary, {-1, 0, 0}, {1, 0, 0}},
                                        {1, RayLook::reflected, {0, -1, 0}, {0, 1, 0}},
                                        {2, RayLook::lit, {0.5, 0.5, 0}, {0.5, 0.5, 20}}};
    CHECK(path_at(paths, view, 100, 203, 8) == 0);
    CHECK(path_at(paths, view, 203, 100, 8) == 1);
    CHECK(path_at(paths, view, 302, 98, 8) == 2);  // ends behind the viewer
    CHECK_FALSE(path_at(paths, view, 100, 100, 8));
}

/// How many corners have a colour.
std::size_t corners_of(const Mesh& mesh, Ink ink) {
    std::size_t count = 0;
    for (std::size_t k = 0; k < mesh.colours.size(); k += 4) {
        count += mesh.colours[k] == ink.r && mesh.colours[k + 1] == ink.g &&
                 mesh.colours[k + 2] == ink.b;
    }
    return count;
}

void check_sound(const Mesh& mesh) {
    const auto points = static_cast<std::int32_t>(mesh.points.size() / 3);
    CHECK(mesh.normals.size() == mesh.points.size());
    CHECK(mesh.colours.size() / 4 == mesh.points.size() / 3);
    CHECK(std::ranges::all_of(mesh.points, [](float x) { return std::isfinite(x); }));
    CHECK(std::ranges::all_of(mesh.normals, [](float x) { return std::isfinite(x); }));
    CHECK(
        std::ranges::all_of(mesh.triangles, [&](std::int32_t k) { return k >= 0 && k < points; }));
}

TEST_CASE("app: every kind of ray that a tree has is drawn in its colour") {
    const Traced t = traced();
    const auto paths = ray_paths(t.tree, t.extent, {});
    const Palette& palette = palette_of(Theme::light);
    const RayMeshes meshes = ray_meshes({paths, t.tree, 0, t.extent, square_view(), palette});
    for (const RayPath& path : paths) {
        CHECK(corners_of(meshes.solid, palette[path.look]) +
                  corners_of(meshes.fading, palette[path.look]) >
              0);
    }
    CHECK(corners_of(meshes.halo, palette.selection) > 0);
    check_sound(meshes.solid);
    check_sound(meshes.fading);
    check_sound(meshes.halo);
    // Where an object or a light is selected, the ray beneath it looks like the others.
    const RayMeshes beneath =
        ray_meshes({paths, t.tree, 0, t.extent, square_view(), palette, {}, false});
    CHECK(beneath.halo.points.empty());
    CHECK(beneath.solid.triangle_count() == meshes.solid.triangle_count());
}

TEST_CASE("app: rays beside the selected one are set aside") {
    const Traced t = traced();
    const auto paths = ray_paths(t.tree, t.extent, {});
    const Palette& palette = palette_of(Theme::light);
    const View view = square_view();
    const auto whole = ray_meshes({paths, t.tree, 0, t.extent, view, palette});
    const auto one = ray_meshes({paths, t.tree, t.tree.children[0][0], t.extent, view, palette});
    CHECK(one.solid.triangle_count() < whole.solid.triangle_count());
    CHECK(one.fading.triangle_count() > whole.fading.triangle_count());
}

TEST_CASE("app: too many rays for tubes are drawn as lines") {
    const Traced t = traced();
    const std::vector<RayPath> paths(most_tubes + 1,
                                     RayPath{1, RayLook::reflected, {0, 0, 0}, {1, 1, 1}});
    const auto meshes =
        ray_meshes({paths, t.tree, 0, t.extent, square_view(), palette_of(Theme::light)});
    CHECK(meshes.solid.triangle_count() == 0);
    CHECK(meshes.lines.segments.size() == 2 * paths.size());
}

TEST_CASE("app: all shapes of a scene are drawn, and drawing order only sorts them") {
    Scene scene = test::glass_ball_scene();
    scene.objects.push_back({"cone", 1, {}, Cone{{2, 0, 0}, {2, 2, 0}, 0.5, 0}});
    scene.objects.push_back(
        {"egg", 1, Affine{{{1, 0, 0, -2}, {0, 2, 0, 1}, {0, 0, 1, 0}}}, Sphere{{0, 0, 0}, 0.5}});
    const auto document = test::document_of(scene);
    const Extent extent = extent_of(*document);
    const SceneMesh mesh = scene_mesh(*document, extent, 0.002 * extent.diagonal);
    CHECK(mesh.objects.size() == 5);
    check_sound(mesh.faces);
    CHECK_FALSE(mesh.wires.segments.empty());
    auto sorted = triangles_of(mesh, drawing_order(mesh, extent, {0, 3, 9}), {0, 3, 9});
    auto all = mesh.faces.triangles;
    REQUIRE(sorted.size() == all.size());
    std::ranges::sort(sorted);
    std::ranges::sort(all);
    CHECK(sorted == all);
}

TEST_CASE("app: of balls a few pixels large only the side towards the eye is drawn") {
    Scene scene = test::glass_ball_scene();
    scene.objects.push_back({"dot", 1, {}, Sphere{{2, 1, 0}, 0.002}});
    const auto document = test::document_of(scene);
    const Extent extent = extent_of(*document);
    const SceneMesh mesh = scene_mesh(*document, extent, 0.002 * extent.diagonal);
    const ObjectFaces& dot = mesh.objects.back();
    REQUIRE(dot.tiny);
    CHECK(std::ranges::count(mesh.objects, true, &ObjectFaces::tiny) == 1);
    const Point3 eye(0, 3, 9);
    const auto triangles = triangles_of(mesh, std::vector{mesh.objects.size() - 1}, eye);
    CHECK(triangles.size() > 0);
    CHECK(triangles.size() < 3 * dot.count);
    const Point3 middle(2, 1, 0);
    for (std::size_t k = 0; k < triangles.size(); k += 3) {
        Point3 out(0, 0, 0);  // from the ball's middle to that of the triangle, three times
        for (const std::size_t corner : {k, k + 1, k + 2}) {
            const auto at = 3 * static_cast<std::size_t>(triangles[corner]);
            const auto& p = mesh.faces.points;
            out += Point3(p[at], p[at + 1], p[at + 2]) - middle;
        }
        CHECK(glm::dot(out, eye - middle) > -1e-5);
    }
}

TEST_CASE("app: landmarks are there for all lights, with far ones drawn in") {
    Traced t = traced();
    const Extent extent = t.extent;
    Light far = {"far", Colour(1.0), PointLight{{1e6, 0, 0}, {}}};
    CHECK(glm::length(place_of(far, extent) - extent.seen.centre()) <= 3.01 * extent.diagonal);
    const auto marks = landmarks({*t.document,
                                  &t.tree.tree.rays[0],
                                  {40, 30},
                                  extent,
                                  square_view(),
                                  palette_of(Theme::dark)});
    check_sound(marks.solid);
    CHECK(corners_of(marks.solid, palette_of(Theme::dark).light) > 100);
    CHECK(marks.lines.segments.size() == 2 * 12);
}

}  // namespace
}  // namespace raytree::inspector
