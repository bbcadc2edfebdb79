#include "formats/tree_template.h"

#include <initializer_list>
#include <string_view>

#include "formats/json_text.h"
#include "formats/scene_json.h"
#include "formats/tree_title.h"

namespace raytree {
namespace {

using Layout = JsonWriter::Layout;

constexpr std::string_view number_line = "________";
constexpr std::string_view word_line = "______________";

void write_empty(JsonWriter& json, std::initializer_list<std::string_view> keys) {
    for (const std::string_view key : keys) {
        json.key(key).null();
    }
}

void write_ray(JsonWriter& json, const TreeRay<double>& ray) {
    json.begin_object();
    json.member("id", ray.id);
    json.member("parent", ray.parent);
    json.member("kind", word_of(ray.kind));
    if (ray.shadow) {
        json.member("light", ray.shadow->light);
    }
    json.member("level", ray.level);
    write_empty(json, {"origin", "direction"});
    if (ray.shadow) {
        write_empty(json, {"distance", "transmittance", "diffuse", "specular"});
    } else {
        write_empty(json, {"weight", "attenuation"});
    }
    if (ray.hit) {
        json.key("hit").begin_object();
        write_empty(json, {"object", "t", "point", "normal", "cos_incident"});
        if (ray.hit->interface) {
            write_empty(json, {"eta", "sin2_transmitted"});
        }
        json.end_object();
        write_empty(json, {"ambient", "diffuse", "specular"});
    }
    if (!ray.shadow) {
        write_empty(json, {"intensity"});
    }
    json.end_object();
}

/// Lines to write on, one quantity each.
class Outline {
  public:
    std::string draw(const RayTree<double>& tree) {
        text_ = "Ray tree of " + pixel_and_scene(tree) + "\n";
        for (const TreeRay<double>& ray : tree.rays) {
            draw_ray(ray);
        }
        return std::move(text_);
    }

  private:
    void draw_ray(const TreeRay<double>& ray) {
        const int depth = ray.shadow ? ray.level : ray.level - 1;
        indent_ = std::string(static_cast<std::size_t>(4 * depth), ' ');
        text_ += '\n' + indent_ + "Ray " + std::to_string(ray.id) + ": " +
                 std::string(word_of(ray.kind)) + (ray.shadow ? " to " + ray.shadow->light : "") +
                 (ray.parent ? ", from the hit of ray " + std::to_string(*ray.parent) : "") + '\n';
        vector("origin");
        vector("direction");
        if (ray.shadow) {
            line("distance to the light = " + std::string(number_line));
            line("is it blocked, and by what? " + std::string(word_line));
            return;
        }
        if (ray.hit) {
            line("hits " + std::string(word_line) + " at t = " + std::string(number_line));
            vector("point");
            vector("normal");
            if (ray.hit->interface) {
                line("eta1 = " + std::string(number_line) + "  eta2 = " + std::string(number_line) +
                     "  sin2_transmitted = " + std::string(number_line));
            }
            for (const char* name : {"ambient", "diffuse", "specular"}) {
                vector(name);
            }
        }
        vector("I");
    }

    void vector(std::string_view name) {
        const std::string blank(number_line);
        line(std::string(name) + " = (" + blank + ", " + blank + ", " + blank + ")");
    }
    void line(const std::string& words) { text_ += indent_ + "  " + words + '\n'; }

    std::string text_, indent_;
};

}  // namespace

std::string write_tree_template_json(const RayTree<double>& tree) {
    JsonWriter json;
    json.begin_object(Layout::block);
    json.member("format", "raytree/1.0");
    json.key("scene").begin_object();
    json.member("name", tree.scene_name);
    if (!tree.scene_sha256.empty()) {
        json.member("sha256", tree.scene_sha256);
    }
    json.end_object();
    json.key("pixel").numbers({tree.pixel_i, tree.pixel_j});
    json.key("camera");
    write_camera_json(json, tree.camera);
    json.key("settings");
    write_settings_json(json, tree.settings);
    json.key("rays").begin_array(Layout::block);
    for (const TreeRay<double>& ray : tree.rays) {
        write_ray(json, ray);
    }
    json.end_array().end_object();
    return json.take();
}

std::string write_tree_template_text(const RayTree<double>& tree) { return Outline().draw(tree); }

}  // namespace raytree
