#include "drawing/ray_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace raytree::inspector {
namespace {

// Sizes in pixels of the view, unless said otherwise.
constexpr double thinnest = 1.0, thickest = 3.0;  // radius of a tube
constexpr double radius_share = 0.003;            // of the scene's diagonal
constexpr double dash = 11, longest_dashes = 160;
constexpr double arrow_place = 0.6;  // of the way
constexpr double halo_width = 3.2;
constexpr int fade_steps = 8;
// Alpha of rays that do not belong to the selected one, and of those of another tree.
constexpr std::uint8_t set_aside = 64, of_another = 140;

class Builder {
  public:
    explicit Builder(const RayMeshInput& input) : in_(input) {
        for (auto up = in_.tree.tree.rays[in_.selected].parent; up;
             up = in_.tree.tree.rays[*up].parent) {
            ancestors_.push_back(*up);
        }
        std::ranges::reverse(ancestors_);
    }

    RayMeshes build() {
        const bool tubes = in_.paths.size() <= most_tubes;
        for (const RayPath& path : in_.paths) {
            const std::uint8_t alpha = alpha_of(path);
            if (tubes || path.ray == in_.selected) {
                add_path(path, alpha);
            } else {
                add_lines(path, alpha);
            }
            if (path.ray == in_.selected && in_.halo) {
                add_halo(path);
            }
        }
        return std::move(out_);
    }

  private:
    /// As belongs_to, without the walk upwards for every ray.
    bool belongs(std::size_t ray) const {
        if (!in_.set_aside.empty()) {
            return !in_.set_aside[ray];
        }
        return in_.selected == 0 || ray == in_.selected ||
               in_.tree.tree.rays[ray].parent == in_.selected ||
               std::ranges::binary_search(ancestors_, ray);
    }

    std::uint8_t alpha_of(const RayPath& path) const {
        const bool marked = path.ray == in_.selected && in_.halo;
        if (!marked && !belongs(path.ray)) {
            return set_aside;
        }
        return path.graft && path.ray != in_.selected ? of_another : 255;
    }

    double pixel_at(const Point3& p) const { return length_per_pixel(in_.view, p); }

    double radius_at(const RayPath& path, const Point3& p) const {
        const double pixel = pixel_at(p);
        const double share = 0.35 + 0.65 * std::sqrt(path.weight);
        const double radius =
            radius_share * in_.extent.diagonal * share * (path.dashed() ? 0.6 : 1.0);
        return std::clamp(radius, thinnest * pixel, thickest * pixel);
    }

    TubeEnd end_at(const RayPath& path, double s, std::uint8_t alpha) const {
        const Point3 p = path.from + (path.to - path.from) * s;
        return {p, radius_at(path, p), {in_.palette[path.look], alpha}};
    }

    Mesh& mesh_for(std::uint8_t alpha) { return alpha == 255 ? out_.solid : out_.fading; }

    /// Alpha along a path: a fading one is gone at its end.
    static std::uint8_t alpha_at(const RayPath& path, double s, std::uint8_t alpha) {
        if (!path.fades) {
            return alpha;
        }
        const double left = std::clamp(1.25 - s * 1.2, 0.0, 1.0);
        return static_cast<std::uint8_t>(std::lround(alpha * left));
    }

    /// Calls `piece(from, to)` for the dashes of a path, as shares of its length.
    template <class Piece> void for_dashes(const RayPath& path, Piece piece) const {
        const double length = glm::length(path.to - path.from);
        const Point3 middle = path.from + (path.to - path.from) * 0.5;
        // Steps of two in the period: dashes do not crawl while the view moves.
        const double unit = 0.01 * in_.extent.diagonal;
        const double period =
            unit * std::exp2(std::round(std::log2(dash * pixel_at(middle) / unit)));
        const double count = std::clamp(std::round(length / period), 2.0, longest_dashes);
        for (double k = 0; k < count; ++k) {
            piece(k / count, (k + 0.6) / count);
        }
    }

    void add_path(const RayPath& path, std::uint8_t alpha) {
        if (path.dashed()) {
            for_dashes(path, [&](double from, double to) { add_piece(path, from, to, alpha, 6); });
        } else if (path.fades) {
            for (int k = 0; k < fade_steps; ++k) {
                add_piece(path, static_cast<double>(k) / fade_steps, (k + 1.0) / fade_steps, alpha,
                          8);
            }
        } else {
            add_piece(path, 0, 1, alpha, 8);
            add_arrow(path, alpha);
        }
        add_node(path, alpha);
    }

