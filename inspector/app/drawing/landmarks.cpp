#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "drawing/angles.h"
#include "drawing/ray_mesh.h"

namespace raytree::inspector {
namespace {

constexpr double sun_distance = 0.42;    // of a directional light's arrows, of the diagonal
constexpr double normal_length = 0.085;  // of the diagonal
constexpr double least_normal = 116, most_normal = 150;  // pixels

class Builder {
  public:
    explicit Builder(const LandmarkInput& input) : in_(input) {}

    Landmarks build() {
        add_eye();
        add_frustum();
        add_pixel();
        for (const Light& light : in_.document.scene().lights) {
            add_light(light);
        }
        if (in_.selected && in_.selected->hit) {
            add_normal(*in_.selected->hit);
        }
        if (in_.thing) {
            mark(*in_.thing);
        }
        return std::move(out_);
    }

  private:
    double pixel_at(const Point3& p) const { return length_per_pixel(in_.view, p); }

    void add_eye() {
        const Point3& eye = in_.document.scene().camera.eye;
        add_ball(out_.solid, eye, 5.5 * pixel_at(eye), {in_.palette.camera, 255}, 16);
    }

    void add_frustum() {
        const Point3& eye = in_.document.scene().camera.eye;
        const Paint firm{in_.palette.camera, 210};
        const Paint faint{in_.palette.camera, 90}, gone{in_.palette.camera, 0};
        const auto near = picture_corners(in_.document, in_.extent.plane_distance);
        const auto far = picture_corners(in_.document, in_.extent.far_distance);
        for (std::size_t k = 0; k < 4; ++k) {
            out_.lines.add(eye, firm, near[k], firm);
            out_.lines.add(near[k], faint, far[k], gone);
            out_.lines.add(near[k], near[(k + 1) % 4], firm);
        }
    }

    /// A ring around the pixel on the picture, dark within light: visible on any colour.
    void add_pixel() {
        const Point3 at = place_on_picture(in_.document, in_.pixel, in_.extent.plane_distance);
        const Point3 eye = in_.document.scene().camera.eye;
        const Point3 axis = in_.document.world().camera.forward();
        const double pixel = pixel_at(at);
        const Point3 towards = glm::dot(in_.view.eye - at, axis) < 0 ? -axis : axis;
        const Point3 lifted = at + towards * (1e-3 * glm::length(at - eye));
        add_ring(out_.solid, lifted, towards, 4.5 * pixel, 8.0 * pixel, {Ink(0xFFFFFF), 255});
        add_ring(out_.solid, lifted + towards * (1e-3 * glm::length(at - eye)), towards,
                 5.4 * pixel, 7.1 * pixel, {Ink(0x10151B), 255});
    }

    void add_light(const Light& light) {
        const Point3 at = place_of(light, in_.extent);
        const double pixel = pixel_at(at);
        const Paint paint{in_.palette.light, 255};
        if (std::holds_alternative<PointLight>(light.kind)) {
            add_lamp(at, pixel, paint);
        } else {
            add_sun(at, std::get<DirectionalLight>(light.kind).direction, pixel, paint);
        }
    }

    /// A ball with rays around it that face the viewer.
    void add_lamp(const Point3& at, double pixel, const Paint& paint) {
        const Paint rim{mixed(paint.ink, Ink(0x5A4300), 0.55), 255};
        add_ball(out_.solid, at, 5.5 * pixel, paint, 16);
        const ViewAxes axes = axes_of(in_.view);
        for (int k = 0; k < 8; ++k) {
            const double angle = k * std::acos(-1.0) / 4;
            const Point3 out = std::cos(angle) * axes.right + std::sin(angle) * axes.up;
            add_tube(out_.solid, {at + out * (7.5 * pixel), 0.9 * pixel, rim},
                     {at + out * (11.5 * pixel), 0.9 * pixel, rim}, 6);
        }
    }

