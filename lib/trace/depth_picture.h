#pragma once

#include <vector>

#include "trace/world.h"

/// The two-pass z-buffer (Williams, "Casting curved shadows on curved surfaces", 1978): first a
/// picture of distances from the light, then a comparison at each hit.
namespace raytree {

/// What a light sees: for each pixel the distance to the nearest surface. One picture that takes in
/// the whole scene where that is possible, the six sides of a cube around a light amid the scene.
class DepthPicture {
  public:
    struct Side {
        Vec3<double>
            origin{};  ///< the light; of a directional one the middle of a plane before all
        Vec3<double> right{}, up{}, forward{};  ///< unit
        double half = 1;  ///< half the width: at distance 1, or of a directional light in the world
    };
    struct Place {
        std::size_t side = 0;
        int i = 0, j = 0;
    };

    /// `size`: pixels of its width and height, 1 or more.
    DepthPicture(const World<double>& world, std::size_t light, int size);

    int size() const { return size_; }
    bool directional() const { return directional_; }
    const std::vector<Side>& sides() const { return sides_; }
    /// Infinite where the light sees nothing.
    double depth(const Place& place) const { return depths_[offset(place)]; }

    /// The pixel in which the light sees a point, or would see it.
    Place place_of(const Vec3<double>& point) const;
    /// How far a point is from the light, in the same measure as `depth`.
    double distance_to(const Vec3<double>& point) const;

  private:
    std::size_t offset(const Place& place) const;
    Ray<double> ray_of(const Place& place) const;

    bool directional_ = false;
    Vec3<double> light_{};
    int size_ = 1;
    std::vector<Side> sides_;
    std::vector<double> depths_;
};

/// The second pass, at one point.
struct DepthComparison {
    DepthPicture::Place place;
    double stored = 0;    ///< what the light sees there
    double distance = 0;  ///< how far the point is
    bool lit = false;     ///< distance <= stored + bias
};
DepthComparison compare(const DepthPicture& picture, const Vec3<double>& point, double bias);

/// What the depth picture and the shadow ray say of one primary hit that faces the light.
enum class ShadowAnswers {
    none,          ///< no hit, or one that is turned away from the light
    both_lit,      ///< the shadow ray reaches the light, and the depth picture says so
    both_dark,     ///< it is stopped, and the depth picture says so
    wrongly_dark,  ///< the shadow ray reaches the light: acne, and borders
    wrongly_lit    ///< the shadow ray is stopped: light leaks
};
/// Row by row from the top left. Any surface in between stops a shadow ray, as with `opaque`.
std::vector<ShadowAnswers> shadow_answers(const World<double>& world, std::size_t light,
                                          const DepthPicture& picture, double bias);

/// The same, counted.
struct DepthAgreement {
    std::size_t compared = 0;
    std::size_t wrongly_dark = 0;
    std::size_t wrongly_lit = 0;
    std::size_t differ() const { return wrongly_dark + wrongly_lit; }
};
DepthAgreement agreement(const World<double>& world, std::size_t light, const DepthPicture& picture,
                         double bias);

}  // namespace raytree
