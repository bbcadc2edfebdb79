#include "drawing/angles.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "formats/tree_diagram.h"
#include "tree/explain.h"

namespace raytree::inspector {
namespace {

// Pixels on the screen.
constexpr double incident_radius = 84, refracted_radius = 84, critical_radius = 108;
constexpr double axis_length = 116, ghost_length = 112;
constexpr double line = 0.8, arc = 1.5;
constexpr double degrees_per_step = 4;

/// The normal at the ray's hit, on the side from which the ray comes.
Point3 against(const TreeRay<double>& ray) {
    const Point3 normal = ray.hit->normal;
    return glm::dot(normal, Point3(ray.direction)) > 0 ? -normal : normal;
}

/// Whether stepping has come to it.
bool is_decided(const TreeRay<double>& ray, const Skipped& ghost, const Playback* playback) {
    const auto place = static_cast<std::size_t>(&ghost - ray.skipped.data());
    return !playback || playback->decided(ray.id, place);
}

/// The way that a ray would have gone that was not sent; none where it would have gone no way.
std::optional<Point3> ghost_way(const Scene& scene, const TreeRay<double>& ray,
                                const Skipped& ghost, const Playback* playback) {
    if (!is_decided(ray, ghost, playback)) {
        return std::nullopt;
    }
    const Point3 d = ray.direction, normal = against(ray);
    if (ghost.kind == RayKind::reflected) {
        return reflected(d, normal);
    }
    if (ghost.kind == RayKind::refracted) {
        const auto& surface = ray.hit->interface;
        return surface ? refracted(d, normal, surface->eta1, surface->eta2) : std::nullopt;
    }
    for (const Light& light : scene.lights) {
        if (light.name == ghost.light) {
            const auto* const point = std::get_if<PointLight>(&light.kind);
            return glm::normalize(point ? point->position - Point3(ray.hit->point)
                                        : -std::get<DirectionalLight>(light.kind).direction);
        }
    }
    return std::nullopt;
}

class Builder {
  public:
    explicit Builder(const AngleInput& input)
        : in_(input),
          ray_(input.tree.tree.rays[input.selected]),
          at_(ray_.hit->point),
          size_(size_at_hit(input.extent, input.view, at_)),
          pixel_(size_ * length_per_pixel(input.view, at_)) {
        const Point3 d = ray_.direction;
        normal_ = against(ray_);
        cosine_ = std::clamp(-glm::dot(d, normal_), -1.0, 1.0);
        sideways_ = d + cosine_ * normal_;  // along the surface, the way the ray goes
        const double length = glm::length(sideways_);
        sideways_ = length > 1e-9 ? sideways_ / length : across(normal_).u;
    }

    AngleDrawing build() {
        if (in_.angles) {
            add_axes();
            add_incident();
            add_reflected();
            if (ray_.hit->interface) {
                add_refracted(*ray_.hit->interface);
            }
        }
        if (in_.ghosts) {
            add_ghosts();
        }
        return std::move(out_);
    }

  private:
    /// In the plane of incidence: `angle` from the normal, towards where the ray goes.
    Point3 direction(double angle) const {
        return std::cos(angle) * normal_ + std::sin(angle) * sideways_;
    }
    Point3 place(double angle, double pixels) const {
        return at_ + direction(angle) * (pixels * pixel_);
    }

    /// Lines are as thick whatever the size of the whole.
    double thick(double pixels) const { return pixels * pixel_ / size_; }

    void add_line(const Point3& from, const Point3& to, const Paint& paint) {
        add_tube(paint.alpha == 255 ? out_.solid : out_.faint, {from, thick(line), paint},
                 {to, thick(line), paint}, 6);
    }

    void add_dots(const Point3& to, double pixels, const Paint& paint, double first = 10) {
        const Point3 way = glm::normalize(to - at_);
        for (double s = first; s < pixels; s += 8) {
            add_tube(out_.faint, {at_ + way * (s * pixel_), thick(1.2), paint},
                     {at_ + way * ((s + 3.5) * pixel_), thick(1.2), paint}, 6);
        }
    }

