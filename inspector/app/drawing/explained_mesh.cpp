#include "drawing/explained_mesh.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "state/formula_details.h"
#include "state/marked_texts.h"
#include "tree/derivation.h"
#include "tree/explain.h"

namespace raytree::inspector {
namespace {

constexpr double reach = 2.5;  // of walls and rays that go on, in diagonals of what is seen

/// All that the selected ray would meet, where the lesson's step talks of it.
std::vector<AlongRay> met_along(const State& state, const Extent& extent) {
    const TreeRay<double>* const ray = state.selected();
    if (!ray || marked_formula(state) != lesson::Formula::along ||
        !can_derive(*state.tree(), ray->id, state.playback())) {
        return {};
    }
    std::vector<AlongRay> met =
        derive(state.document()->world(), state.tree()->tree, ray->id).along;
    std::erase_if(met, [&](const AlongRay& at) { return at.t > reach * extent.diagonal; });
    return met;
}

class Builder {
  public:
    Builder(const State& state, const Extent& extent, const View& view)
        : state_(state),
          extent_(extent),
          view_(view),
          palette_(palette_of(state.look().theme)),
          all_(state.explanation()) {}

    ExplainedMesh build() {
        if (all_.shower) {
            add_shower(*all_.shower);
        }
        if (all_.traversal) {
            add_replay(*all_.traversal);
        }
        if (all_.volumes) {
            add_volumes(*all_.volumes);
        }
        if (all_.depth) {
            add_depth(*all_.depth);
        }
        for (const ZBufferStep& step : all_.z_buffer) {
            add_ball_at(state_.tree()->tree.rays[0], step.t, palette_.accent, step.written ? 5 : 3);
        }
        if (all_.crossings) {
            add_crossings(*all_.crossings);
        }
        add_along(met_along(state_, extent_));
        return std::move(out_);
    }

  private:
    double pixel(const Point3& at) const { return length_per_pixel(view_, at); }

    void add_ball_at(const TreeRay<double>& ray, double t, Ink ink, double pixels) {
        const Point3 at = along(ray.origin, t, ray.direction);
        inspector::add_ball(out_.solid, at, pixels * pixel(at), Paint{ink});
    }

    /// A ball at each hit, the one that counts larger, and the ray's line on to the last.
    void add_along(const std::vector<AlongRay>& met) {
        if (met.empty()) {
            return;
        }
        const TreeRay<double>& ray = *state_.selected();
        out_.lines.add(ray.origin, along(ray.origin, met.back().t, ray.direction),
                       Paint{palette_.accent, 230});
        for (const AlongRay& at : met) {
            add_ball_at(ray, at.t, palette_.accent, at.taken ? 6 : 4);
        }
    }

    /// The walk from the point in the plane over the edges that it crosses.
    void add_crossings(const CrossingWalk& walk) {
        const Paint paint{palette_.accent};
        const auto tube = [&](const Point3& from, const Point3& to, double pixels) {
            add_tube(out_.solid, {from, pixels * pixel(from), paint},
                     {to, pixels * pixel(to), paint}, 8);
        };
        for (const CrossingWalk::Crossed& crossed : walk.crossed) {
            tube(crossed.from, crossed.to, 2);
            inspector::add_ball(out_.solid, crossed.at, 5 * pixel(crossed.at), paint);
        }
        if (!walk.crossed.empty()) {
            const Point3 start = walk.point, last = walk.crossed.back().at;
            tube(start, last + 0.08 * (last - start), 1.2);
        }
        inspector::add_ball(out_.solid, walk.point, 5 * pixel(walk.point),
                            Paint{palette_.selection});
    }

    /// Ways that go on beyond what is seen are cut.
    Point3 drawn_in(const Point3& from, const Point3& to) const {
        const double length = glm::length(to - from), most = reach * extent_.diagonal;
        return length > most ? from + (to - from) * (most / length) : to;
    }

    void add_shower(const LightShower& sent) {
        const std::uint8_t faint = sent.paths.size() > 300 ? 70 : 130;
        for (const ShowerPath& path : sent.paths) {
            for (std::size_t k = 0; k + 1 < path.points.size(); ++k) {
                const Point3& from = path.points[k];
                const Point3 to = drawn_in(from, path.points[k + 1]);
                if (path.reaches_eye) {
                    const double width = 1.6 * pixel(to);
                    add_tube(out_.solid, {from, width, Paint{palette_.selection}},
                             {to, width, Paint{palette_.selection}}, 6);
                } else {
                    const Ink ink = k == 0 ? palette_.light : palette_[RayLook::reflected];
                    const bool escapes = path.escapes && k + 2 == path.points.size();
                    out_.lines.add(from, Paint{ink, faint}, to,
                                   Paint{ink, escapes ? std::uint8_t{0} : faint});
                }
            }
        }
        add_outline({state_.document()->scene().camera.eye, state_.explained().shower->eye_radius},
                    Paint{palette_.selection, 220});
    }

