#include "formats/scene_json.h"

#include "folders.h"
#include "formats/scene_file.h"
#include "formats/support.h"

namespace raytree {
namespace {

Scene read(const std::string& text) {
    std::vector<std::string> warnings;
    return read_scene_json(text, "folder/scene.json", warnings);
}

constexpr const char* kSmallest = R"({"format": "raytree-scene/1.0", "camera": {"eye": [0, 0, 5],
    "look_at": [0, 0, 0], "horizontal_fov_degrees": 50, "width": 4, "height": 3}, "objects": []})";

TEST_CASE("the smallest scene has the defaults of the format") {
    const Scene scene = read(kSmallest);
    CHECK(scene.name == "scene");
    CHECK(scene.background == Colour(0.0));
    CHECK(scene.ambient == Colour(1.0));
    CHECK(scene.camera.up == Point(0, 1, 0));
    CHECK(scene.camera.near == 0);
    CHECK(scene.settings.max_depth == 6);
    CHECK(scene.settings.min_weight == 0.001);
    CHECK(!scene.settings.max_distance);
    CHECK(scene.settings.attenuation == Attenuation{1, 0, 0});
    CHECK(scene.settings.specular_model == SpecularModel::phong);
    CHECK(scene.settings.shadows == ShadowMode::opaque);
    CHECK(scene.settings.total_internal_reflection == TotalReflection::drop);
    CHECK(scene.settings.pixel_sample == PixelSample::center);
    CHECK(!scene.settings.secondary_background);
    CHECK(scene.settings.quantize == Quantize::round);
    CHECK(scene.settings.ray_budget == 1'000'000);
    CHECK(scene.lights.empty());
}

constexpr const char* kEverything = R"({
  "format": "raytree-scene/1.0", "name": "all of it",
  "camera": {"eye": [0, 0.1, 5], "look_at": [0, 0, 0], "up": [0, 0.5, 0.5],
             "image_plane": [-1, 1.5, -0.5, 0.75], "near": 0.25, "width": 65535, "height": 1},
  "background": 0.5, "ambient": [0.1, 0.2, 0.3],
  "settings": {"max_depth": 64, "min_weight": 0, "max_distance": 12.5, "attenuation": [0, 0.5, 0],
    "specular_model": "blinn", "shadows": "transmissive", "total_internal_reflection": "reflect",
    "pixel_sample": "corner", "secondary_background": [0, 1, 0], "quantize": "floor",
    "ray_budget": 12},
  "materials": {"z glass": {"color": 0.25, "specular_color": [1, 0.5, 0], "ka": 0, "kd": [0.1, 0.2, 0.3],
     "ks": 1, "kr": 0.5, "kt": 0.75, "shininess": 0, "ior": 1.33}, "a": {}},
  "lights": [{"type": "point", "position": [1, 2, 3], "attenuation": [0.5, 0, 0.25]},
             {"name": "sun", "type": "directional", "direction": [0, -2, 0], "intensity": 0.4}],
  "objects": [
    {"type": "sphere", "center": [1, 2, 3], "radius": 0.5, "material": "z glass"},
    {"type": "polygon", "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]],
     "normals": [[0, 0, 1], [0, 1, 1], [1, 0, 1]], "material": "a"},
    {"name": "rod", "type": "cone", "base": [0, 0, 0], "base_radius": 0.5, "apex": [0, 2, 0],
     "apex_radius": 0.25, "material": {"kd": 1},
     "transform": [[2, 0, 0, 5], [0, 1, 0, 6], [0, 0, 1, 7], [0, 0, 0, 1]]},
    {"type": "sphere", "center": [0, 0, 0], "radius": 1, "material": {}, "transform": null}]
})";

TEST_CASE("every key of the format is read") {
    const Scene scene = read(kEverything);
    CHECK(scene.name == "all of it");
    CHECK(scene.camera.eye == Point(0, 0.1, 5));
    CHECK(scene.camera.up == Point(0, 0.5, 0.5));
    CHECK(std::get<ImagePlane>(scene.camera.window).right == 1.5);
    CHECK(std::get<ImagePlane>(scene.camera.window).top == 0.75);
    CHECK(scene.camera.near == 0.25);
    CHECK(scene.camera.width == 65535);
    CHECK(scene.background == Colour(0.5));
    CHECK(scene.ambient == Colour(0.1, 0.2, 0.3));
    CHECK(scene.settings.max_depth == 64);
    CHECK(scene.settings.max_distance == 12.5);
    CHECK(scene.settings.attenuation == Attenuation{0, 0.5, 0});
    CHECK(scene.settings.specular_model == SpecularModel::blinn);
    CHECK(scene.settings.shadows == ShadowMode::transmissive);
    CHECK(scene.settings.total_internal_reflection == TotalReflection::reflect);
    CHECK(scene.settings.pixel_sample == PixelSample::corner);
    CHECK(scene.settings.secondary_background == Colour(0, 1, 0));
    CHECK(scene.settings.quantize == Quantize::floor);
    CHECK(scene.settings.ray_budget == 12);
}

