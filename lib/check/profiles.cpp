#include "check/conventions.h"
#include "formats/did_you_mean.h"
#include "scene/input_error.h"

namespace raytree::check {

const std::vector<Profile>& profiles() {
    static const std::vector<Profile> table = {
        {"lecture", "the model as it is, with the scene's settings", {}},
        {"42", "the angle of view is the horizontal one, which is the lecture's too", {}},
        {"corner", "the lecture with rays through pixel corners", {"sample=corner"}},
        {"rpi", "a gamma curve of 2.2 is applied to finished pictures", {"gamma=2.2"}},
        {"ucla",
         "rays through the upper left corners of pixels; secondary rays that miss are black",
         {"sample=corner", "near=primary", "miss=black", "quantise=floor"}},
        {"ucla-2015",
         "as ucla, and the near plane cuts reflections too",
         {"sample=corner", "near=all", "miss=black", "quantise=floor"}},
        {"ucla-bl",
         "as ucla, with the lower left corner",
         {"sample=corner-bl", "near=primary", "miss=black", "quantise=floor"}},
        {"ucla-js",
         "one ratio of indices on entering and leaving; local light is clamped; secondary rays "
         "that miss are black",
         {"near=none", "clamp=surface", "eta-exit=same", "miss=black", "quantise=floor"}},
        {"ucr",
         "half vectors; reflection takes its share from the local light",
         {"specular=blinn", "combine=lerp"}},
        {"uvic",
         "rays through pixel corners; normals stay outward inside; secondary rays that miss are "
         "black",
         {"sample=corner", "near=primary", "inside-normal=outward", "miss=black",
          "quantise=floor"}},
        {"umbc",
         "each of m lights has 1 / sqrt(m) of its intensity; highlights have the surface's colour",
         {"highlight-colour=surface", "lights=root"}},
        {"weekend",
         "a vertical angle of view; the first and the last pixel lie on the window's edges",
         {"sample=edges", "fov=vertical", "quantise=floor-255.999"}},
        {"weekend-gamma",
         "as weekend, and the square root of each colour is taken for the finished picture",
         {"sample=edges", "fov=vertical", "quantise=floor-255.999", "gamma=2"}},
    };
    return table;
}

const Profile& profile_named(std::string_view name) {
    std::vector<std::string_view> names;
    for (const Profile& profile : profiles()) {
        if (profile.name == name) {
            return profile;
        }
        names.push_back(profile.name);
    }
    std::string all;
    for (const std::string_view each : names) {
        all += (all.empty() ? "" : ", ") + std::string(each);
    }
    throw InputError("", "",
                     "there is no profile \"" + std::string(name) + '"' +
                         did_you_mean(name, names) + "; there are " + all);
}

}  // namespace raytree::check