    void add_piece(const RayPath& path, double from, double to, std::uint8_t alpha, int sides) {
        const std::uint8_t first = alpha_at(path, from, alpha), last = alpha_at(path, to, alpha);
        add_tube(mesh_for(std::min(first, last)), end_at(path, from, first), end_at(path, to, last),
                 sides);
    }

    void add_arrow(const RayPath& path, std::uint8_t alpha) {
        const double length = glm::length(path.to - path.from);
        const Point3 at = path.from + (path.to - path.from) * arrow_place;
        const double radius = radius_at(path, at);
        const double head = 5.5 * radius + 2 * pixel_at(at);
        if (length < 2.2 * head) {
            return;
        }
        const Point3 way = (path.to - path.from) / length;
        add_cone(mesh_for(alpha), at - way * (head / 2), at + way * (head / 2),
                 2.1 * radius + 1.2 * pixel_at(at), {in_.palette[path.look], alpha});
    }

    /// Rays end in a ball where they hit, in a hollow ring where they escape, in a square stop
    /// where they are blocked.
    void add_node(const RayPath& path, std::uint8_t alpha) {
        const Paint paint{in_.palette[path.look], alpha};
        const double pixel = pixel_at(path.to);
        const double radius = radius_at(path, path.to);
        if (path.end == RayPath::End::hit) {
            add_ball(mesh_for(alpha), path.to, 1.5 * radius + 0.8 * pixel, paint, 10);
        } else if (path.end == RayPath::End::open) {
            const Point3 axis = glm::normalize(in_.view.eye - path.to);
            add_ring(mesh_for(alpha), path.to, axis, 3.0 * pixel, 4.6 * pixel, paint);
        } else if (path.end == RayPath::End::blocked) {
            add_stop(mesh_for(alpha), path.to, pixel, paint);
        }
    }

    /// An upright cross that faces the viewer.
    void add_stop(Mesh& mesh, const Point3& at, double pixel, const Paint& paint) const {
        const ViewAxes axes = axes_of(in_.view);
        const double arm = 4.5 * pixel, half = 1.1 * pixel;
        const Point3 diagonal_a = (axes.right + axes.up) * std::sqrt(0.5);
        const Point3 diagonal_b = (axes.right - axes.up) * std::sqrt(0.5);
        const auto bar = [&](const Point3& u, const Point3& v) {
            add_quad(mesh, at - u * arm - v * half, at + u * arm - v * half,
                     at + u * arm + v * half, at - u * arm + v * half, paint);
        };
        bar(diagonal_a, diagonal_b);
        bar(diagonal_b, diagonal_a);
    }

    void add_halo(const RayPath& path) {
        const Paint paint{in_.palette.selection, 255};
        const auto end = [&](double s) {
            TubeEnd tube = end_at(path, s, 255);
            tube.radius += halo_width * pixel_at(tube.at);
            tube.paint = paint;
            return tube;
        };
        add_tube(out_.halo, end(0), end(1), 10);
        for (const double s : {0.0, 1.0}) {
            const TubeEnd tube = end(s);
            add_ball(out_.halo, tube.at, tube.radius * (s > 0 ? 1.35 : 1.0), paint, 12);
        }
    }

    void add_lines(const RayPath& path, std::uint8_t alpha) {
        const Ink ink = in_.palette[path.look];
        const auto at = [&](double s) { return path.from + (path.to - path.from) * s; };
        const auto piece = [&](double from, double to) {
            out_.lines.add(at(from), {ink, alpha_at(path, from, alpha)}, at(to),
                           {ink, alpha_at(path, to, alpha)});
        };
        if (path.dashed() && in_.paths.size() <= 10 * most_tubes) {
            for_dashes(path, piece);
        } else {
            piece(0, 1);
        }
    }

    const RayMeshInput& in_;
    std::vector<std::size_t> ancestors_;  ///< of the selected ray, ascending
    RayMeshes out_;
};

}  // namespace

RayMeshes ray_meshes(const RayMeshInput& input) { return Builder(input).build(); }

void add_thin(Lines& lines, const std::vector<RayPath>& paths, const Palette& palette) {
    for (const RayPath& path : paths) {
        const std::uint8_t alpha = path.dashed() ? 60 : 170;
        lines.add(path.from, {palette[path.look], alpha}, path.to,
                  {palette[path.look], path.fades ? std::uint8_t{0} : alpha});
    }
}

}  // namespace raytree::inspector
