#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "accel/intersector.h"
#include "scene/scene.h"
#include "trace/camera_rays.h"

namespace raytree {

/// A material in the arithmetic T, with what the tracer asks of it again and again.
template <class T> struct WorldMaterial {
    Rgb<T> ambient;   ///< ka * color * scene ambient
    Rgb<T> diffuse;   ///< kd * color
    Rgb<T> specular;  ///< ks * specular_color
    Rgb<T> kr, kt;
    T shininess, ior;
    bool lit;         ///< kd or ks is not 0 in some channel
    bool reflective;  ///< kr likewise
    bool transmissive;
};

template <class T> struct WorldAttenuation {
    T a = 1, b = 0, c = 0;
    /// `min(1, 1 / (a + b t + c t^2))`
    T at(T t) const { return min_of(T(1), 1 / fma(t, fma(t, c, b), a)); }
};

template <class T> struct WorldLight {
    bool directional = false;
    Vec3<T> position{};  ///< of a point light
    Vec3<T> towards{};   ///< of a directional one: unit, against the way it travels
    Rgb<T> intensity;
    WorldAttenuation<T> attenuation;
};

/// A scene prepared for tracing in the arithmetic T. The scene given must outlive it.
template <class T> class World {
  public:
    /// Throws InputError where a number of the scene is too large for T.
    explicit World(const Scene& scene, Build build = Build::whole);
    explicit World(const Scene&&, Build = Build::whole) = delete;

    const Scene& scene() const { return *scene_; }

    Intersector<T> shapes;
    CameraRays<T> camera;
    std::vector<WorldMaterial<T>> materials;
    std::vector<std::uint32_t> material_of_object;  ///< places among the materials
    std::vector<WorldLight<T>> lights;
    Rgb<T> background;
    Rgb<T> secondary_background;
    WorldAttenuation<T> attenuation;
    T min_weight;
    std::optional<T> max_distance;

  private:
    const Scene* scene_;
};

extern template class World<float>;
extern template class World<double>;
extern template class World<Quad>;

}  // namespace raytree
