#include "state/knob_entries.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "formats/scene_words.h"
#include "scene/json_pointer.h"
#include "scene/range_check.h"

namespace raytree::inspector {
namespace {

class Entries {
  public:
    Entries(const Scene& scene, KnobOwner owner) : scene_(scene) {
        switch (owner.kind) {
            case KnobOwner::Kind::settings:
                add_settings();
                break;
            case KnobOwner::Kind::material:
                add_material(owner.index);
                break;
            case KnobOwner::Kind::light:
                add_light(owner.index);
                break;
        }
    }
    std::vector<Entry> take() { return std::move(all_); }

  private:
    using Kind = Knob::Kind;

    void number(const std::string& key, const char* label, const char* help, const double& value,
                double least, double most, bool logarithmic = false) {
        all_.push_back(
            {{base_ + key, label, help, Kind::number, least, most, logarithmic, {}}, &value});
    }
    void colour(const std::string& key, const char* label, const char* help, const Colour& value,
                double most = 1) {
        const double there = largest_component(value);
        const double reach = std::max(most, std::ceil(1.5 * there));
        all_.push_back({{base_ + key, label, help, Kind::colour, 0, reach, false, {}}, &value});
    }
    template <class Enumeration> void choice(const std::string& key, const char* label,
                                             const char* help, const Words& words,
                                             Enumeration value) {
        const double most = static_cast<double>(words.size() - 1);
        Entry entry{{base_ + key, label, help, Kind::choice, 0, most, false, words},
                    static_cast<const double*>(nullptr),
                    static_cast<std::size_t>(value)};
        all_.push_back(std::move(entry));
    }
    void attenuation(const Attenuation& f, const char* of) {
        number("/attenuation/0", "a", of, f.a, 0, 4);
        number("/attenuation/1", "b", of, f.b, 0, 2);
        number("/attenuation/2", "c", of, f.c, 0, 1);
    }

    void add_settings() {
        const Settings& s = scene_.settings;
        base_ = "/settings";
        all_.push_back({{base_ + "/max_depth",
                         "depth",
                         "How many levels the tree may have",
                         Kind::whole,
                         1,
                         12,
                         false,
                         {}},
                        &s.max_depth});
        number("/min_weight", "least weight", "Branches of less weight are not sent; 0: none",
               s.min_weight, 1e-6, 1, true);
        all_.push_back({{base_ + "/max_distance",
                         "farthest",
                         "How far a path may go from the eye; none: without end",
                         Kind::number,
                         0,
                         distance_reach(),
                         false,
                         {}},
                        &s.max_distance});
        choice("/shadows", "shadows", "Whether things in between stop light", kShadowModeWords,
               s.shadows);
        choice("/specular_model", "highlights", "How highlights are computed", kSpecularModelWords,
               s.specular_model);
        choice("/total_internal_reflection", "total refl.",
               "Whether kt is added to kr where nothing is refracted", kTotalReflectionWords,
               s.total_internal_reflection);
        attenuation(s.attenuation, "f = min(1, 1/(a + b t + c t²)) of reflected, refracted rays");
        base_.clear();
        colour("/background", "background", "What a ray that meets nothing sees",
               scene_.background);
        colour("/ambient", "ambient", "Light that is everywhere", scene_.ambient);
    }

    void add_material(std::size_t index) {
        const Material& m = scene_.materials[index];
        base_ = place_of_material(index);
        colour("/color", "colour", "The surface's own colour", m.color);
        colour("/ka", "ka", "Share of the ambient light", m.ka);
        colour("/kd", "kd", "Share of each light, diffuse", m.kd);
        colour("/ks", "ks", "Share of each light, in the highlight", m.ks);
        colour("/specular_color", "its colour", "Of the highlight", m.specular_color);
        number("/shininess", "exponent", "Of the highlight: large is small and sharp", m.shininess,
               1, 1024, true);
        colour("/kr", "kr", "Share of the reflected ray", m.kr);
        colour("/kt", "kt", "Share of the refracted ray", m.kt);
        number("/ior", "ior", "Refractive index η", m.ior, 1, std::max(2.5, 1.2 * m.ior));
    }

    std::string place_of_material(std::size_t index) const {
        const Material& m = scene_.materials[index];
        if (!m.in_place) {
            return "/materials" + json_pointer_part(m.name);
        }
        const auto user = std::ranges::find(scene_.objects, index, &Object::material);
        return "/objects/" + std::to_string(user - scene_.objects.begin()) + "/material";
    }