    /// The surface in the plane of incidence, and the normal prolonged beneath it.
    void add_axes() {
        const Paint faint{in_.palette.text, 110};
        add_line(at_ - sideways_ * (axis_length * pixel_), at_ + sideways_ * (axis_length * pixel_),
                 faint);
        if (ray_.hit->interface) {
            add_dots(at_ - normal_, axis_length, faint);
        }
    }

    void add_arc(double from, double to, double radius, const Paint& paint) {
        const double span = std::abs(to - from);
        const int steps =
            std::max(2, static_cast<int>(span * 180 / std::acos(-1.0) / degrees_per_step));
        for (int k = 0; k < steps; ++k) {
            const double a = from + (to - from) * k / steps,
                         b = from + (to - from) * (k + 1) / steps;
            add_tube(paint.alpha == 255 ? out_.solid : out_.faint,
                     {place(a, radius), thick(arc), paint}, {place(b, radius), thick(arc), paint},
                     6);
        }
    }

    /// The arc, and faintly all that it encloses.
    void add_sector(double from, double to, double radius, const Paint& paint) {
        add_arc(from, to, radius, paint);
        const Paint faint{paint.ink, static_cast<std::uint8_t>(paint.alpha / 4)};
        const int steps = std::max(1, static_cast<int>(std::abs(to - from) * 16));
        for (int k = 0; k < steps; ++k) {
            const Point3 a = place(from + (to - from) * k / steps, radius);
            const Point3 b = place(from + (to - from) * (k + 1) / steps, radius);
            const std::int32_t first = out_.faint.add_point(at_, normal_, faint);
            out_.faint.add_point(a, normal_, faint);
            out_.faint.add_triangle(first, first + 1, out_.faint.add_point(b, normal_, faint));
        }
    }

    void write(double angle, double radius, std::string text, bool strong = true) {
        out_.words.push_back(
            {place(angle, radius), place(angle, 2 * radius), std::move(text), strong});
    }

    Paint paint_of(RayLook look) const { return {in_.palette[look], 255}; }

    void add_incident() {
        const double angle = std::acos(cosine_);
        add_sector(-angle, 0, incident_radius, paint_of(look_of(ray_)));
        write(-angle / 2, 1.1 * incident_radius, "θ₁ = " + angle_text(cosine_));
    }

    void add_reflected() {
        const bool there = sent(RayKind::reflected);
        if (!there && !(in_.ghosts && skipped(RayKind::reflected))) {
            return;
        }
        const double angle = std::acos(cosine_);
        const Paint paint{in_.palette[RayLook::reflected],
                          static_cast<std::uint8_t>(there ? 255 : 120)};
        add_sector(0, angle, incident_radius, paint);
        if (there && size_ > 0.7) {  // where there is room to say it twice
            write(angle / 2, 1.1 * incident_radius, "θ₁ = " + angle_text(cosine_), false);
        }
    }

    void add_refracted(const Interface<double>& surface) {
        const std::string media =
            "η " + number_text(surface.eta1) + " → " + number_text(surface.eta2);
        const double pi = std::acos(-1.0);
        out_.words.push_back({at_ + sideways_ * (-1.15 * axis_length * pixel_),
                              at_ + sideways_ * (-1.9 * axis_length * pixel_), media, true});
        if (surface.sin2_transmitted > 1) {
            if (!in_.playback || skipped(RayKind::refracted)) {
                add_critical(surface);
            }
            return;
        }
        if (!sent(RayKind::refracted) && !(in_.ghosts && skipped(RayKind::refracted))) {
            return;
        }
        const double angle = std::asin(std::sqrt(std::max(0.0, surface.sin2_transmitted)));
        const Paint paint{in_.palette[RayLook::refracted],
                          static_cast<std::uint8_t>(sent(RayKind::refracted) ? 255 : 120)};
        add_sector(pi, pi - angle, refracted_radius, paint);
        write(pi - angle / 2, 1.1 * refracted_radius,
              "θ₂ = " + angle_text(std::sqrt(std::max(0.0, 1 - surface.sin2_transmitted))));
    }

    /// Where the incident ray would just be let through.
    void add_critical(const Interface<double>& surface) {
        const double sine = surface.eta2 / surface.eta1;
        if (!(sine < 1)) {
            return;
        }
        const double angle = std::asin(sine);
        const Paint paint{in_.palette.selection, 255};
        add_arc(-angle, 0, critical_radius, paint);
        const Point3 limit = place(-angle, critical_radius + 14);
        add_dots(limit, critical_radius + 14, paint);
        out_.words.push_back({place(-angle, critical_radius + 26), place(-angle, 160),
                              "critical angle " + angle_text(std::sqrt(1 - sine * sine)) +
                                  " exceeded: total internal reflection",
                              true});
    }

