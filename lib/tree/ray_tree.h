#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "math/rgb.h"
#include "math/vector.h"
#include "scene/scene.h"
#include "trace/reason.h"

/// One pixel's ray tree as data, in the terms of the format raytree/1.0. `T` is the arithmetic that
/// it was traced in; programs that only look at trees use `RayTree<double>`.
namespace raytree {

enum class Side { front, back };

/// Refraction at a hit; there where the material's kt is not 0.
template <class T> struct Interface {
    T eta1{};              ///< refractive index on the ray's side
    T eta2{};              ///< refractive index beyond
    T sin2_transmitted{};  ///< (eta1 / eta2)^2 (1 - cos_incident^2); over 1: total reflection
};

template <class T> struct TreeHit {
    std::string object;  ///< a mesh's triangle k is "name#k"
    std::string material;
    T t{};  ///< distance along the ray
    Vec3<T> point{};
    Vec3<T> normal{};  ///< unit shading normal, on the ray's side of the geometric one's sign
    Side side = Side::front;
    T cos_incident{};  ///< -d . n; may be negative where the shading normal is skewed
    std::optional<Interface<T>> interface;
    /// The coefficients of the two branches as used here: kt is added to kr under total internal
    /// reflection where the scene asks for that. Not in the format: unknown (0) in a tree read
    /// without its scene.
    Rgb<T> kr, kt;
};

/// A ray that was not sent from a hit.
struct Skipped {
    RayKind kind = RayKind::shadow;
    std::string light;  ///< of a shadow ray, else empty
    Reason reason = Reason::not_reflective;
};

template <class T> struct Blocker {
    std::string object;
    T t{};
};

/// What only a shadow ray has.
template <class T> struct ShadowPart {
    std::string light;
    std::optional<T> distance;  ///< to the light; none for a directional one
    std::optional<Blocker<T>> blocked_by;
    Rgb<T> transmittance{T(1)};
};

template <class T> struct TreeRay {
    std::size_t id = 0;                 ///< its place in RayTree::rays
    std::optional<std::size_t> parent;  ///< none for the primary ray
    RayKind kind = RayKind::primary;
    int level = 1;  ///< 1 for the primary ray; a shadow ray has its parent's
    Vec3<T> origin{};
    Vec3<T> direction{};  ///< unit
    Rgb<T> weight{
        T(1)};  ///< the factor with which `intensity` enters the pixel, without `attenuation`
    T attenuation =
        T(1);  ///< f of the distance to its hit; 1 for the primary ray and without a hit
    std::optional<TreeHit<T>> hit;
    Rgb<T> ambient, diffuse, specular;    ///< of the hit; of a shadow ray: what the light adds
    Rgb<T> intensity;                     ///< of a shadow ray: unused
    std::optional<Reason> termination;    ///< none where a branch was grown
    std::vector<Skipped> skipped;         ///< lights, reflected, refracted
    std::optional<ShadowPart<T>> shadow;  ///< there for a shadow ray, and only there
};

struct TreeCounts {
    std::size_t primary = 0, reflected = 0, refracted = 0, shadow = 0;
    int levels = 0;  ///< the deepest level that a ray reached
    std::size_t lights = 0;
    double full_tree = 0;                ///< (m + 1)(2^n - 1), m lights and n = max_depth levels
    std::size_t intersection_tests = 0;  ///< of a ray with a shape; a measurement

    std::size_t all() const { return primary + reflected + refracted + shadow; }
};

template <class T> struct RayTree {
    std::string generator;
    std::string scene_name;
    std::string scene_sha256;  ///< of the scene file's bytes, hexadecimal; may be empty
    int pixel_i = 0;           ///< column, from the left
    int pixel_j = 0;           ///< row, from the top
    Camera camera;
    Settings settings;
    Rgb<T> intensity;  ///< of the pixel: that of rays[0]
    TreeCounts counts;
    std::vector<TreeRay<T>> rays;  ///< depth first: a ray, its shadow rays, reflected, refracted
};

}  // namespace raytree
