#include "state/knobs.h"

#include <algorithm>
#include <cmath>

#include "scene/range_check.h"
#include "state/knob_entries.h"

namespace raytree::inspector {

Values values_of(const Scene& scene) {
    return {scene.background, scene.ambient, scene.settings, scene.materials, scene.lights};
}

void put(const Values& values, Scene& scene) {
    scene.background = values.background;
    scene.ambient = values.ambient;
    scene.settings = values.settings;
    scene.materials = values.materials;
    scene.lights = values.lights;
}

bool same_coats(const Values& a, const Values& b) {
    return std::ranges::equal(a.materials, b.materials, [](const Material& x, const Material& y) {
        return x.color == y.color && x.kd == y.kd && x.kr == y.kr && x.kt == y.kt;
    });
}

std::vector<KnobOwner> owners_of(const Scene& scene) {
    std::vector<KnobOwner> owners = {{KnobOwner::Kind::settings, 0}};
    for (std::size_t k = 0; k < scene.materials.size(); ++k) {
        owners.push_back({KnobOwner::Kind::material, k});
    }
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        owners.push_back({KnobOwner::Kind::light, k});
    }
    return owners;
}

std::string name_of(const Scene& scene, KnobOwner owner) {
    switch (owner.kind) {
        case KnobOwner::Kind::settings:
            return "Scene settings";
        case KnobOwner::Kind::material:
            return "Material " + scene.materials[owner.index].name;
        default:
            return "Light " + scene.lights[owner.index].name;
    }
}

std::vector<Knob> knobs_of(const Scene& scene, KnobOwner owner) {
    std::vector<Knob> knobs;
    for (Entry& entry : entries_of(scene, owner)) {
        knobs.push_back(std::move(entry.knob));
    }
    return knobs;
}

std::string text_of(const Scene& scene, const std::string& place) {
    const auto found = find_entry(scene, place);
    return found ? text_of(found->second) : "";
}

double number_of(const Scene& scene, const Knob& knob) {
    return number_of(find_entry(scene, knob.place)->second);
}

std::string slider_text(const Scene& scene, const Knob& knob, double value) {
    const Entry entry = find_entry(scene, knob.place)->second;
    const auto rounded = [&](double x) {  // a slider is no finer than a hand
        const double range = knob.logarithmic ? x : knob.most - knob.least;
        const double per_unit = std::pow(10.0, 3 - std::floor(std::log10(range)));
        const double whole = std::round(x * per_unit) / per_unit;
        return std::isfinite(whole) ? whole : x;
    };
    if (knob.kind == Knob::Kind::choice) {
        return std::string(knob.words[static_cast<std::size_t>(value)]);
    }
    if (knob.kind == Knob::Kind::whole) {
        return shown_number(std::round(value));
    }
    if (const auto* const colour = std::get_if<const Colour*>(&entry.slot)) {
        const double most = largest_component(**colour);
        const Colour shares = most > 0 ? (1 / most) * **colour : Colour(1.0);
        const Colour c = value * shares;
        const std::string r = shown_number(rounded(c.r)), g = shown_number(rounded(c.g)),
                          b = shown_number(rounded(c.b));
        return r == g && g == b ? r : r + ", " + g + ", " + b;
    }
    return shown_number(rounded(value));
}

}  // namespace raytree::inspector