    bool sent(RayKind kind) const {
        const auto& children = in_.tree.children[ray_.id];
        return std::ranges::any_of(children, [&](std::size_t child) {
            const TreeRay<double>& ray = in_.tree.tree.rays[child];
            return ray.kind == kind && shown(in_.filter, in_.tree, ray) != Shown::hidden &&
                   (!in_.playback || in_.playback->stage(child) != Stage::unsent);
        });
    }
    bool skipped(RayKind kind) const {
        return in_.filter.of(group_of(kind)) != Shown::hidden &&
               std::ranges::any_of(ray_.skipped, [&](const Skipped& ghost) {
                   return ghost.kind == kind && is_decided(ray_, ghost, in_.playback);
               });
    }

    /// Dotted, the way that the ray would have gone; nothing where it would have gone no way. Of
    /// many lights that were not asked for the same reason the first one's words speak for all.
    void add_ghosts() {
        constexpr int most = 3;
        std::vector<std::pair<const Skipped*, Point3>> ghosts;  // with their ways
        std::map<Reason, int> lights;
        for (const Skipped& ghost : ray_.skipped) {
            if (const auto way = ghost_way(in_.document.scene(), ray_, ghost, in_.playback)) {
                ghosts.emplace_back(&ghost, *way);
                lights[ghost.reason] += ghost.kind == RayKind::shadow ? 1 : 0;
            }
        }
        std::set<Reason> told;
        for (const auto& [ghost, way] : ghosts) {
            const Point3 tip = at_ + way * (ghost_length * pixel_);
            add_dots(tip, ghost_length, {in_.palette.dim_text, 200});
            std::string name = "not " + std::string(word_of(ghost->kind));
            if (ghost->kind == RayKind::shadow) {
                const int count = lights[ghost->reason];
                if (count > most && !told.insert(ghost->reason).second) {
                    continue;
                }
                name = count > most ? "no shadow rays to " + std::to_string(count) + " lights"
                                    : "no shadow ray to " + ghost->light;
            }
            out_.words.push_back({at_ + way * (1.12 * ghost_length * pixel_),
                                  at_ + way * (2 * ghost_length * pixel_),
                                  name + ": " + short_reason(ghost->reason), false});
        }
    }

    const AngleInput& in_;
    const TreeRay<double>& ray_;
    Point3 at_;
    double size_;
    double pixel_;  ///< the length of one of the pixels that sizes are given in
    Point3 normal_, sideways_;
    double cosine_ = 1;
    AngleDrawing out_;
};

}  // namespace

AngleDrawing angle_drawing(const AngleInput& input) {
    return input.tree.tree.rays[input.selected].hit ? Builder(input).build() : AngleDrawing();
}

bool has_ghosts(const Scene& scene, const TreeRay<double>& ray, const Playback* playback) {
    return ray.hit && std::ranges::any_of(ray.skipped, [&](const Skipped& ghost) {
               return ghost_way(scene, ray, ghost, playback).has_value();
           });
}

double size_at_hit(const Extent& extent, const View& view, const Point3& at) {
    constexpr double share = 0.065;  // of the diagonal, that the largest arc is wide at most
    constexpr double smallest = 0.48;
    const double diagonal = extent.diagonal / length_per_pixel(view, at);
    return std::clamp(share * diagonal / incident_radius, smallest, 1.0);
}

Point3 reflected(const Point3& d, const Point3& normal) {
    return d - 2 * glm::dot(d, normal) * normal;
}

std::optional<Point3> refracted(const Point3& d, const Point3& normal, double eta1, double eta2) {
    const double ratio = eta1 / eta2, cosine = -glm::dot(d, normal);
    const double sin2 = ratio * ratio * (1 - cosine * cosine);
    if (sin2 > 1) {
        return std::nullopt;
    }
    return ratio * d + (ratio * cosine - std::sqrt(1 - sin2)) * normal;
}

}  // namespace raytree::inspector
