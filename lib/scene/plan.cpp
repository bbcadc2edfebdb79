#include "scene/plan.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace raytree {
namespace {

void count(Plan& plan, const Sphere&) { ++plan.spheres; }
void count(Plan& plan, const Cone&) { ++plan.cones; }

void count(Plan& plan, const Polygon& polygon) {
    ++plan.polygons;
    plan.interpolated_normals |= !polygon.normals.empty();
}

void count(Plan& plan, const Mesh& mesh) {
    ++plan.meshes;
    plan.triangles += mesh.triangles.size();
    plan.interpolated_normals |=
        mesh.smooth && std::ranges::any_of(mesh.triangles, [](const Mesh::Triangle& triangle) {
            return std::ranges::all_of(triangle, [](const auto& c) { return c.normal >= 0; });
        });
}

void plan_materials(Plan& plan, const Scene& scene, const std::set<std::size_t>& used) {
    for (const std::size_t place : used) {
        const Material& material = scene.materials[place];
        plan.reflective |= !is_zero(material.kr);
        plan.transmissive |= !is_zero(material.kt);
        plan.lit |= !is_zero(material.kd) || !is_zero(material.ks);
        plan.specular |= !is_zero(material.ks);
    }
    plan.materials = used.size();
}

void plan_lights(Plan& plan, const Scene& scene) {
    for (const Light& light : scene.lights) {
        const auto* point = std::get_if<PointLight>(&light.kind);
        ++(point ? plan.point_lights : plan.directional_lights);
        plan.light_attenuated |= point && point->attenuation != Attenuation{};
    }
}

}  // namespace

Plan plan_of(const Scene& scene) {
    Plan plan;
    std::set<std::size_t> used;
    for (const Object& object : scene.objects) {
        std::visit([&](const auto& shape) { count(plan, shape); }, object.shape);
        plan.transforms |= object.transform.has_value();
        used.insert(object.material);
    }
    plan_materials(plan, scene, used);
    plan_lights(plan, scene);
    const Settings& settings = scene.settings;
    plan.lit &= plan.lights() > 0;
    plan.specular &= plan.lit;
    plan.light_attenuated &= plan.lit;
    plan.shadow_rays = plan.lit && settings.shadows != ShadowMode::none;
    plan.shadows_through =
        plan.shadow_rays && plan.transmissive && settings.shadows == ShadowMode::transmissive;
    plan.attenuated = plan.branches() && settings.attenuation != Attenuation{};
    plan.near_plane = scene.camera.near > 0;
    plan.path_limited = settings.max_distance.has_value();
    return plan;
}

double full_tree_rays(const Scene& scene) {
    return static_cast<double>(scene.lights.size() + 1) *
           (std::ldexp(1.0, scene.settings.max_depth) - 1);
}

}  // namespace raytree
