#include "check/rulebook.h"

#include "formats/scene_json.h"

namespace raytree::check {
namespace {

Scene scene_by(const Scene& scene, const Choices& choices) {
    Scene changed = scene;
    for (const Convention* choice : choices) {
        if (choice->on_scene) {
            choice->on_scene(changed);
        }
    }
    return changed;
}

Laws laws_by(const Choices& choices) {
    Laws laws = model_laws();
    for (const Convention* choice : choices) {
        if (choice->on_laws) {
            choice->on_laws(laws);
        }
    }
    return laws;
}

/// Camera and settings, and what of the lights a convention may change.
std::string settings_text(const Scene& scene) {
    Scene bare;
    bare.camera = scene.camera;
    bare.settings = scene.settings;
    if (!bare.settings.secondary_background) {
        bare.settings.secondary_background = scene.background;
    }
    bare.background = scene.background;
    bare.ambient = scene.ambient;
    bare.lights = scene.lights;
    return write_scene_json(bare);
}

}  // namespace

Rulebook::Rulebook(const Scene& base, Choices by)
    : choices(std::move(by)),
      scene(scene_by(base, choices)),
      place(scene),
      names(place),
      laws(laws_by(choices)) {}

Rulebooks::Rulebooks(const Scene& scene, bool course_text)
    : scene_(scene), course_text_(course_text) {}

Choices Rulebooks::choices_of(const Profile& profile) const {
    Choices choices = default_choices();
    if (course_text_) {
        for (const std::string_view choice : lecture_for_course_text) {
            choices = with_choice(std::move(choices), choice);
        }
    }
    for (const std::string_view choice : profile.named) {
        choices = with_choice(std::move(choices), choice);
    }
    return choices;
}

const Rulebook& Rulebooks::of(const Choices& choices) const {
    const std::string key = text_of(choices);
    const std::lock_guard lock(mutex_);
    std::unique_ptr<const Rulebook>& made = made_[key];
    if (!made) {
        made = std::make_unique<const Rulebook>(scene_, choices);
    }
    return *made;
}

std::vector<Choices> Rulebooks::alternatives(const Choices& base) const {
    std::vector<Choices> all;
    for (const bool as_the_scene_says : {false, true}) {
        for (const Convention& convention : conventions()) {
            if ((convention.value == "scene") == as_the_scene_says) {
                all.push_back(with_choice(
                    base, std::string(convention.axis) + '=' + std::string(convention.value)));
            }
        }
    }
    for (const Profile& profile : profiles()) {
        all.push_back(choices_of(profile));
    }
    std::erase(all, base);
    return all;
}

Choices Rulebooks::differences(const Choices& choices, const Choices& base) const {
    Choices differing;
    for (std::size_t k = 0; k < choices.size(); ++k) {
        const bool no_near = choices[k]->axis == "near" && !(scene_.camera.near > 0);
        if (choices[k] == base[k] || no_near) {
            continue;
        }
        Choices one = base;
        one[k] = choices[k];
        const bool other_laws = choices[k]->on_laws != base[k]->on_laws;
        if (other_laws || choices[k]->axis == "gamma" ||
            settings_text(scene_by(scene_, one)) != settings_text(scene_by(scene_, base))) {
            differing.push_back(choices[k]);
        }
    }
    return differing;
}

}  // namespace raytree::check
