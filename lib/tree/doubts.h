#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tree/error_bounds.h"
#include "tree/ray_noise.h"

/// Finds what could have gone either way in a recorded tree, for error_bounds.
namespace raytree {

/// "3 ulp", "1.2e+04 ulp"
std::string ulps_text(double ulps);

/// The surface that a ray leaves, from its front or its back.
struct LeftSurface {
    PrimitiveId primitive = no_primitive;
    bool front = true;
};

/// A length and how far it may be off.
struct Bounded {
    double value = 0, error = 0;
};

class DoubtFinder {
  public:
    DoubtFinder(const World<double>& world, const World<Quad>& reference, double unit_roundoff)
        : world_(world), reference_(reference), u_(unit_roundoff) {}

    /// Bound of the error of a root of the shape, for a ray of this noise.
    double t_error(PrimitiveId id, const TreeRay<double>& ray, double t,
                   const NoiseList& noise) const;

    /// Whether the ray could have met something else than `met`, or nothing. `path` is the length
    /// from the eye to its start.
    void carrying_ray(const TreeRay<double>& ray, const std::optional<LeftSurface>& from,
                      const std::optional<PrimitiveId>& met, const NoiseList& noise, Bounded path,
                      std::vector<Doubt>& doubts) const;
    /// `blocker` and, of a point light, `distance_error` are those of the shadow ray.
    void shadow_ray(const TreeRay<double>& ray, PrimitiveId leaving, bool front,
                    const std::optional<PrimitiveId>& blocker, ShadowMode mode,
                    double distance_error, const NoiseList& noise,
                    std::vector<Doubt>& doubts) const;

    /// Whether what follows from a hit could have been decided the other way: its side, total
    /// internal reflection, and branches whose weight is near the smallest.
    void branches(const TreeRay<double>& ray, RayBounds& bounds, double speed,
                  const Settings& settings) const;

  private:
    template <class Meets> void around(const TreeRay<double>& ray, Going going, double reach,
                                       const NoiseList& noise, const std::string& expected,
                                       Meets&& meets, std::vector<Doubt>& doubts) const;
    void in_depth(const TreeRay<double>& ray, Bounded place, PrimitiveId except,
                  const std::string& what, const NoiseList& noise,
                  std::vector<Doubt>& doubts) const;
    Rgb<Quad> through(const Ray<Quad>& ray, PrimitiveId leaving, Interval<Quad> interval) const;
    template <class T> const World<T>& world() const;
    std::string name_of(std::optional<PrimitiveId> id) const;

    const World<double>& world_;
    const World<Quad>& reference_;
    double u_;
};

}  // namespace raytree
