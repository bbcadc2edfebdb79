#include "lesson/staged_scene.h"

#include "formats/did_you_mean.h"
#include "formats/output_file.h"
#include "formats/scene_json.h"
#include "scene/json_pointer.h"

namespace raytree::lesson {
namespace {

/// The name that an element of `lights` or `objects` goes by.
std::string name_of(const Json& element, const std::string& list, std::size_t place) {
    if (element.contains("name") && element["name"].is_string()) {
        return element["name"].get<std::string>();
    }
    const bool light = list == "lights";
    const std::string type = light ? "light" : element.value("type", std::string("object"));
    return type + std::to_string(place);
}

Json* find_named(Json& list, const std::string& key, const std::string& name) {
    for (std::size_t k = 0; k < list.size(); ++k) {
        if (list[k].is_object() && name_of(list[k], key, k) == name) {
            return &list[k];
        }
    }
    return nullptr;
}

[[noreturn]] void no_such(const Json& list, const std::string& key, const std::string& name) {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < list.size(); ++k) {
        names.push_back(name_of(list[k], key, k));
    }
    const std::vector<std::string_view> views(names.begin(), names.end());
    throw InputError("", "/" + key + json_pointer_part(name),
                     "the scene's " + key + " have no '" + name + "'" + did_you_mean(name, views) +
                         "; a new one needs its type");
}

/// Patches a list by the names of its elements: null takes one away, a new one needs its type.
void patch_named(Json& list, const std::string& key, const Json& patch) {
    for (const auto& [name, change] : patch.items()) {
        Json* const element = find_named(list, key, name);
        if (element != nullptr && change.is_null()) {
            list.erase(list.begin() + (element - &list[0]));
        } else if (element != nullptr) {
            // A default name holds the place in the list; it must not move with it.
            (*element)["name"] = name;
            element->merge_patch(change);
        } else if (change.is_object() && change.contains("type")) {
            Json added = change;
            added["name"] = name;
            list.push_back(std::move(added));
        } else {
            no_such(list, key, name);
        }
    }
}

void apply(Json& document, const Json& change) {
    for (const auto& [key, part] : change.items()) {
        if ((key == "lights" || key == "objects") && part.is_object()) {
            if (!document.contains(key)) {
                document[key] = Json::array();
            }
            patch_named(document[key], key, part);
        } else {
            document.merge_patch(Json{{key, part}});
        }
    }
}

Json numbers(const Colour& c) { return Json::array({c.r, c.g, c.b}); }

/// Adds a member that the writer has left out because it is the default.
template <class T> void complete(Json& object, const char* key, const T& value) {
    if (!object.contains(key)) {
        object[key] = value;
    }
}

void complete_material(Json& json, const Material& material) {
    complete(json, "color", numbers(material.color));
    complete(json, "specular_color", numbers(material.specular_color));
    complete(json, "ka", numbers(material.ka));
    complete(json, "kd", numbers(material.kd));
    complete(json, "ks", numbers(material.ks));
    complete(json, "kr", numbers(material.kr));
    complete(json, "kt", numbers(material.kt));
    complete(json, "shininess", material.shininess);
    complete(json, "ior", material.ior);
}

/// The scene's document with every default written out.
Json whole_document(const Scene& scene) {
    Json document = Json::parse(write_scene_json(scene));
    complete(document, "background", numbers(scene.background));
    complete(document, "ambient", numbers(scene.ambient));
    JsonWriter settings;
    write_settings_json(settings, scene.settings);
    document["settings"] = Json::parse(settings.take());
    complete(document["camera"], "up",
             Json::array({scene.camera.up.x, scene.camera.up.y, scene.camera.up.z}));
    complete(document["camera"], "near", scene.camera.near);
    complete(document, "materials", Json::object());
    complete(document, "lights", Json::array());
    for (const Material& material : scene.materials) {
        if (!material.in_place) {
            complete_material(document["materials"][material.name], material);
        }
    }
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        Json& light = document["lights"][k];
        complete(light, "name", scene.lights[k].name);
        complete(light, "intensity", numbers(scene.lights[k].intensity));
        if (const auto* point = std::get_if<PointLight>(&scene.lights[k].kind)) {
            const Attenuation& f = point->attenuation;
            complete(light, "attenuation", Json::array({f.a, f.b, f.c}));
        }
    }
    for (std::size_t k = 0; k < scene.objects.size(); ++k) {
        Json& object = document["objects"][k];
        complete(object, "name", scene.objects[k].name);
        const Material& material = scene.materials[scene.objects[k].material];
        if (material.in_place) {
            complete_material(object["material"], material);
        }
    }
    return document;
}

}  // namespace

std::shared_ptr<const StagedScene> as_it_is(const std::filesystem::path& file, LoadedScene loaded) {
    auto staged = std::make_shared<StagedScene>();
    staged->file = file;
    staged->document = whole_document(loaded.scene);
    staged->loaded = std::move(loaded);
    return staged;
}

std::shared_ptr<const StagedScene> stage_scene(const std::filesystem::path& file,
                                               const Json& change) {
    auto staged = std::make_shared<StagedScene>();
    staged->file = file;
    staged->loaded = load_scene(file);
    if (!change.is_null()) {
        Json document = staged->loaded.format == SceneFormat::json
                            ? parse_json(read_input(file), file.string())
                            : Json::parse(write_scene_json(staged->loaded.scene));
        apply(document, change);
        // Read again as a text, so that the same rules hold as for any scene's file.
        staged->loaded.warnings.clear();
        staged->loaded.scene = read_scene_json(document.dump(), file, staged->loaded.warnings);
    }
    staged->document = whole_document(staged->loaded.scene);
    return staged;
}

std::shared_ptr<const StagedScene> change_scene(const StagedScene& scene,
                                                const std::string& pointer, const Json& value) {
    auto changed = std::make_shared<StagedScene>(scene);
    Json document = scene.document;
    try {
        Json& member = document.at(Json::json_pointer(pointer));
        member = value;
    } catch (const Json::exception&) {
        throw InputError(scene.file.string(), pointer, "the scene has no such member");
    }
    changed->loaded.scene = read_scene_json(document.dump(), scene.file, changed->loaded.warnings);
    changed->document = whole_document(changed->loaded.scene);
    return changed;
}

}  // namespace raytree::lesson
