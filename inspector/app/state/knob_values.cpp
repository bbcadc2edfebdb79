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

/// The changed values as a file without objects and without other materials, and back.
class Rewriting {
  public:
    Rewriting(const Scene& scene, const Values& now, KnobOwner owner) : now_(now), owner_(owner) {
        bare_.name = scene.name;
        bare_.camera = scene.camera;
        bare_.background = now.background;
        bare_.ambient = now.ambient;
        bare_.settings = now.settings;
        bare_.lights = now.lights;
        if (owner.kind == KnobOwner::Kind::material) {
            bare_.materials = {now.materials[owner.index]};
            if (bare_.materials.front().in_place) {
                put_into_list(bare_.materials.front());
            }
        }
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

    /// The values with what belongs to the owner as it was read.
    Values changed(const Scene& read) const {
        Values values = now_;
        if (owner_.kind == KnobOwner::Kind::light) {
            values.lights[owner_.index] = read.lights[owner_.index];
        } else if (owner_.kind == KnobOwner::Kind::material) {
            Material& material = values.materials[owner_.index];
            Material other = read.materials.front();
            other.name = material.name;
            other.in_place = material.in_place;
            material = std::move(other);
        } else {
            values.settings = read.settings;
            values.background = read.background;
            values.ambient = read.ambient;
        }
        return values;
    }

  private:
    /// A material inside of an object that is not written stands in the list.
    void put_into_list(Material& material) {
        const std::string name = "material";
        listed_ = "/materials" + json_pointer_part(name);
        material.in_place = false;
        material.name = name;
    }

    const Values& now_;
    KnobOwner owner_;
    Scene bare_;
    std::string listed_;
};

}  // namespace

Values with_value(const Scene& scene, const Values& now, const std::string& file,
                  const std::string& place, std::string_view text) {
    const auto found = find_entry(scene, place);
    if (!found) {
        no_such_place(file, place);
    }
    const auto& [owner, entry] = *found;
    const Rewriting rewriting(scene, now, owner);
    const std::string at = rewriting.place_in_file(place);
    Json document = rewriting.document(file);
    const Json value = typed(text);
    const bool can_be_none = std::holds_alternative<const std::optional<double>*>(entry.slot);
    if (can_be_none && value == "none") {
        const Json::json_pointer pointer(at);
        document[pointer.parent_pointer()].erase(pointer.back());
    } else {
        const Json::json_pointer pointer(at), list = pointer.parent_pointer();
        if (!list.empty() && list.back() == "attenuation" && !document.contains(list)) {
            const Attenuation usual;  // which is not written
            document[list] = {usual.a, usual.b, usual.c};
        }
        document[pointer] = value;
    }
    return rewriting.changed(rewriting.read(document, file, place));
}

}  // namespace raytree::inspector