    void add_outline(const Box& box, const Paint& paint) {
        const auto corner = [&](int k) {
            return Point3((k & 1 ? box.max : box.min).x, (k & 2 ? box.max : box.min).y,
                          (k & 4 ? box.max : box.min).z);
        };
        for (int a = 0; a < 8; ++a) {
            for (const int axis : {1, 2, 4}) {
                if (!(a & axis)) {
                    out_.lines.add(corner(a), corner(a | axis), paint);
                }
            }
        }
    }

    /// As the viewer sees it: one circle.
    void add_outline(const BoundingSphere& sphere, const Paint& paint) {
        constexpr int sides = 64;
        const Across axes = across(glm::normalize(sphere.center - view_.eye));
        const auto at = [&](int k) {
            const double angle = 2 * std::numbers::pi * k / sides;
            return sphere.center +
                   sphere.radius * (std::cos(angle) * axes.u + std::sin(angle) * axes.v);
        };
        for (int k = 0; k < sides; ++k) {
            out_.lines.add(at(k), at(k + 1), paint);
        }
    }

    void add_faces(const Box& box, const Paint& paint) {
        const Point3 &a = box.min, &b = box.max;
        const auto p = [](double x, double y, double z) { return Point3(x, y, z); };
        for (const double x : {a.x, b.x}) {
            add_quad(out_.faces, p(x, a.y, a.z), p(x, b.y, a.z), p(x, b.y, b.z), p(x, a.y, b.z),
                     paint);
        }
        for (const double y : {a.y, b.y}) {
            add_quad(out_.faces, p(a.x, y, a.z), p(b.x, y, a.z), p(b.x, y, b.z), p(a.x, y, b.z),
                     paint);
        }
        for (const double z : {a.z, b.z}) {
            add_quad(out_.faces, p(a.x, a.y, z), p(b.x, a.y, z), p(b.x, b.y, z), p(a.x, b.y, z),
                     paint);
        }
    }
    void add_faces(const BoundingSphere& sphere, const Paint& paint) {
        inspector::add_ball(out_.faces, sphere.center, sphere.radius, paint, 32);
    }

    /// Volumes that are opened stand out; those left out are faint; the one looked at just now is
    /// filled.
    void add_replay(const TraversalReplay& replay) {
        const lesson::TraversalShown& shown = *state_.explained().traversal;
        const std::size_t count = steps_shown(shown, replay.steps.size());
        for (std::size_t k = 0; k < count; ++k) {
            const auto& step = replay.steps[k];
            const bool now = shown.step && k + 1 == count;
            const Ink ink = now           ? palette_.selection
                            : step.opened ? palette_.accent
                                          : palette_.dim_text;
            const bool strong = now || step.opened || !step.tested.empty();
            const Paint paint{ink, static_cast<std::uint8_t>(strong ? 230 : 110)};
            std::visit([&](const auto& volume) { add_outline(volume, paint); },
                       replay.hierarchy.nodes()[step.node].volume);
            if (now) {
                std::visit(
                    [&](const auto& volume) {
                        add_faces(volume, Paint{ink, filling(size_of(volume))});
                    },
                    replay.hierarchy.nodes()[step.node].volume);
            }
            if (step.opened && state_.selected() && step.passage.enter > 0) {
                add_ball_at(*state_.selected(), step.passage.enter, ink, now ? 4.5 : 3);
            }
        }
    }

    static double size_of(const Box& box) { return glm::length(box.max - box.min); }
    static double size_of(const BoundingSphere& sphere) { return 2 * sphere.radius; }

    /// How firmly a volume is filled: one around all that is seen would tint the whole view.
    std::uint8_t filling(double size) const {
        constexpr double firmest = 40, small = 0.25;  // a volume of that share of what is seen
        const double share = std::clamp(size / extent_.diagonal, small, 1.0);
        return static_cast<std::uint8_t>(firmest * std::pow(small / share, 1.5));
    }

