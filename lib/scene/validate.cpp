#include "scene/validate.h"

#include <string_view>
#include <unordered_map>

#include "scene/progress.h"
#include "scene/range_check.h"

namespace raytree {
namespace {

/// The sine below which two directions count as parallel.
constexpr double kParallel = 1e-12;

void check_window(const Camera& camera, const JsonPlace& at, RangeCheck& check) {
    if (const auto* fov = std::get_if<HorizontalFov>(&camera.window)) {
        check.require(fov->degrees > 0 && fov->degrees < 180, at.member("horizontal_fov_degrees"),
                      fov->degrees, "over 0 and under 180");
        return;
    }
    const auto& plane = std::get<ImagePlane>(camera.window);
    const double width = plane.right - plane.left;
    const double height = plane.top - plane.bottom;
    if (!(width > 0 && height > 0 && isfinite(width) && isfinite(height))) {
        check.add(at.member("image_plane"),
                  "found [" + shown_number(plane.left) + ", " + shown_number(plane.right) + ", " +
                      shown_number(plane.bottom) + ", " + shown_number(plane.top) +
                      "], must be finite numbers [left, right, bottom, top] with left < right and "
                      "bottom < top");
    }
}

void check_picture(const Camera& camera, const JsonPlace& at, RangeCheck& check) {
    constexpr const char* side = "a whole number from 1 to 65535";
    const auto is_side = [](int n) { return n >= 1 && n <= kLargestSide; };
    const bool width = check.require(is_side(camera.width), at.member("width"), camera.width, side);
    const bool height =
        check.require(is_side(camera.height), at.member("height"), camera.height, side);
    const long long pixels = static_cast<long long>(camera.width) * camera.height;
    if (width && height && pixels > kMostPixels) {
        check.add(at, "width times height is " + std::to_string(pixels) +
                          " pixels; at most 2^28 = " + std::to_string(kMostPixels) +
                          " are allowed");
    }
}

void check_view(const Camera& camera, const JsonPlace& at, RangeCheck& check) {
    const bool eye = check.finite(at.member("eye"), camera.eye);
    const bool look_at = check.finite(at.member("look_at"), camera.look_at);
    const bool up = check.direction(at.member("up"), camera.up);
    if (!eye || !look_at) {
        return;
    }
    const Point view = camera.look_at - camera.eye;
    if (camera.eye == camera.look_at) {
        check.add(at, "eye and look_at are the same point; they must differ");
    } else if (!isfinite(largest_component(view))) {
        check.add(at, "eye and look_at are too far apart; their difference must be finite");
    } else if (up && length(outer(UnitVec3<double>::of(view).vec(),
                                  UnitVec3<double>::of(camera.up).vec())) < kParallel) {
        check.add(at, "up is parallel to the view from eye to look_at; it must not be");
    }
}

void check_camera(const Camera& camera, const JsonPlace& at, RangeCheck& check) {
    check_view(camera, at, check);
    check_window(camera, at, check);
    check.not_negative(at.member("near"), camera.near);
    check_picture(camera, at, check);
}

void check_settings(const Settings& settings, const JsonPlace& at, RangeCheck& check) {
    check.require(settings.max_depth >= 1 && settings.max_depth <= kDeepest, at.member("max_depth"),
                  settings.max_depth, "a whole number from 1 to 64");
    check.not_negative(at.member("min_weight"), settings.min_weight);
    if (settings.max_distance) {
        check.positive(at.member("max_distance"), *settings.max_distance);
    }
    check.attenuation(at.member("attenuation"), settings.attenuation);
    if (settings.secondary_background) {
        check.finite(at.member("secondary_background"), *settings.secondary_background);
    }
    check.require(settings.ray_budget >= 1, at.member("ray_budget"), 0, "a whole number from 1");
}

void check_material(const Material& material, const JsonPlace& at, RangeCheck& check) {
    check.finite(at.member("color"), material.color);
    check.finite(at.member("specular_color"), material.specular_color);
    check.not_negative(at.member("ka"), material.ka);
    check.not_negative(at.member("kd"), material.kd);
    check.not_negative(at.member("ks"), material.ks);
    check.not_negative(at.member("kr"), material.kr);
    check.not_negative(at.member("kt"), material.kt);
    check.not_negative(at.member("shininess"), material.shininess);
    check.positive(at.member("ior"), material.ior);
}

void check_named_materials(const Scene& scene, const JsonPlace& top, RangeCheck& check) {
    const JsonPlace list = top.member("materials");
    std::unordered_map<std::string_view, std::size_t> names;
    for (std::size_t k = 0; k < scene.materials.size(); ++k) {
        const Material& material = scene.materials[k];
        if (material.in_place) {
            continue;
        }
        const JsonPlace at = list.member(material.name);
        if (!names.emplace(material.name, k).second) {
            check.add(at, "the name " + quoted(material.name) + " is given to two materials");
        }
        check_material(material, at, check);
    }
}

void check_light(const Light& light, const JsonPlace& at, RangeCheck& check) {
    check.finite(at.member("intensity"), light.intensity);
    if (const auto* point = std::get_if<PointLight>(&light.kind)) {
        check.finite(at.member("position"), point->position);
        check.attenuation(at.member("attenuation"), point->attenuation);
    } else {
        check.direction(at.member("direction"), std::get<DirectionalLight>(light.kind).direction);
    }
}

void check_material_of(const Object& object, const Scene& scene, const JsonPlace& at,
                       RangeCheck& check) {
    if (object.material >= scene.materials.size()) {
        check.add(at.member("material"), "is missing; an object needs a material");
    } else if (scene.materials[object.material].in_place) {
        check_material(scene.materials[object.material], at.member("material"), check);
    }
}

template <class Named>
void check_names(const std::vector<Named>& named, const JsonPlace& list, RangeCheck& check) {
    std::unordered_map<std::string_view, std::size_t> first;
    first.reserve(named.size());
    for (std::size_t k = 0; k < named.size(); ++k) {
        const auto [place, is_new] = first.emplace(named[k].name, k);
        if (!is_new) {
            const JsonPlace at = list.element(k);
            check.add(at.member("name"), "the name " + quoted(named[k].name) + " is that of " +
                                             list.element(place->second).pointer() +
                                             " already, given or by default; each needs a name of "
                                             "its own");
        }
    }
}

}  // namespace

std::vector<Mistake> validate(const Scene& scene) {
    RangeCheck check;
    const JsonPlace top;
    check_camera(scene.camera, top.member("camera"), check);
    check_settings(scene.settings, top.member("settings"), check);
    check.finite(top.member("background"), scene.background);
    check.finite(top.member("ambient"), scene.ambient);
    check_named_materials(scene, top, check);
    const JsonPlace lights = top.member("lights");
    check_names(scene.lights, lights, check);
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        check_light(scene.lights[k], lights.element(k), check);
    }
    const JsonPlace objects = top.member("objects");
    check_names(scene.objects, objects, check);
    ProgressCounter progress("checking");
    for (std::size_t k = 0; k < scene.objects.size(); ++k) {
        progress.at(k, scene.objects.size());
        const JsonPlace at = objects.element(k);
        check_material_of(scene.objects[k], scene, at, check);
        check_object(scene.objects[k], at, check);
    }
    return check.take();
}

}  // namespace raytree
