#include <array>
#include <cstdint>

#include "formats/scene_json.h"
#include "formats/scene_words.h"
#include "scene/range_check.h"

namespace raytree {
namespace {

constexpr std::int64_t kMostRays = std::int64_t{1} << 53;  // what a JSON number surely holds

template <class Enumeration> void choice(const ObjectReader& reader, std::string_view key,
                                         const Words& words, Enumeration& out) {
    std::size_t place = 0;
    if (reader.choice(key, words, place, Need::optional)) {
        out = static_cast<Enumeration>(place);
    }
}

/// A whole number that fits into `Integer`.
template <class Integer> void whole_number(const ObjectReader& reader, std::string_view key,
                                           Integer& out, Need need, std::int64_t most) {
    std::int64_t number = 0;
    if (reader.whole_number(key, number, need, 1, most)) {
        out = static_cast<Integer>(number);
    }
}

}  // namespace

void read_attenuation_json(const ObjectReader& reader, Attenuation& out) {
    std::array<double, 3> abc;
    if (reader.numbers("attenuation", abc.size(), abc.data(), Need::optional)) {
        out = {abc[0], abc[1], abc[2]};
    }
}

Camera read_camera_json(const Json& value, const JsonPlace& place, JsonReport& report) {
    Camera camera;
    if (!ObjectReader::is_object(value, place, report)) {
        return camera;
    }
    const ObjectReader reader(value, place, report);
    reader.point("eye", camera.eye, Need::required);
    reader.point("look_at", camera.look_at, Need::required);
    reader.point("up", camera.up, Need::optional);
    reader.number("near", camera.near, Need::optional);
    whole_number(reader, "width", camera.width, Need::required, kLargestSide);
    whole_number(reader, "height", camera.height, Need::required, kLargestSide);
    const bool has_fov = reader.has("horizontal_fov_degrees");
    const bool has_plane = reader.has("image_plane");
    HorizontalFov fov;
    std::array<double, 4> plane;
    if (has_fov && has_plane) {
        report.add(place.member("image_plane"),
                   "is there beside horizontal_fov_degrees; exactly one of the two is allowed");
    } else if (has_plane && reader.numbers("image_plane", 4, plane.data(), Need::required)) {
        camera.window = ImagePlane{plane[0], plane[1], plane[2], plane[3]};
    } else if (!has_plane && reader.number("horizontal_fov_degrees", fov.degrees, Need::optional)) {
        camera.window = fov;
    } else if (!has_plane && !has_fov) {
        report.add(place.member("horizontal_fov_degrees"),
                   "is missing, and so is image_plane; exactly one of the two is needed");
    }
    reader.nothing_but({"eye", "look_at", "up", "horizontal_fov_degrees", "image_plane", "near",
                        "width", "height"});
    return camera;
}

Settings read_settings_json(const Json& value, const JsonPlace& place, JsonReport& report) {
    Settings settings;
    if (!ObjectReader::is_object(value, place, report)) {
        return settings;
    }
    const ObjectReader reader(value, place, report);
    whole_number(reader, "max_depth", settings.max_depth, Need::optional, kDeepest);
    whole_number(reader, "ray_budget", settings.ray_budget, Need::optional, kMostRays);
    reader.number("min_weight", settings.min_weight, Need::optional);
    if (reader.has("max_distance")) {
        reader.number("max_distance", settings.max_distance.emplace(), Need::optional);
    }
    read_attenuation_json(reader, settings.attenuation);
    choice(reader, "specular_model", kSpecularModelWords, settings.specular_model);
    choice(reader, "shadows", kShadowModeWords, settings.shadows);
    choice(reader, "total_internal_reflection", kTotalReflectionWords,
           settings.total_internal_reflection);
    choice(reader, "pixel_sample", kPixelSampleWords, settings.pixel_sample);
    choice(reader, "quantize", kQuantizeWords, settings.quantize);
    if (reader.has("secondary_background")) {
        reader.colour("secondary_background", settings.secondary_background.emplace(),
                      Need::optional);
    }
    reader.nothing_but({"max_depth", "min_weight", "max_distance", "attenuation", "specular_model",
                        "shadows", "total_internal_reflection", "pixel_sample",
                        "secondary_background", "quantize", "ray_budget"});
    return settings;
}

}  // namespace raytree
