#include "formats/scene_file.h"

#include <limits>

#include "formats/support.h"

namespace raytree {
namespace {

using test::refusal_of;
using test::ScratchFolder;

constexpr const char* kJson = R"({"format": "raytree-scene/1.0", "camera": {"eye": [0, 0, 5],
    "look_at": [0, 0, 0], "horizontal_fov_degrees": 50, "width": 4, "height": 3}, "objects": []})";
constexpr const char* kNff =
    "v from 0 0 1 at 0 0 0 up 0 1 0 angle 90 hither 0 resolution 8 8 f 1 1 1 1 0 1 0 1 s 0 0 0 1";
constexpr const char* kCourse = "RES 4 3\nOUTPUT picture.ppm\n";
constexpr const char* kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST_CASE("the name's extension says the format, in any case") {
    const ScratchFolder folder;
    CHECK(load_scene(folder.write("a.JSON", kJson)).format == SceneFormat::json);
    CHECK(load_scene(folder.write("a.nff", kNff)).format == SceneFormat::nff);
    CHECK(load_scene(folder.write("a.txt", kCourse)).output == "picture.ppm");
    const LoadedScene mesh = load_scene(folder.write("a.obj", kObj));
    CHECK(mesh.format == SceneFormat::obj);
    CHECK(mesh.scene.name == "a");
    CHECK(mesh.scene.camera.width == 640);
    CHECK_CONTAINS(refusal_of([&] { load_scene(folder.write("a.xml", "")); }),
                   "must end in .json, .nff, .txt or .obj");
}

TEST_CASE("a format that is given goes before the name") {
    const ScratchFolder folder;
    SceneOptions options;
    options.format = SceneFormat::json;
    CHECK(load_scene(folder.write("a.nff", kJson), options).scene.camera.width == 4);
}

TEST_CASE("the file's SHA-256 is that of its bytes") {
    const ScratchFolder folder;
    SceneOptions options;
    options.format = SceneFormat::course_text;
    // printf 'RES 4 3\n' | sha256sum
    CHECK(load_scene(folder.write("a", "RES 4 3\n"), options).sha256 ==
          "b7ae42113d0fa4ff28b6ccd3647de2ed2fdd9baef716a18ea1f1732bd6201d78");
}

TEST_CASE("options override the scene") {
    const ScratchFolder folder;
    SceneOptions options;
    options.size = {20, 10};
    options.max_depth = 9;
    options.min_weight = 0.5;
    options.max_distance = 7.5;
    for (const auto& [name, text] : {std::pair("a.json", kJson), std::pair("a.nff", kNff),
                                     std::pair("a.txt", kCourse), std::pair("a.obj", kObj)}) {
        CAPTURE(name);
        const Scene scene = load_scene(folder.write(name, text), options).scene;
        CHECK(scene.camera.width == 20);
        CHECK(scene.camera.height == 10);
        CHECK(scene.settings.max_depth == 9);
        CHECK(scene.settings.min_weight == 0.5);
        CHECK(scene.settings.max_distance == 7.5);
    }
    const Scene scene = load_scene(folder.path("a.nff"), options).scene;
    CHECK(std::get<ImagePlane>(scene.camera.window).top == doctest::Approx(10.0 / 9));
}

TEST_CASE("options out of range are refused under their own names, together") {
    SceneOptions options;
    options.size = {40000, 25000};
    options.max_depth = 1000000000;
    options.min_weight = std::numeric_limits<double>::quiet_NaN();
    options.max_distance = 0;
    const auto mistakes = test::mistakes_of([&] { load_scene("none.json", options); });
    REQUIRE(mistakes.size() == 4);
    CHECK(mistakes[0].place == "--size");
    CHECK_CONTAINS(mistakes[0].text, "found 40000x25000");
    CHECK_CONTAINS(mistakes[0].text, "2^28");
    CHECK(mistakes[1].place == "--max-depth");
    CHECK_CONTAINS(mistakes[1].text, "found 1000000000, must be a whole number from 1 to 64");
    CHECK(mistakes[2].place == "--min-weight");
    CHECK_CONTAINS(mistakes[2].text, "found nan");
    CHECK(mistakes[3].place == "--max-distance");
    CHECK_CONTAINS(mistakes[3].text, "found 0, must be a finite number over 0");
}

TEST_CASE("a scene by others is validated with its file's name") {
    const ScratchFolder folder;
    const std::string text = "v from 0 0 1 at 0 0 0 up 0 0 1 angle 90 hither 0 resolution 8 8";
    const auto file = folder.write("a.nff", text);
    CHECK_CONTAINS(refusal_of([&] { load_scene(file); }), file.string() + ": /camera: up is paral");
    CHECK_CONTAINS(refusal_of([&] { load_scene(folder.path("none.nff")); }), "no such file");
}

TEST_CASE("scenes are written in the format of their name") {
    const ScratchFolder folder;
    const Scene scene = load_scene(folder.write("a.nff", kNff)).scene;
    CHECK(save_scene(scene, folder.path("b.json")).empty());
    CHECK(load_scene(folder.path("b.json")).scene.objects.size() == 1);
    CHECK(save_scene(scene, folder.path("b.nff")).empty());
    CHECK(load_scene(folder.path("b.nff")).scene.objects.size() == 1);
    CHECK(!save_scene(scene, folder.path("b.txt")).empty());
    CHECK(load_scene(folder.path("b.txt")).output == "b.ppm");
    CHECK_CONTAINS(refusal_of([&] { save_scene(scene, folder.path("b.obj")); }),
                   "scenes are not written as .obj");
    CHECK(folder.files() == std::vector<std::string>{"a.nff", "b.json", "b.nff", "b.txt"});
}

TEST_CASE("a mesh keeps its file when the scene goes elsewhere") {
    const ScratchFolder folder;
    std::filesystem::create_directory(folder.path("sub"));
    Scene scene = load_scene(folder.write("a.obj", kObj)).scene;
    const auto lost = save_scene(scene, folder.path("sub/b.json"));
    REQUIRE(lost.size() == 1);
    CHECK_CONTAINS(lost[0], "there is no a.obj");
    relocate_meshes(scene, folder.path(""), folder.path("sub"));
    CHECK(std::get<Mesh>(scene.objects[0].shape).file == "../a.obj");
    Scene here = scene;
    relocate_meshes(here, "", ".");
    CHECK(std::get<Mesh>(here.objects[0].shape).file == "../a.obj");
    CHECK(save_scene(scene, folder.path("sub/b.json")).empty());
    const Scene again = load_scene(folder.path("sub/b.json")).scene;
    CHECK(std::get<Mesh>(again.objects[0].shape).triangles.size() == 1);
}

}  // namespace
}  // namespace raytree
