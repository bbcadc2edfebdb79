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

/// Refuses what is a number in the scene and none, or none that can be squared, in T.
template <class T> void expect_in_range(bool good, const std::string& where, const char* what) {
    if (!good) {
        throw InputError("", where,
                         std::string(what) + " is too large or too small for this precision");
    }
}

template <class T> void check_range(const World<T>& world) {
    const Scene& scene = world.scene();
    const Camera& camera = scene.camera;
    expect_in_range<T>(largest_component(vector_cast<T>(camera.eye)) <= Real<T>::largest_length,
                       "camera", "the eye's distance from the origin");
    for (const int i : {0, camera.width - 1}) {
        for (const int j : {0, camera.height - 1}) {
            const Vec3<T> d = world.camera.primary(i, j).direction;
            expect_in_range<T>(isfinite(inner(d, d)), "camera", "its window or a distance in it");
        }
    }
    for (std::size_t k = 0; k < world.materials.size(); ++k) {
        const WorldMaterial<T>& m = world.materials[k];
        const std::string where = "material '" + scene.materials[k].name + "'";
        expect_in_range<T>(m.ior <= Real<T>::largest_factor && m.ior * Real<T>::largest_factor >= 1,
                           where, "ior");
        expect_in_range<T>(isfinite(m.ambient) && isfinite(m.diffuse) && isfinite(m.specular) &&
                               isfinite(m.kr) && isfinite(m.kt) && isfinite(m.shininess),
                           where, "a coefficient or a product of two");
    }
    for (std::size_t k = 0; k < world.lights.size(); ++k) {
        const WorldLight<T>& light = world.lights[k];
        expect_in_range<T>(isfinite(light.intensity) && isfinite(largest_component(light.position)),
                           "light '" + scene.lights[k].name + "'", "its place or intensity");
    }
    expect_in_range<T>(isfinite(world.background) && isfinite(world.secondary_background),
                       "background", "a channel");
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

template <class T> World<T>::World(const Scene& scene, Build build)
    : shapes(scene, build),
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
    material_of_object.reserve(scene.objects.size());
    for (const Object& object : scene.objects) {
        material_of_object.push_back(static_cast<std::uint32_t>(object.material));
    }
    for (const Light& light : scene.lights) {
        lights.push_back(light_of<T>(light));
    }
    check_range(*this);
}

template class World<float>;
template class World<double>;
template class World<Quad>;

}  // namespace raytree