    void add_light(std::size_t index) {
        const Light& light = scene_.lights[index];
        base_ = "/lights/" + std::to_string(index);
        colour("/intensity", "intensity", "How bright it is", light.intensity, 2);
        if (const auto* const point = std::get_if<PointLight>(&light.kind)) {
            vector("/position", point->position, distance_reach());
            attenuation(point->attenuation, "f = min(1, 1/(a + b t + c t²)) of its light");
        } else {
            const auto& directional = std::get<DirectionalLight>(light.kind);
            vector("/direction", directional.direction,
                   std::max(1.0, largest_component(directional.direction)));
        }
    }

    void vector(const std::string& key, const Point& at, double reach) {
        number(key + "/0", "x", "", at.x, at.x - reach, at.x + reach);
        number(key + "/1", "y", "", at.y, at.y - reach, at.y + reach);
        number(key + "/2", "z", "", at.z, at.z - reach, at.z + reach);
    }

    /// How far things are from each other.
    double distance_reach() const {
        const Camera& camera = scene_.camera;
        const double reach = 1.5 * length(camera.look_at - camera.eye);
        const double unit = std::pow(10.0, std::floor(std::log10(reach)));
        return std::isfinite(unit) && unit > 0 ? std::ceil(reach / unit) * unit : 10;
    }

    const Scene& scene_;
    std::string base_;
    std::vector<Entry> all_;
};

/// A list's element: the 3 of "/lights/3/position".
std::optional<std::size_t> index_in(std::string_view place, std::string_view list) {
    std::size_t index = 0;
    if (!place.starts_with(list)) {
        return std::nullopt;
    }
    place.remove_prefix(list.size());
    const auto read = std::from_chars(place.data(), place.data() + place.size(), index);
    return read.ec == std::errc() ? std::optional(index) : std::nullopt;
}

std::optional<KnobOwner> owner_of(const Scene& scene, const std::string& place) {
    using Kind = KnobOwner::Kind;
    if (const auto light = index_in(place, "/lights/")) {
        return *light < scene.lights.size() ? std::optional(KnobOwner{Kind::light, *light})
                                            : std::nullopt;
    }
    if (const auto object = index_in(place, "/objects/")) {
        return *object < scene.objects.size()
                   ? std::optional(KnobOwner{Kind::material, scene.objects[*object].material})
                   : std::nullopt;
    }
    if (place.starts_with("/materials/")) {
        const std::string name = place.substr(10, place.rfind('/') - 10);
        const auto found = std::ranges::find_if(scene.materials, [&](const Material& m) {
            return !m.in_place && json_pointer_part(m.name) == name;
        });
        return found == scene.materials.end()
                   ? std::nullopt
                   : std::optional(KnobOwner{Kind::material, static_cast<std::size_t>(
                                                                 found - scene.materials.begin())});
    }
    return KnobOwner{};
}

}  // namespace

std::vector<Entry> entries_of(const Scene& scene, KnobOwner owner) {
    return Entries(scene, owner).take();
}

std::optional<std::pair<KnobOwner, Entry>> find_entry(const Scene& scene,
                                                      const std::string& place) {
    const auto owner = owner_of(scene, place);
    if (!owner) {
        return std::nullopt;
    }
    for (Entry& entry : entries_of(scene, *owner)) {
        if (entry.knob.place == place) {
            return std::pair(*owner, std::move(entry));
        }
    }
    return std::nullopt;
}

std::string text_of(const Entry& entry) {
    if (entry.knob.kind == Knob::Kind::choice) {
        return std::string(entry.knob.words[entry.chosen]);
    }
    if (const auto* const colour = std::get_if<const Colour*>(&entry.slot)) {
        const Colour& c = **colour;
        const bool grey = c.r == c.g && c.g == c.b;
        return grey ? shown_number(c.r)
                    : shown_number(c.r) + ", " + shown_number(c.g) + ", " + shown_number(c.b);
    }
    if (const auto* const limit = std::get_if<const std::optional<double>*>(&entry.slot)) {
        return **limit ? shown_number(***limit) : "none";
    }
    if (const auto* const whole = std::get_if<const int*>(&entry.slot)) {
        return std::to_string(**whole);
    }
    return shown_number(*std::get<const double*>(entry.slot));
}

double number_of(const Entry& entry) {
    if (entry.knob.kind == Knob::Kind::choice) {
        return static_cast<double>(entry.chosen);
    }
    if (const auto* const colour = std::get_if<const Colour*>(&entry.slot)) {
        return largest_component(**colour);
    }
    if (const auto* const limit = std::get_if<const std::optional<double>*>(&entry.slot)) {
        return (*limit)->value_or(entry.knob.most);
    }
    if (const auto* const whole = std::get_if<const int*>(&entry.slot)) {
        return **whole;
    }
    return *std::get<const double*>(entry.slot);
}

}  // namespace raytree::inspector
