#include "scene_report.h"

#include <array>
#include <utility>
#include <vector>

#include "formats/json_parse.h"
#include "formats/scene_json.h"
#include "formats/styled_text.h"
#include "tree/explain.h"

namespace raytree::cli {
namespace {

constexpr std::array<const char*, 4> format_names = {"raytree-scene", "Neutral File Format",
                                                     "course text format", "Wavefront OBJ"};

/// Something that tracing may take.
struct Need {
    const char* key;        ///< in JSON
    const char* name;       ///< for people
    bool Plan::*needed;     ///< whether this scene takes it
    const char* otherwise;  ///< why it can be left out
};

constexpr std::array<Need, 12> needs = {{
    {"reflection", "reflected rays", &Plan::reflective, "kr is 0 everywhere"},
    {"transmission", "refracted rays, and the media they are in", &Plan::transmissive,
     "kt is 0 everywhere"},
    {"attenuation", "rays that weaken with distance", &Plan::attenuated,
     "no ray has a branch, or attenuation is (1, 0, 0)"},
    {"lighting", "light from the lights", &Plan::lit, "no light, or kd and ks are 0 everywhere"},
    {"specular", "highlights", &Plan::specular, "ks is 0 everywhere, or no light"},
    {"shadows", "shadow rays", &Plan::shadow_rays, "nothing is lit, or shadows is none"},
    {"transmissive_shadows", "shadow rays that pass through surfaces", &Plan::shadows_through,
     "shadows is not transmissive, or kt is 0 everywhere"},
    {"light_attenuation", "lights that weaken with distance", &Plan::light_attenuated,
     "nothing is lit by a point light with an attenuation"},
    {"interpolated_normals", "interpolated normals", &Plan::interpolated_normals,
     "no vertex normals"},
    {"transforms", "rays taken to an object's own space", &Plan::transforms, "no transforms"},
    {"near_plane", "a near plane", &Plan::near_plane, "near is 0"},
    {"max_distance", "a limit on paths", &Plan::path_limited, "max_distance is null"},
}};

std::string counted(std::size_t n, const std::string& one, const std::string& many) {
    return std::to_string(n) + ' ' + (n == 1 ? one : many);
}

/// "3 spheres, 1 cone"; kinds that do not occur are left out.
std::string list_of(const std::vector<std::pair<std::size_t, std::string>>& kinds) {
    std::string text;
    for (const auto& [n, one] : kinds) {
        if (n > 0) {
            const std::string many = one == "mesh" ? "meshes" : one + 's';
            text += (text.empty() ? "" : ", ") + counted(n, one, many);
        }
    }
    return text.empty() ? "none" : text;
}

std::string shapes_text(const Plan& plan) {
    const std::string meshes =
        plan.meshes > 0 ? " (" + counted(plan.triangles, "triangle", "triangles") + ")" : "";
    return list_of({{plan.spheres, "sphere"},
                    {plan.polygons, "polygon"},
                    {plan.cones, "cone"},
                    {plan.meshes, "mesh"}}) +
           meshes;
}

std::string camera_text(const Camera& camera) {
    std::string window;
    if (const auto* fov = std::get_if<HorizontalFov>(&camera.window)) {
        window = number_text(fov->degrees) + "° wide";
    } else {
        const auto& plane = std::get<ImagePlane>(camera.window);
        window = "window " + number_text(plane.left) + " to " + number_text(plane.right) + " by " +
                 number_text(plane.bottom) + " to " + number_text(plane.top) + " at distance 1";
    }
    const std::string near = camera.near > 0 ? ", near " + number_text(camera.near) : "";
    return std::to_string(camera.width) + " x " + std::to_string(camera.height) + " pixels, " +
           window + ", from " + point_text(camera.eye) + " towards " + point_text(camera.look_at) +
           near;
}

Json settings_of(const Settings& settings) {
    JsonWriter json;
    write_settings_json(json, settings);
    return parse_json(json.take(), "");
}

std::string settings_text(const Settings& settings) {
    const Json defaults = settings_of({});
    const Json chosen = settings_of(settings);
    std::string text;
    for (const auto& [key, value] : chosen.items()) {
        if (value != defaults.at(key)) {
            text += (text.empty() ? "" : ", ") + key + ' ' +
                    (value.is_string() ? value.get<std::string>() : value.dump());
        }
    }
    return text.empty() ? "the defaults" : text + "; else the defaults";
}

std::string bytes_text(std::size_t bytes) {
    return bytes < 10'000 ? std::to_string(bytes) + " bytes"
                          : number_text(static_cast<double>(bytes) / 1000) + " kB";
}

void add_needs(StyledText& out, const Plan& plan) {
    out.line("", {{Style::heading, "Tracing it takes"}});
    for (const Need& need : needs) {
        if (plan.*need.needed) {
            out.line("  ", {{Style::plain, need.name}});
        }
    }
    if (!plan.reflective && !plan.transmissive && !plan.lit) {
        out.line("  ", {{Style::plain, "primary rays alone"}});
    }
    out.line("", {{Style::heading, "It does without"}});
    for (const Need& need : needs) {
        if (!(plan.*need.needed)) {
            out.line("  ",
                     {{Style::plain, padded(need.name, 43)}, {Style::absent, need.otherwise}});
        }
    }
}

void add_shapes(JsonWriter& json, const Plan& plan) {
    json.key("shapes").begin_object();
    json.member("sphere", plan.spheres).member("polygon", plan.polygons);
    json.member("cone", plan.cones).member("mesh", plan.meshes);
    json.member("triangles", plan.triangles).end_object();
    json.key("lights").begin_object();
    json.member("point", plan.point_lights).member("directional", plan.directional_lights);
    json.end_object();
}

}  // namespace

std::string report_text(const SceneReport& report) {
    const Scene& scene = report.loaded.scene;
    const Plan& plan = report.plan;
    StyledText out(false, 100);
    const auto row = [&](const char* label, const std::string& text) {
        out.paragraph(padded(label, 11), padded("", 11), {{Style::plain, text}});
    };
    out.line("", {{Style::heading, scene.name}});
    row("file", report.file + ", " + format_names[static_cast<std::size_t>(report.loaded.format)]);
    row("camera", camera_text(scene.camera));
    row("objects", shapes_text(plan));
    row("materials", std::to_string(scene.materials.size()) +
                         (plan.materials == scene.materials.size()
                              ? ""
                              : ", " + std::to_string(plan.materials) + " in use"));
    row("lights", list_of({{plan.point_lights, "point light"},
                           {plan.directional_lights, "directional light"}}));
    row("settings", settings_text(scene.settings));
    row("hierarchy", counted(plan.shapes(), "shape", "shapes") + " in " +
                         counted(report.hierarchy_nodes, "node", "nodes") + ", " +
                         bytes_text(report.hierarchy_bytes));
    row("full tree", "at most " + number_text(full_tree_rays(scene)) + " rays a pixel: (" +
                         counted(scene.lights.size(), "light", "lights") + " + 1) (2^" +
                         std::to_string(scene.settings.max_depth) + " - 1)");
    add_needs(out, plan);
    return out.take();
}

std::string report_json(const SceneReport& report) {
    const Scene& scene = report.loaded.scene;
    JsonWriter json;
    json.begin_object(JsonWriter::Layout::block);
    json.member("name", std::string_view(scene.name));
    json.member("file", std::string_view(report.file));
    json.member("file_format", format_names[static_cast<std::size_t>(report.loaded.format)]);
    json.member("sha256", std::string_view(report.loaded.sha256));
    json.key("camera");
    write_camera_json(json, scene.camera);
    add_shapes(json, report.plan);
    json.member("materials", scene.materials.size());
    json.key("settings");
    write_settings_json(json, scene.settings);
    json.key("needs").begin_object();
    for (const Need& need : needs) {
        json.member(need.key, report.plan.*need.needed);
    }
    json.end_object();
    json.key("skipped").begin_object(JsonWriter::Layout::block);
    for (const Need& need : needs) {
        if (!(report.plan.*need.needed)) {
            json.member(need.key, need.otherwise);
        }
    }
    json.end_object();
    json.key("hierarchy").begin_object();
    json.member("shapes", report.plan.shapes()).member("nodes", report.hierarchy_nodes);
    json.member("bytes", report.hierarchy_bytes).end_object();
    json.member("full_tree", full_tree_rays(scene));
    json.end_object();
    return json.take();
}

}  // namespace raytree::cli
