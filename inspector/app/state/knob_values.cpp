#include <algorithm>

#include "formats/scene_json.h"
#include "state/knob_entries.h"

/// A knob is turned by giving its value to the reader of scene files: what a file may not say, a
/// slider may not either, and the message is the same.
namespace raytree::inspector {
namespace {

[[noreturn]] void no_such_place(const std::string& file, const std::string& place) {
    throw InputError(file, place,
                     "there is no such value to change; allowed are those of the settings, of a "
                     "material and of a light, such as /settings/max_depth");
}

/// What is typed, as the value that a file would have.
Json typed(std::string_view text) {
    const auto begin = text.find_first_not_of(' ');
    text = begin == std::string_view::npos ? "" : text.substr(begin);
    text = text.substr(0, text.find_last_not_of(' ') + 1);
    const bool list = text.find(',') != std::string_view::npos && !text.starts_with('[');
    const std::string whole = list ? "[" + std::string(text) + "]" : std::string(text);
    Json value = Json::parse(whole, nullptr, false);
    return value.is_discarded() ? Json(std::string(text)) : value;
}

/// The vector that "/lights/0/position/1" is a part of, as a list of numbers.
Json vector_with(const Scene& scene, const std::string& place, const Json& part) {
    const std::string whole = place.substr(0, place.size() - 2);
    Json list = Json::array();
    for (const char k : {'0', '1', '2'}) {
        const std::string at = whole + "/" + k;
        list.push_back(at == place ? part : Json(number_of(find_entry(scene, at)->second)));
    }
    return list;
}

bool is_part(const std::string& place) {
    const std::size_t n = place.size();
    return n > 2 && place[n - 2] == '/' && place[n - 1] >= '0' && place[n - 1] <= '2';
}

/// The changed scene as a file without its objects, and back.
class Rewriting {
  public:
    Rewriting(const Scene& scene, KnobOwner owner) : scene_(scene), owner_(owner) {
        bare_.name = scene.name;
        bare_.camera = scene.camera;
        put(values_of(scene), bare_);
        if (owner.kind == KnobOwner::Kind::material && bare_.materials[owner.index].in_place) {
            put_into_list(bare_.materials[owner.index]);
        }
        std::erase_if(bare_.materials, [](const Material& m) { return m.in_place; });
    }

    /// Where in the written file the value of this place stands.
    std::string place_in_file(const std::string& place) const {
        return listed_.empty() ? place : listed_ + place.substr(place.rfind('/'));
    }

    Json document(const std::string& file) const {
        return parse_json(write_scene_json(bare_), file);
    }

    /// Throws InputError with the places that the scene's own file has.
    Scene read(const Json& document, const std::string& file, const std::string& place) const {
        JsonReport report;
        report.file = file;
        Scene read = read_scene_json(document, "", report);
        if (report.mistakes.empty()) {
            return read;
        }
        for (Mistake& mistake : report.mistakes) {
            if (!listed_.empty() && mistake.place.starts_with(listed_)) {
                mistake.place.replace(0, listed_.size(), place.substr(0, place.rfind('/')));
            }
        }
        throw InputError(std::move(report.mistakes));
    }

    /// The scene with what belongs to the owner as it was read.
    Scene changed(const Scene& read) const {
        Scene scene = scene_;
        if (owner_.kind == KnobOwner::Kind::light) {
            scene.lights[owner_.index] = read.lights[owner_.index];
        } else if (owner_.kind == KnobOwner::Kind::material) {
            Material& material = scene.materials[owner_.index];
            const std::string name = listed_.empty() ? material.name : listed_name_;
            Material other = *std::ranges::find(read.materials, name, &Material::name);
            other.name = material.name;
            other.in_place = material.in_place;
            material = std::move(other);
        } else {
            scene.settings = read.settings;
            scene.background = read.background;
            scene.ambient = read.ambient;
        }
        return scene;
    }

  private:
    /// A material inside of an object that is not written stands in the list, by a free name.
    void put_into_list(Material& material) {
        const auto is_taken = [&](const Material& m) {
            return !m.in_place && m.name == listed_name_;
        };
        listed_name_ = "material";
        while (std::ranges::any_of(bare_.materials, is_taken)) {
            listed_name_ += "'";
        }
        listed_ = "/materials" + json_pointer_part(listed_name_);
        material.in_place = false;
        material.name = listed_name_;
    }

    const Scene& scene_;
    KnobOwner owner_;
    Scene bare_;
    std::string listed_, listed_name_;
};

}  // namespace

Scene with_value(const Scene& scene, const std::string& file, const std::string& place,
                 std::string_view text) {
    const auto found = find_entry(scene, place);
    if (!found) {
        no_such_place(file, place);
    }
    const auto& [owner, entry] = *found;
    const Rewriting rewriting(scene, owner);
    const std::string at = rewriting.place_in_file(place);
    Json document = rewriting.document(file);
    const Json value = typed(text);
    const bool can_be_none = std::holds_alternative<const std::optional<double>*>(entry.slot);
    if (is_part(at)) {
        document[Json::json_pointer(at.substr(0, at.size() - 2))] =
            vector_with(scene, place, value);
    } else if (can_be_none && value == "none") {
        const Json::json_pointer pointer(at);
        document[pointer.parent_pointer()].erase(pointer.back());
    } else {
        document[Json::json_pointer(at)] = value;
    }
    return rewriting.changed(rewriting.read(document, file, place));
}

}  // namespace raytree::inspector
