#include "support/tree_comparison.h"

#include <algorithm>

#include "tree/error_bounds.h"
#include "tree/record.h"

namespace raytree::test {
namespace {

/// Compares a ray of both trees: first what it is, then its numbers against their bounds.
class Comparison {
  public:
    Comparison(const RayTree<double>& own, const RayTree<Quad>& exact,
               const std::vector<RayBounds>& bounds)
        : own_(own), exact_(exact), bounds_(bounds) {}

    /// The first ray that is or goes another way; the number of rays where the shapes agree.
    std::size_t first_difference() const {
        const std::size_t rays = std::min(own_.rays.size(), exact_.rays.size());
        for (std::size_t k = 0; k < rays; ++k) {
            if (!same_shape(own_.rays[k], exact_.rays[k]) || passes_others(k)) {
                return k;
            }
        }
        return rays == std::max(own_.rays.size(), exact_.rays.size()) ? rays : rays - 1;
    }

    /// Whether the ray, or one on its way from the eye, is marked.
    bool is_undecided(std::size_t k) const {
        for (std::optional<std::size_t> ray = k; ray; ray = own_.rays[*ray].parent) {
            if (!bounds_[*ray].doubts.empty()) {
                return true;
            }
        }
        return false;
    }

    /// The largest error as a share of its bound, and of what.
    double worst(std::string& what) {
        for (std::size_t k = 0; k < own_.rays.size(); ++k) {
            compare(own_.rays[k], exact_.rays[k], bounds_[k]);
        }
        what = what_;
        return worst_;
    }

  private:
    static bool same_shape(const TreeRay<double>& a, const TreeRay<Quad>& b) {
        const auto same_reasons = [](const auto& x, const auto& y) {
            return std::ranges::equal(x, y, [](const Skipped& p, const Skipped& q) {
                return p.kind == q.kind && p.light == q.light && p.reason == q.reason;
            });
        };
        const auto blocker = [](const auto& ray) {
            return ray.shadow && ray.shadow->blocked_by ? ray.shadow->blocked_by->object : "";
        };
        return a.kind == b.kind && a.parent == b.parent && a.termination == b.termination &&
               a.hit.has_value() == b.hit.has_value() &&
               (!a.hit || (a.hit->object == b.hit->object && a.hit->side == b.hit->side)) &&
               same_reasons(a.skipped, b.skipped) && blocker(a) == blocker(b);
    }

    /// Whether a shadow ray passes through other shapes: the tree has what comes through alone.
    bool passes_others(std::size_t k) const {
        if (!own_.rays[k].shadow) {
            return false;
        }
        const Rgb<double>& a = own_.rays[k].shadow->transmittance;
        const Rgb<Quad>& b = exact_.rays[k].shadow->transmittance;
        const Rgb<double>& bound = bounds_[k].transmittance;
        const auto off = [](double x, Quad y, double within) { return abs(Quad(x) - y) > within; };
        return off(a.r, b.r, bound.r) || off(a.g, b.g, bound.g) || off(a.b, b.b, bound.b);
    }

    void judge(double error, double bound, std::size_t ray, const char* what) {
        if (error == 0 && bound == 0) {
            return;
        }
        const double share = error / bound;
        if (!(share <= worst_)) {
            worst_ = share;
            what_ = std::string(what) + " of ray " + std::to_string(ray);
        }
    }
    void judge(double a, Quad b, double bound, std::size_t ray, const char* what) {
        judge(static_cast<double>(abs(Quad(a) - b)), bound, ray, what);
    }
    void judge(const Vec3<double>& a, const Vec3<Quad>& b, double bound, std::size_t ray,
               const char* what) {
        judge(static_cast<double>(length<Quad>(vector_cast<Quad>(a) - b)), bound, ray, what);
    }
    void judge(const Rgb<double>& a, const Rgb<Quad>& b, const Rgb<double>& bound, std::size_t ray,
               const char* what) {
        judge(a.r, b.r, bound.r, ray, what);
        judge(a.g, b.g, bound.g, ray, what);
        judge(a.b, b.b, bound.b, ray, what);
    }

    void compare(const TreeRay<double>& a, const TreeRay<Quad>& b, const RayBounds& bound) {
        judge(a.origin, b.origin, bound.origin, a.id, "origin");
        judge(a.direction, b.direction, bound.direction, a.id, "direction");
        if (a.shadow) {
            if (a.shadow->distance) {
                judge(*a.shadow->distance, *b.shadow->distance, bound.distance, a.id, "distance");
            }
            if (a.shadow->blocked_by) {
                judge(a.shadow->blocked_by->t, b.shadow->blocked_by->t, bound.hit.t, a.id,
                      "t of the blocker");
            }
            judge(a.shadow->transmittance, b.shadow->transmittance, bound.transmittance, a.id,
                  "transmittance");
        } else {
            judge(a.weight, b.weight, bound.weight, a.id, "weight");
            judge(a.attenuation, b.attenuation, bound.attenuation, a.id, "attenuation");
            judge(a.intensity, b.intensity, bound.intensity, a.id, "intensity");
        }
        judge(a.ambient, b.ambient, bound.ambient, a.id, "ambient");
        judge(a.diffuse, b.diffuse, bound.diffuse, a.id, "diffuse");
        judge(a.specular, b.specular, bound.specular, a.id, "specular");
        if (a.hit) {
            judge(a.hit->t, b.hit->t, bound.hit.t, a.id, "t");
            judge(a.hit->point, b.hit->point, bound.hit.point, a.id, "point");
            judge(a.hit->normal, b.hit->normal, bound.hit.normal, a.id, "normal");
            judge(a.hit->cos_incident, b.hit->cos_incident, bound.hit.cos_incident, a.id,
                  "cos_incident");
            if (a.hit->interface) {
                judge(a.hit->interface->sin2_transmitted, b.hit->interface->sin2_transmitted,
                      bound.hit.sin2_transmitted, a.id, "sin2_transmitted");
            }
        }
    }

    const RayTree<double>& own_;
    const RayTree<Quad>& exact_;
    const std::vector<RayBounds>& bounds_;
    double worst_ = 0;
    std::string what_;
};

}  // namespace

TreeVerdict compare_trees(const World<double>& own_world, const World<Quad>& reference, int i,
                          int j) {
    const RayTree<double> own = record_tree(own_world, i, j);
    const RayTree<Quad> exact = record_tree(reference, i, j);
    const auto bounds = error_bounds(own_world, reference, own, Real<double>::unit_roundoff);
    Comparison comparison(own, exact, bounds);
    const std::size_t different = comparison.first_difference();
    TreeVerdict verdict;
    if (different < std::max(own.rays.size(), exact.rays.size())) {
        verdict.undecided = comparison.is_undecided(different);
        verdict.wrong = !verdict.undecided;
        verdict.what = "its shape differs, unmarked, at ray " + std::to_string(different);
        return verdict;
    }
    // A decision that went one way in both hides nothing: bounds hold for that way.
    verdict.share = comparison.worst(verdict.what);
    verdict.wrong = !(verdict.share <= 1);
    verdict.what += ": " + std::to_string(verdict.share) + " of its bound";
    return verdict;
}

}  // namespace raytree::test
