// What of the selection the 3D view does not show: beyond its edge, or behind something.

#include <doctest/doctest.h>

#include <glm/geometric.hpp>
#include <random>

#include "app/scenes.h"
#include "drawing/edge_place.h"
#include "drawing/picking.h"
#include "drawing/ray_mesh.h"
#include "drawing/standard_views.h"
#include "tree/record.h"

namespace raytree::inspector {
namespace {

View some_view() {
    View view;
    view.eye = {3, 2, 6};
    view.target = {0, 1, 0};
    view.width = 640;
    view.height = 480;
    return view;
}

constexpr WordBox frame{14, 14, 612, 412};

bool is_on_edge(const EdgePlace& place) {
    const double right = frame.x + frame.width, low = frame.y + frame.height;
    const auto near = [](double a, double b) { return std::abs(a - b) < 1e-6; };
    const bool inside = place.x > frame.x - 1e-6 && place.x < right + 1e-6 &&
                        place.y > frame.y - 1e-6 && place.y < low + 1e-6;
    return inside && (near(place.x, frame.x) || near(place.x, right) || near(place.y, frame.y) ||
                      near(place.y, low));
}

TEST_CASE("app: the place of what lies outside continues the line from what is seen") {
    const View view = some_view();
    std::mt19937 random(11);
    std::uniform_real_distribution<double> any(-20, 20), near(-1, 1);
    int continued = 0;
    for (int k = 0; k < 2000; ++k) {
        const Point3 p(any(random), any(random), any(random));
        const Point3 from = view.target + Point3(near(random), near(random), near(random));
        const auto place = edge_place(view, frame, p, from);
        const auto start = project(view, from);
        CHECK(place.has_value() == edge_place(view, frame, p).has_value());
        if (!place || !start || !frame.holds({start->x, start->y, 0, 0})) {
            continue;
        }
        CHECK(is_on_edge(*place));
        // A point of the line a little beyond `from` is seen on the way to the arrow.
        const auto next = project(view, from + (p - from) * 1e-6);
        REQUIRE(next);
        const double dx = next->x - start->x, dy = next->y - start->y;
        const double ex = place->x - start->x, ey = place->y - start->y;
        const double length = std::hypot(dx, dy) * std::hypot(ex, ey);
        if (std::hypot(dx, dy) > 1e-5) {
            CHECK(dx * ex + dy * ey == doctest::Approx(length).epsilon(1e-3));
            ++continued;
        }
    }
    CHECK(continued > 500);
}

TEST_CASE("app: what lies outside the view has a place on its edge, what lies inside has none") {
    const View view = some_view();
    const ViewAxes axes = axes_of(view);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-20, 20);
    int outside = 0;
    for (int k = 0; k < 2000; ++k) {
        const Point3 p(any(random), any(random), any(random));
        const auto seen = project(view, p);
        const auto place = edge_place(view, frame, p);
        REQUIRE(place.has_value() != (seen && frame.holds({seen->x, seen->y, 0, 0})));
        if (!place) {
            continue;
        }
        ++outside;
        CHECK(is_on_edge(*place));
        CHECK(std::hypot(place->dx, place->dy) == doctest::Approx(1));
        if (seen) {  // the arrow's line goes through where it would be seen
            CHECK((seen->x - place->x) * place->dy ==
                  doctest::Approx((seen->y - place->y) * place->dx).epsilon(1e-6));
            CHECK((seen->x - place->x) * place->dx + (seen->y - place->y) * place->dy >= 0);
        } else {  // one turns towards it
            CHECK(place->dx * glm::dot(p - view.eye, axes.right) >= 0);
            CHECK(place->dy * glm::dot(p - view.eye, axes.up) <= 0);
        }
    }
    CHECK(outside > 1000);
}

TEST_CASE("app: straight behind the viewer is below, and the viewer's own place nowhere") {
    const View view = some_view();
    const auto behind = edge_place(view, frame, view.eye + (view.eye - view.target));
    REQUIRE(behind);
    CHECK(behind->dy == doctest::Approx(1));
    CHECK(behind->y == doctest::Approx(frame.y + frame.height));
    CHECK_FALSE(edge_place(view, frame, view.eye));
}

TEST_CASE("app: onto a hit, what stands before the plane of incidence is cut away") {
    const auto document = test::document_of(test::glass_ball_scene());
    const Extent extent = extent_of(*document);
    const RayTree<double> tree = record_tree(document->world(), 40, 30);
    const TreeRay<double>& ray = tree.rays[0];
    REQUIRE(ray.hit);
    const View view = hit_view(*document, ray, extent, some_view());
    const ViewAxes axes = axes_of(view);
    // The plane goes through the hit, and both ray and normal lie in it.
    CHECK(view.cut == doctest::Approx(glm::dot(Point3(ray.hit->point) - view.eye, axes.forward)));
    CHECK(glm::dot(Point3(ray.direction), axes.forward) == doctest::Approx(0));
    CHECK(glm::dot(Point3(ray.hit->normal), axes.forward) == doctest::Approx(0));
    // From below the floor, which hides the ball unless it is cut away; of the ball one sees the
    // far side.
    const auto hit = project(view, ray.hit->point);
    View closed = view;
    closed.cut = 0;
    const Thing ball = *object_named(document->scene(), "ball");
    const double inside = hit->y + 30;
    CHECK(object_at(*document, closed, hit->x, inside) == object_named(document->scene(), "floor"));
    CHECK(object_at(*document, view, hit->x, inside) == ball);
    const auto seen = seen_point(*document, view, ball);
    REQUIRE(seen);
    CHECK(glm::dot(*seen - view.eye, axes.forward) >= view.cut * (1 - 1e-9));
    // The cut stays where it is while one comes nearer, and other views show things whole.
    CHECK(zoomed(view, 2).cut == doctest::Approx(view.cut / 2));
    CHECK(camera_view(*document, extent, view).cut == 0);
    CHECK(side_view(*document, extent, {}, view).cut == 0);
    CHECK(fitted(view, std::vector<Point3>{{0, 0, 0}, {1, 1, 1}}).cut == 0);
}

TEST_CASE("app: of an object whose middle lies outside, a point is found that is seen") {
    const auto document = test::document_of(test::glass_ball_scene());
    const auto& objects = document->scene().objects;
    const View view = camera_view(*document, extent_of(*document), some_view());
    int found = 0;
    for (std::size_t k = 0; k < objects.size(); ++k) {
        const Thing object{Thing::Kind::object, k};
        if (const auto point = seen_point(*document, view, object)) {
            const auto at = project(view, *point);
            REQUIRE(at);
            CHECK(object_at(*document, view, at->x, at->y) == object);
            ++found;
        }
    }
    CHECK(found == static_cast<int>(objects.size()));
    View away = view;
    away.target = view.eye + (view.eye - view.target);
    CHECK_FALSE(seen_point(*document, away, {Thing::Kind::object, 0}));
}

}  // namespace
}  // namespace raytree::inspector