    /// Walls fade with the distance from what throws them, and many of them are fainter each: they
    /// lie over each other, and the scene is to be seen through all.
    void add_volumes(const ShadowVolumes& volumes) {
        const double far = reach * extent_.diagonal;
        const Ink ink = palette_[RayLook::blocked];
        std::size_t count = 0;
        for (const ShadowVolume& volume : volumes.volumes) {
            count += volume.walls.size();
        }
        const double many = std::max(1.0, static_cast<double>(count) / 12);
        const Paint face{ink, static_cast<std::uint8_t>(std::max(4.0, 34 / many))};
        const Paint edge{ink, static_cast<std::uint8_t>(std::max(70.0, 170 / std::sqrt(many)))};
        const Paint gone{ink, 0};
        for (const ShadowVolume& volume : volumes.volumes) {
            for (const VolumeWall& wall : volume.walls) {
                const Point3 a = far_corner(volumes, wall.a, far);
                const Point3 b = far_corner(volumes, wall.b, far);
                add_quad(out_.faces, wall.a, wall.b, b, a, face, gone);
                out_.lines.add(wall.a, Paint{ink, 220}, wall.b, Paint{ink, 220});
                out_.lines.add(wall.a, edge, a, gone);
            }
        }
        if (all_.volume_count && state_.selected()) {
            for (const WallCrossing& crossing : all_.volume_count->crossings) {
                add_ball_at(*state_.selected(), crossing.t,
                            crossing.enters ? ink : palette_[RayLook::lit], 4.5);
            }
        }
    }

    /// The light's window at the distance of what is seen, with the pixel of the hit, and how far
    /// the light sees in it.
    void add_depth(const DepthPicture& picture) {
        const auto& place = all_.comparison ? all_.comparison->place : DepthPicture::Place{};
        const DepthPicture::Side& side = picture.sides()[place.side];
        const bool flat = picture.directional();
        const double away = flat ? 0 : 0.35 * glm::length(extent_.seen.centre() - side.origin);
        const double half = flat ? side.half : side.half * away;
        const Point3 middle = side.origin + away * side.forward;
        const auto at = [&](double x, double y) {
            return middle + x * half * side.right + y * half * side.up;
        };
        const Paint paint{palette_.light, 255}, thin{palette_.light, 150};
        const Point3 corners[] = {at(-1, 1), at(1, 1), at(1, -1), at(-1, -1)};
        for (int k = 0; k < 4; ++k) {
            out_.lines.add(corners[k], corners[(k + 1) % 4], paint);
            if (!flat) {
                out_.lines.add(side.origin, corners[k], thin);
            }
        }
        add_quad(out_.faces, corners[0], corners[1], corners[2], corners[3],
                 Paint{palette_.light, 36});
        if (!all_.comparison) {
            return;
        }
        const double each = 2.0 / picture.size();
        const double x = -1 + each * place.i, y = 1 - each * place.j;
        add_quad(out_.faces, at(x, y), at(x + each, y), at(x + each, y - each), at(x, y - each),
                 Paint{palette_.selection, 200});
        add_sight(picture, side, at(x + each / 2, y - each / 2));
    }

    /// From the light towards the hit, as far as the depth that is stored.
    void add_sight(const DepthPicture& picture, const DepthPicture::Side& side,
                   const Point3& window) {
        const DepthComparison& at = *all_.comparison;
        const Point3 hit = state_.selected()->hit->point;
        const Point3 from = picture.directional() ? window : side.origin;
        const Point3 way = picture.directional() ? side.forward : glm::normalize(hit - from);
        const double stored =
            std::isfinite(at.stored) ? at.stored : std::min(at.distance, reach * extent_.diagonal);
        const Point3 to = from + stored * way;
        const double width = 1.5 * pixel(to);
        add_tube(out_.solid, {from, width, Paint{palette_.light}},
                 {to, width, Paint{palette_.light}}, 8);
        inspector::add_ball(out_.solid, to, 5 * pixel(to),
                            Paint{palette_[at.lit ? RayLook::lit : RayLook::blocked]});
    }

    const State& state_;
    const Extent& extent_;
    const View& view_;
    const Palette& palette_;
    const Explanation& all_;
    ExplainedMesh out_;
};

}  // namespace

ExplainedMesh explained_mesh(const State& state, const Extent& extent, const View& view) {
    return state.document() ? Builder(state, extent, view).build() : ExplainedMesh{};
}

std::vector<ExplainedMark> explained_marks(const State& state, const Extent& extent) {
    std::vector<ExplainedMark> marks;
    if (!state.document() || !state.selected()) {
        return marks;
    }
    const Explanation& all = state.explanation();
    const TreeRay<double>& ray = *state.selected();
    if (all.volume_count) {
        const std::vector<int> counts = counts_along(*all.volume_count);
        for (std::size_t k = 0; k < counts.size(); ++k) {
            const double t = all.volume_count->crossings[k].t;
            if (t < 3 * extent.diagonal) {
                marks.push_back({along(ray.origin, t, ray.direction), std::to_string(counts[k])});
            }
        }
    }
    if (all.crossings) {
        for (std::size_t k = 0; k < all.crossings->crossed.size(); ++k) {
            marks.push_back({all.crossings->crossed[k].at, std::to_string(k + 1)});
        }
    }
    for (const AlongRay& met : met_along(state, extent)) {
        marks.push_back({along(ray.origin, met.t, ray.direction), "t = " + number_text(met.t)});
    }
    return marks;
}

}  // namespace raytree::inspector
