// What is drawn at the selected hit.

#include "drawing/angles.h"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>
#include <numbers>

#include "app/scenes.h"
#include "drawing/standard_views.h"
#include "drawing/words.h"
#include "tree/explain.h"
#include "tree/record.h"

namespace raytree::inspector {
namespace {

struct Traced {
    std::shared_ptr<const Document> document;
    PixelTree tree;
    Extent extent;
};

Traced traced(Scene scene, int i = 40, int j = 30) {
    Traced result;
    result.document = test::document_of(std::move(scene));
    result.tree.tree = record_tree(result.document->world(), i, j);
    result.tree.children = children_of(result.tree.tree);
    result.extent = extent_of(*result.document);
    return result;
}

View view_of(const Traced& t) {
    View view;
    view.eye = t.extent.seen.centre() + Point3(4, 2, 5);
    view.target = t.extent.seen.centre();
    view.width = 800;
    view.height = 600;
    return view;
}

AngleDrawing drawn(const Traced& t, std::size_t ray, bool angles = true, bool ghosts = true) {
    return angle_drawing(
        {*t.document, t.tree, ray, t.extent, view_of(t), palette_of(Theme::light), angles, ghosts});
}

bool says(const AngleDrawing& drawing, const std::string& words) {
    return std::ranges::any_of(drawing.words, [&](const DrawnWords& drawn) {
        return drawn.text.find(words) != std::string::npos;
    });
}

TEST_CASE("app: the ways of a mirror and of Snell's law are those that the tracer goes") {
    const Traced t = traced(test::glass_ball_scene(), 47, 33);
    std::size_t compared = 0;
    for (const TreeRay<double>& ray : t.tree.tree.rays) {
        if (!ray.parent || ray.shadow) {
            continue;
        }
        const TreeRay<double>& from = t.tree.tree.rays[*ray.parent];
        const auto& surface = from.hit->interface;
        const auto way =
            ray.kind == RayKind::reflected
                ? std::optional(reflected(from.direction, from.hit->normal))
                : refracted(from.direction, from.hit->normal, surface->eta1, surface->eta2);
        REQUIRE(way);
        CHECK(glm::length(*way - ray.direction) < 1e-12);
        ++compared;
    }
    CHECK(compared >= 4);
    CHECK_FALSE(refracted({0.8, -0.6, 0}, {0, 1, 0}, 1.5, 1));
}

TEST_CASE("app: at a glass hit both angles and both indices are written") {
    const Traced t = traced(test::glass_ball_scene(), 47, 33);
    const TreeHit<double>& hit = *t.tree.tree.rays[0].hit;
    const double sine1 = std::sqrt(1 - hit.cos_incident * hit.cos_incident);
    const double degrees = 180 / std::numbers::pi;
    const AngleDrawing drawing = drawn(t, 0);
    CHECK(says(drawing, "θ₁ = " + number_text(std::asin(sine1) * degrees) + "°"));
    CHECK(says(drawing, "θ₂ = " + number_text(std::asin(sine1 / 1.5) * degrees) + "°"));
    CHECK(says(drawing, "η 1 → 1.5"));
    CHECK_FALSE(says(drawing, "critical"));
    CHECK(drawing.solid.triangle_count() > 0);
    // Arcs stand around the hit, at a distance that is the same on every screen.
    const double pixel = length_per_pixel(view_of(t), hit.point);
    for (std::size_t k = 0; k < drawing.solid.points.size(); k += 3) {
        const Point3 p(drawing.solid.points[k], drawing.solid.points[k + 1],
                       drawing.solid.points[k + 2]);
        CHECK(glm::length(p - hit.point) < 120 * pixel);
    }
    CHECK(drawn(t, 0, false, false).words.empty());
    CHECK(drawn(t, 0, false, false).solid.triangle_count() == 0);
}

TEST_CASE("app: seen onto a hit, angles on the screen are those in space, the ray from the left") {
    const Traced t = traced(test::glass_ball_scene(), 47, 33);
    for (const TreeRay<double>& ray : t.tree.tree.rays) {
        if (!ray.hit || ray.hit->cos_incident > 0.999) {
            continue;
        }
        const View view = hit_view(*t.document, ray, t.extent, view_of(t));
        const auto way = [&](const Point3& direction) {
            const auto at = project(view, ray.hit->point + 1e-3 * direction);
            REQUIRE(at);
            return glm::normalize(Point3(at->x - view.width / 2.0, view.height / 2.0 - at->y, 0));
        };
        const double side = glm::dot(ray.hit->normal, ray.direction) > 0 ? -1 : 1;
        CHECK(way(side * ray.hit->normal).y == doctest::Approx(1));
        CHECK(way(-ray.direction).x < 0);
        CHECK(way(-ray.direction).y == doctest::Approx(std::abs(ray.hit->cos_incident)));
    }
}

TEST_CASE("app: the critical angle is written where it is exceeded") {
    // From inside glass, through the side of a block, at 60 degrees.
    Scene scene = test::glass_ball_scene();
    scene.objects.clear();
    scene.objects.push_back(
        {"wall", 0, {}, Polygon{{{-9, 0, -9}, {9, 0, -9}, {9, 0, 9}, {-9, 0, 9}}, {}}});
    scene.camera.eye = {0, 1, 0};
    scene.camera.look_at = {std::tan(std::numbers::pi / 3), 0, 0};
    Traced t = traced(scene);
    TreeHit<double>& hit = *t.tree.tree.rays[0].hit;
    hit.interface = Interface<double>{1.5, 1, 2.25 * 0.75};
    const AngleDrawing drawing = drawn(t, 0);
    CHECK(says(drawing, "critical angle 41.81° exceeded"));
    CHECK(says(drawing, "η 1.5 → 1"));
    CHECK_FALSE(says(drawing, "θ₂"));
}

TEST_CASE("app: rays that were not sent from the hit are ghosts with their reasons") {
    const Traced t = traced(test::glass_ball_scene(), 40, 55);  // the floor
    REQUIRE(t.tree.tree.rays[0].hit->object == "floor");
    const AngleDrawing drawing = drawn(t, 0);
    CHECK(says(drawing, "not reflected: "));
    CHECK_FALSE(says(drawing, "not refracted: "));  // there is no way that it would have gone
    CHECK(drawing.faint.triangle_count() > 0);
    CHECK_FALSE(says(drawn(t, 0, true, false), "not reflected"));
    // A ray that escapes has no hit.
    for (const TreeRay<double>& ray : traced(test::glass_ball_scene(), 0, 0).tree.tree.rays) {
        CHECK_FALSE(ray.hit);
    }
    CHECK(drawn(traced(test::glass_ball_scene(), 0, 0), 0).words.empty());
}

TEST_CASE("app: many lights that were not asked for the same reason are one ghost's words") {
    Scene scene = test::glass_ball_scene();
    for (int k = 0; k < 5; ++k) {  // below the floor
        Light light = scene.lights.front();
        light.name = "below " + std::to_string(k);
        PointLight lamp;
        lamp.position = {0.1 * k, -50, 0};
        light.kind = lamp;
        scene.lights.push_back(light);
    }
    const Traced t = traced(scene, 40, 55);
    REQUIRE(t.tree.tree.rays[0].hit->object == "floor");
    const AngleDrawing drawing = drawn(t, 0);
    CHECK(says(drawing, "no shadow rays to 5 lights: light behind surface"));
    CHECK_FALSE(says(drawing, "no shadow ray to below"));
}

TEST_CASE("app: the angle of a hidden ray is not drawn, and no ghost where all rays were sent") {
    const Traced t = traced(test::glass_ball_scene(), 47, 33);
    const View view = view_of(t);
    RayFilter filter;
    filter.set(group_of(RayKind::reflected), Shown::hidden);
    const auto all = drawn(t, 0, true, false);
    const auto without = angle_drawing({*t.document, t.tree, 0, t.extent, view,
                                        palette_of(Theme::light), true, false, nullptr, filter});
    CHECK(without.solid.triangle_count() < all.solid.triangle_count());
    CHECK(says(without, "θ₂"));
    const Scene& scene = t.document->scene();
    for (const TreeRay<double>& ray : t.tree.tree.rays) {
        // A ghost says its reason.
        CHECK(has_ghosts(scene, ray, nullptr) ==
              (ray.hit && says(drawn(t, ray.id, false, true), ": ")));
    }
}

TEST_CASE("app: what stepping has not come to is not drawn at the hit") {
    Traced t = traced(test::glass_ball_scene(), 47, 33);
    const auto tree = std::make_shared<PixelTree>(t.tree);
    Playback playback(tree, StepOrder::depth_first, {"key", "sun"});
    const auto at_step = [&](std::size_t stop) {
        playback.go_to(stop);
        const View view = view_of(t);
        return angle_drawing({*t.document, t.tree, 0, t.extent, view, palette_of(Theme::light),
                              true, true, &playback});
    };
    const auto all = drawn(t, 0);
    REQUIRE(says(all, "θ₂"));
    const AngleDrawing first = at_step(1), last = at_step(playback.stops() - 1);
    CHECK(says(first, "θ₁"));
    CHECK_FALSE(says(first, "θ₂"));
    CHECK(first.solid.triangle_count() < last.solid.triangle_count());
    CHECK(last.words.size() == all.words.size());
    CHECK(last.solid.points == all.solid.points);
}

TEST_CASE("app: angles at a hit are drawn smaller where the scene is small on the screen") {
    const Traced t = traced(test::glass_ball_scene(), 47, 33);
    const Point3 at = t.tree.tree.rays[0].hit->point;
    View view = view_of(t);
    CHECK(size_at_hit(t.extent, view, at) <= 1);
    const View near = zoomed(view, 20), far = zoomed(view, 0.2);
    CHECK(size_at_hit(t.extent, near, at) == 1);
    CHECK(size_at_hit(t.extent, far, at) < 0.6);
    CHECK(size_at_hit(t.extent, far, at) > 0.4);
}

TEST_CASE("app: words cover as few rays as they can") {
    const WordBox room{0, 0, 400, 300};
    const WordWish wish{200, 150, std::nullopt, 80, 18};
    const WordBox first = *place_words(wish, room, {});
    CHECK(first.x > 200);  // to the right, where there is nothing
    const WordLine ray{200, 150, 400, 150};
    CHECK(ray.crosses(first));
    const WordBox other = *place_words(wish, room, {}, {ray});
    CHECK_FALSE(ray.crosses(other));
    // Where every place covers one, the first does.
    std::vector<WordLine> everywhere;
    for (int k = 0; k < 40; ++k) {
        everywhere.push_back({0, 8.0 * k, 400, 8.0 * k});
    }
    CHECK(place_words(wish, room, {}, everywhere));
    CHECK_FALSE(WordLine{0, 0, 10, 10}.crosses({20, 0, 10, 10}));
    CHECK(WordLine{-5, 5, 50, 5}.crosses({20, 0, 10, 10}));
    CHECK(WordLine{25, -5, 25, 50}.crosses({20, 0, 10, 10}));
}

TEST_CASE("app: words keep clear of each other and within their room") {
    const WordBox room{0, 0, 400, 300};
    std::vector<WordBox> taken;
    std::size_t placed = 0;
    for (int k = 0; k < 12; ++k) {
        WordWish wish{200, 150, std::nullopt, 80, 18};
        if (k % 2) {
            wish.out = {200 + 50 * std::cos(k), 150 + 50 * std::sin(k)};
        }
        if (const auto box = place_words(wish, room, taken)) {
            CHECK(room.holds(*box));
            for (const WordBox& other : taken) {
                CHECK_FALSE(box->meets(other));
            }
            taken.push_back(*box);
            ++placed;
        }
    }
    CHECK(placed >= 8);
    WordWish wish{200, 150, std::array{300.0, 150.0}, 80, 18};
    wish.far = 0;
    CHECK_FALSE(place_words(wish, room, {{0, 0, 400, 300}}));
    CHECK_FALSE(place_words({-60, -60, std::nullopt, 20, 10}, room, {}));
}

}  // namespace
}  // namespace raytree::inspector
