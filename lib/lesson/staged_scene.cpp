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

}  // namespace

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
    staged->document = Json::parse(write_scene_json(staged->loaded.scene));
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
    changed->document = Json::parse(write_scene_json(changed->loaded.scene));
    return changed;
}

}  // namespace raytree::lesson