    /// Three parallel arrows the way the light travels.
    void add_sun(const Point3& at, const Point3& direction, double pixel, const Paint& paint) {
        const Point3 way = glm::normalize(direction);
        const Across axes = across(way);
        for (int k = 0; k < 3; ++k) {
            const double angle = 2 * k * std::acos(-1.0) / 3;
            const Point3 from =
                at + (std::cos(angle) * axes.u + std::sin(angle) * axes.v) * (9 * pixel);
            const Point3 to = from + way * (34 * pixel);
            add_tube(out_.solid, {from, 1.3 * pixel, paint}, {to, 1.3 * pixel, paint}, 8);
            add_cone(out_.solid, to, to + way * (12 * pixel), 4 * pixel, paint);
        }
    }

    /// An object by its wires, a light by a ring.
    void mark(Thing thing) {
        const Paint paint{in_.palette.selection, 255};
        if (thing.kind == Thing::Kind::light) {
            const Point3 at = place_of(in_.document.scene().lights[thing.index], in_.extent);
            const double pixel = pixel_at(at);
            const Point3 axis = glm::normalize(in_.view.eye - at);
            add_ring(out_.solid, at, axis, 14 * pixel, 17 * pixel, paint, 40);
            return;
        }
        if (in_.mesh) {
            mark_object(thing.index, paint);
        }
    }

    void mark_object(std::size_t index, const Paint& paint) {
        const auto found = std::ranges::find(in_.mesh->objects, index, &ObjectFaces::object);
        if (found == in_.mesh->objects.end()) {
            return;
        }
        const Lines& wires = in_.mesh->wires;
        const auto point = [&](std::size_t segment_end) {
            const auto k = static_cast<std::size_t>(3 * wires.segments[segment_end]);
            return Point3(wires.points[k], wires.points[k + 1], wires.points[k + 2]);
        };
        // As firm as the wires are; many of them cover what they are to mark.
        const double share = found->wires > 600 ? 0.5 : 1.6;
        const auto firmness = [&](std::size_t segment_end) {
            const auto k = static_cast<std::size_t>(4 * wires.segments[segment_end] + 3);
            const double alpha = std::min(255.0, share * wires.colours[k]);
            return Paint{paint.ink, static_cast<std::uint8_t>(alpha)};
        };
        for (std::size_t k = found->first_wire; k < found->first_wire + found->wires; ++k) {
            out_.lines.add(point(2 * k), firmness(2 * k), point(2 * k + 1), firmness(2 * k + 1));
        }
    }

    void add_normal(const TreeHit<double>& hit) {
        const Paint paint{in_.palette.text, 255};
        const Point3 tip = normal_tip(hit, in_.extent, in_.view);
        const double pixel = pixel_at(hit.point);
        const Point3 way = glm::normalize(tip - hit.point);
        const Point3 neck = tip - way * (9 * pixel);
        add_tube(out_.solid, {hit.point, 0.9 * pixel, paint}, {neck, 0.9 * pixel, paint}, 8);
        add_cone(out_.solid, neck, tip, 3.2 * pixel, paint);
    }

    const LandmarkInput& in_;
    Landmarks out_;
};

}  // namespace

Landmarks landmarks(const LandmarkInput& input) { return Builder(input).build(); }

Point3 place_of(const Light& light, const Extent& extent) {
    const Point3 middle = extent.seen.centre();
    if (const auto* point = std::get_if<PointLight>(&light.kind)) {
        const Point3 to = point->position - middle;
        const double distance = glm::length(to);
        const double most = 3 * extent.diagonal;  // as far as shadow rays are drawn
        return distance <= most ? point->position : middle + to * (most / distance);
    }
    const Point3& direction = std::get<DirectionalLight>(light.kind).direction;
    return middle - glm::normalize(direction) * (sun_distance * extent.diagonal);
}

Point3 normal_tip(const TreeHit<double>& hit, const Extent& extent, const View& view) {
    const double pixels = length_per_pixel(view, hit.point);
    const double least = least_normal * size_at_hit(extent, view, hit.point);
    const double length = std::max(normal_length * extent.diagonal, least * pixels);
    return hit.point + hit.normal * std::min(length, most_normal * pixels);
}

}  // namespace raytree::inspector
