#include <span>
#include <string>

#include "formats/scene_json.h"
#include "formats/scene_words.h"

namespace raytree {
namespace {

using Layout = JsonWriter::Layout;

/// One number where all channels are the same.
void short_colour(JsonWriter& json, std::string_view key, const Colour& c) {
    json.key(key);
    if (c.r == c.g && c.g == c.b) {
        json.value(c.r);
    } else {
        json.value(c);
    }
}

void attenuation(JsonWriter& json, const Attenuation& f) {
    json.key("attenuation").numbers({f.a, f.b, f.c});
}

/// Writes members, those that have their default value only where asked to.
struct SettingsWriter {
    JsonWriter& json;
    bool defaults_too;

    template <class Value, class Write>
    void member(std::string_view key, const Value& value, const Value& usual, Write write) {
        if (defaults_too || !(value == usual)) {
            json.key(key);
            write(value);
        }
    }
    template <class Value>
    void member(std::string_view key, const Value& value, const Value& usual) {
        member(key, value, usual, [&](const Value& v) { json.value(v); });
    }
    template <class Enumeration>
    void word(std::string_view key, const Words& words, Enumeration value, Enumeration usual) {
        member(key, value, usual, [&](Enumeration v) { json.value(word_of(words, v)); });
    }
};

void write_settings(JsonWriter& json, const Settings& settings, bool defaults_too) {
    const Settings usual;
    SettingsWriter to{json, defaults_too};
    json.begin_object();
    to.member("max_depth", settings.max_depth, usual.max_depth);
    to.member("min_weight", settings.min_weight, usual.min_weight);
    to.member("max_distance", settings.max_distance, usual.max_distance);
    to.member("attenuation", settings.attenuation, usual.attenuation, [&](const Attenuation& f) {
        json.numbers({f.a, f.b, f.c});
    });
    to.word("specular_model", kSpecularModelWords, settings.specular_model, usual.specular_model);
    to.word("shadows", kShadowModeWords, settings.shadows, usual.shadows);
    to.word("total_internal_reflection", kTotalReflectionWords, settings.total_internal_reflection,
            usual.total_internal_reflection);
    to.word("pixel_sample", kPixelSampleWords, settings.pixel_sample, usual.pixel_sample);
    to.member("secondary_background", settings.secondary_background, usual.secondary_background);
    to.word("quantize", kQuantizeWords, settings.quantize, usual.quantize);
    to.member("ray_budget", settings.ray_budget, usual.ray_budget);
    json.end_object();
}

bool is_usual(const Settings& settings) {
    JsonWriter json;
    write_settings(json, settings, false);
    return json.take() == "{}\n";
}

/// Defaults are left out, except that `color` says what the thing looks like.
void material(JsonWriter& json, const Material& material) {
    const Material usual;
    json.begin_object();
    json.member("color", material.color);
    if (!(material.specular_color == usual.specular_color)) {
        json.member("specular_color", material.specular_color);
    }
    const auto coefficient = [&](std::string_view key, const Colour& c, const Colour& default_c) {
        if (!(c == default_c)) {
            short_colour(json, key, c);
        }
    };
    coefficient("ka", material.ka, usual.ka);
    coefficient("kd", material.kd, usual.kd);
    coefficient("ks", material.ks, usual.ks);
    coefficient("kr", material.kr, usual.kr);
    coefficient("kt", material.kt, usual.kt);
    if (material.shininess != usual.shininess) {
        json.member("shininess", material.shininess);
    }
    if (material.ior != usual.ior) {
        json.member("ior", material.ior);
    }
    json.end_object();
}

void light(JsonWriter& json, const Light& light) {
    json.begin_object();
    json.member("name", light.name).member("type", kLightTypeWords[light.kind.index()]);
    if (const auto* point = std::get_if<PointLight>(&light.kind)) {
        json.member("position", point->position);
        short_colour(json, "intensity", light.intensity);
        if (!(point->attenuation == Attenuation{})) {
            attenuation(json, point->attenuation);
        }
    } else {
        json.member("direction", std::get<DirectionalLight>(light.kind).direction);
        short_colour(json, "intensity", light.intensity);
    }
    json.end_object();
}

void points(JsonWriter& json, std::string_view key, const std::vector<Point>& points) {
    json.key(key).begin_array();
    for (const Point& point : points) {
        json.value(point);
    }
    json.end_array();
}

void shape(JsonWriter& json, const Sphere& sphere) {
    json.member("center", sphere.center).member("radius", sphere.radius);
}

void shape(JsonWriter& json, const Polygon& polygon) {
    points(json, "vertices", polygon.vertices);
    if (!polygon.normals.empty()) {
        points(json, "normals", polygon.normals);
    }
}

void shape(JsonWriter& json, const Cone& cone) {
    json.member("base", cone.base).member("base_radius", cone.base_radius);
    json.member("apex", cone.apex).member("apex_radius", cone.apex_radius);
}

void shape(JsonWriter& json, const Mesh& mesh) {
    json.member("file", mesh.file);
    if (!mesh.smooth) {
        json.member("smooth", mesh.smooth);
    }
}

void transform(JsonWriter& json, const Affine& m) {
    json.key("transform").begin_array();
    for (const auto& row : m) {
        json.numbers(std::span<const double>(row));
    }
    json.numbers({0, 0, 0, 1}).end_array();
}

void object(JsonWriter& json, const Object& object, const Material& its_material) {
    json.begin_object();
    json.member("name", object.name).member("type", type_word(object.shape));
    std::visit([&](const auto& s) { shape(json, s); }, object.shape);
    if (object.transform) {
        transform(json, *object.transform);
    }
    json.key("material");
    if (its_material.in_place) {
        material(json, its_material);
    } else {
        json.value(its_material.name);
    }
    json.end_object();
}

}  // namespace

void write_camera_json(JsonWriter& json, const Camera& camera) {
    json.begin_object();
    json.member("eye", camera.eye).member("look_at", camera.look_at).member("up", camera.up);
    if (const auto* fov = std::get_if<HorizontalFov>(&camera.window)) {
        json.member("horizontal_fov_degrees", fov->degrees);
    } else {
        const auto& plane = std::get<ImagePlane>(camera.window);
        json.key("image_plane").numbers({plane.left, plane.right, plane.bottom, plane.top});
    }
    if (camera.near != 0) {
        json.member("near", camera.near);
    }
    json.member("width", camera.width).member("height", camera.height);
    json.end_object();
}

void write_settings_json(JsonWriter& json, const Settings& settings) {
    write_settings(json, settings, true);
}

void write_scene_json(JsonWriter& json, const Scene& scene) {
    json.begin_object(Layout::block);
    json.member("format", "raytree-scene/1.0").member("name", scene.name);
    write_camera_json(json.key("camera"), scene.camera);
    json.member("background", scene.background).member("ambient", scene.ambient);
    if (!is_usual(scene.settings)) {
        write_settings(json.key("settings"), scene.settings, false);
    }
    json.key("materials").begin_object(Layout::block);
    for (const Material& each : scene.materials) {
        if (!each.in_place) {
            material(json.key(each.name), each);
        }
    }
    json.end_object();
    json.key("lights").begin_array(Layout::block);
    for (const Light& each : scene.lights) {
        light(json, each);
    }
    json.end_array();
    json.key("objects").begin_array(Layout::block);
    for (const Object& each : scene.objects) {
        object(json, each, scene.materials[each.material]);
    }
    json.end_array();
    json.end_object();
}

std::string write_scene_json(const Scene& scene) {
    JsonWriter json;
    write_scene_json(json, scene);
    return json.take();
}

}  // namespace raytree
