#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

/// What of a scene can be changed while its tree is looked at.
namespace raytree::inspector {

/// All that can be changed: what undo goes back to.
struct Values {
    Colour background, ambient;
    Settings settings;
    std::vector<Material> materials;
    std::vector<Light> lights;
};
Values values_of(const Scene& scene);
void put(const Values& values, Scene& scene);
/// Whether surfaces look different in the 3D view.
bool same_coats(const Values& a, const Values& b);

/// What a group of knobs belongs to.
struct KnobOwner {
    enum class Kind { settings, material, light };
    Kind kind = Kind::settings;
    std::size_t index = 0;
    friend bool operator==(const KnobOwner&, const KnobOwner&) = default;
};
/// Settings first, then materials and lights in the scene's order.
std::vector<KnobOwner> owners_of(const Scene& scene);
/// "Scene settings", "Material glass", "Light key".
std::string name_of(const Scene& scene, KnobOwner owner);

/// One value: a number, a colour, or one of several words.
struct Knob {
    enum class Kind { number, whole, colour, choice };

    std::string place;  ///< JSON pointer as in raytree-scene; parts of a vector have their index
    std::string label;
    std::string help;
    Kind kind = Kind::number;
    double least = 0, most = 1;                ///< of its slider; what is typed may lie beyond
    bool logarithmic = false;                  ///< of the slider, which then has 0 at its lower end
    std::vector<std::string_view> words = {};  ///< of a choice
};
/// The ranges of places of lights depend on where they are.
std::vector<Knob> knobs_of(const Scene& scene, KnobOwner owner);

/// As it is typed: "0.5", "0.5, 0.4, 0.3" (one number where the channels are equal), "opaque", and
/// "none" where there is no such limit.
std::string text_of(const Scene& scene, const std::string& place);
/// Where a slider stands for that: the number, a colour's largest channel, a choice's place.
double number_of(const Scene& scene, const Knob& knob);
/// What a slider says: of a colour, all channels in the proportion that they have.
std::string slider_text(const Scene& scene, const Knob& knob, double value);

/// The scene's values `now` with one changed. Throws InputError with the message that a file with
/// that value would get; `file` names the scene in it.
Values with_value(const Scene& scene, const Values& now, const std::string& file,
                  const std::string& place, std::string_view text);

}  // namespace raytree::inspector
