#include "trace/world.h"

#include "scene/input_error.h"

namespace raytree {
namespace {

template <class T> WorldAttenuation<T> attenuation_of(const Attenuation& f) {
    return {static_cast<T>(f.a), static_cast<T>(f.b), static_cast<T>(f.c)};
}

template <class T> WorldMaterial<T> material_of(const Material& m, const Colour& ambient) {
    const Rgb<T> color = rgb_cast<T>(m.color);
    return {rgb_cast<T>(m.ka) * color * rgb_cast<T>(ambient),
            rgb_cast<T>(m.kd) * color,
            rgb_cast<T>(m.ks) * rgb_cast<T>(m.specular_color),
            rgb_cast<T>(m.kr),
            rgb_cast<T>(m.kt),
            static_cast<T>(m.shininess),
            static_cast<T>(m.ior),
            !is_zero(m.kd) || !is_zero(m.ks),
            !is_zero(m.kr),
            !is_zero(m.kt)};
}

template <class T> WorldLight<T> light_of(const Light& light) {
    WorldLight<T> result;
    result.intensity = rgb_cast<T>(light.intensity);
    if (const auto* point = std::get_if<PointLight>(&light.kind)) {
        result.position = vector_cast<T>(point->position);
        result.attenuation = attenuation_of<T>(point->attenuation);
    } else {
        const Point& travels = std::get<DirectionalLight>(light.kind).direction;
        result.directional = true;
        result.towards = -UnitVec3<T>::of(vector_cast<T>(travels)).vec();
    }
    return result;
}

}  // namespace

template <class T> World<T>::World(const Scene& scene)
    : shapes(scene),
      camera(scene.camera, scene.settings.pixel_sample),
      background(rgb_cast<T>(scene.background)),
      secondary_background(
          rgb_cast<T>(scene.settings.secondary_background.value_or(scene.background))),
      attenuation(attenuation_of<T>(scene.settings.attenuation)),
      min_weight(static_cast<T>(scene.settings.min_weight)),
      scene_(&scene) {
    if (scene.settings.max_distance) {
        max_distance = static_cast<T>(*scene.settings.max_distance);
    }
    for (const Material& material : scene.materials) {
        materials.push_back(material_of<T>(material, scene.ambient));
    }
    for (const Light& light : scene.lights) {
        lights.push_back(light_of<T>(light));
    }
}

template class World<float>;
template class World<double>;
template class World<Quad>;

}  // namespace raytree