TEST_CASE("materials are those named, with the table's defaults, and those in place") {
    const Scene scene = read(kEverything);
    REQUIRE(scene.materials.size() == 4);
    CHECK(scene.materials[0].name == "z glass");
    CHECK(scene.materials[0].color == Colour(0.25));
    CHECK(scene.materials[0].kd == Colour(0.1, 0.2, 0.3));
    CHECK(scene.materials[0].ior == 1.33);
    CHECK(scene.materials[1].color == Colour(0.8));
    CHECK(scene.materials[1].specular_color == Colour(1.0));
    CHECK(scene.materials[1].ka == Colour(0.1));
    CHECK(scene.materials[1].kd == Colour(0.7));
    CHECK(scene.materials[1].ks == Colour(0.0));
    CHECK(scene.materials[1].kr == Colour(0.0));
    CHECK(scene.materials[1].kt == Colour(0.0));
    CHECK(scene.materials[1].shininess == 32);
    CHECK(scene.materials[1].ior == 1.5);
    const Material& in_place = scene.materials[scene.objects[2].material];
    CHECK(in_place.name == "rod");
    CHECK(in_place.in_place);
    CHECK(in_place.kd == Colour(1.0));
    CHECK(scene.materials[scene.objects[3].material].name == "sphere3");
}

TEST_CASE("lights and objects have names by their place") {
    const Scene scene = read(kEverything);
    CHECK(scene.lights[0].name == "light0");
    CHECK(scene.lights[1].name == "sun");
    CHECK(scene.lights[0].intensity == Colour(1.0));
    CHECK(std::get<PointLight>(scene.lights[0].kind).attenuation == Attenuation{0.5, 0, 0.25});
    CHECK(std::get<DirectionalLight>(scene.lights[1].kind).direction == Point(0, -2, 0));
    CHECK(scene.objects[0].name == "sphere0");
    CHECK(scene.objects[1].name == "polygon1");
    CHECK(scene.objects[2].name == "rod");
    CHECK(scene.objects[3].name == "sphere3");
    CHECK(std::get<Polygon>(scene.objects[1].shape).normals[2] == Point(1, 0, 1));
    CHECK(std::get<Cone>(scene.objects[2].shape).apex_radius == 0.25);
    CHECK((*scene.objects[2].transform)[1][3] == 6);
    CHECK(!scene.objects[3].transform);
}

TEST_CASE("a whole number may be written with a point") {
    std::string text = kSmallest;
    text.replace(text.find("\"width\": 4"), 10, "\"width\": 4.0");
    CHECK(read(text).camera.width == 4);
}

TEST_CASE("a newer minor version is read with a warning, what is new in it left out") {
    std::string text = kSmallest;
    text.replace(text.find("/1.0"), 4, "/1.7");
    text.replace(text.find("\"objects\""), 0, "\"fog\": 1, ");
    std::vector<std::string> warnings;
    read_scene_json(text, "s.json", warnings);
    REQUIRE(warnings.size() == 2);
    CHECK_CONTAINS(warnings[0], "s.json: /format: is \"raytree-scene/1.7\", newer than");
    CHECK_CONTAINS(warnings[1], "s.json: /fog: is an unknown key");
}

TEST_CASE("a scene with every key survives being written and read") {
    const Scene scene = read(kEverything);
    const std::string text = write_scene_json(scene);
    std::string why;
    CHECK_MESSAGE(test::same_scene(scene, read(text), why), why);
    CHECK(write_scene_json(read(text)) == text);
}

TEST_CASE("what is written keeps to 100 columns and says materials in place") {
    const std::string text = write_scene_json(read(kEverything));
    CHECK_CONTAINS(text,
                   R"({"name": "rod", "type": "cone", "base": [0, 0, 0], "base_radius": 0.5,)");
    CHECK_CONTAINS(text, R"("kd": 1})");
    std::size_t start = 0;
    while (start < text.size()) {
        const std::size_t end = text.find('\n', start);
        CHECK(end - start <= 100);
        start = end + 1;
    }
}

void check_round_trip(const std::filesystem::path& file) {
    CAPTURE(file);
    std::vector<std::string> warnings;
    const Scene scene = read_scene_json(test::text_of(file), file, warnings);
    const Scene again = read_scene_json(write_scene_json(scene), file, warnings);
    std::string why;
    CHECK_MESSAGE(test::same_scene(scene, again, why), why);
}

TEST_CASE("every scene of the project survives being written and read") {
    const auto files = test::files_in(RAYTREE_DATA_DIR "/scenes", ".json");
    CHECK(!files.empty());
    for (const auto& file : files) {
        check_round_trip(file);
    }
}

TEST_CASE("scenes by others survive being written and read") {
    for (const auto& file : test::files_in(RAYTREE_SHARED_DATA_DIR "/trees", ".scene.json")) {
        check_round_trip(file);
    }
}

}  // namespace
}  // namespace raytree
