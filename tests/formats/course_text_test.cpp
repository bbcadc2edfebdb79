#include "formats/course_text.h"

#include "folders.h"
#include "formats/support.h"

namespace raytree {
namespace {

using test::refusal_of;

CourseScene read(const std::string& text) { return read_course_text(text, "folder/x.txt"); }

std::string refusal(const std::string& text) {
    return refusal_of([&] { read(text); });
}

const std::string kScene =
    "\nOUTPUT \ttestParsing.ppm\nLEFT\t\t-1\nRIGHT 2\r\nBOTTOM -3 \n"
    "TOP 4\nNEAR 2\n\nAMBIENT 0.2 0.3 0.4\nBACK 1 0.5 0\nRES 600 400\n"
    "SPHERE s1 1 2 -10 2 4 3 0.5 0 0.25 0.1 0.2 0.3 0.4 50\n"
    "LIGHT l1 0 1 2 0.9 0.8 0.7";

TEST_CASE("the course text format's statements, in any order") {
    const CourseScene result = read(kScene);
    const Scene& scene = result.scene;
    CHECK(result.output == "testParsing.ppm");
    CHECK(scene.name == "x");
    CHECK(scene.camera.eye == Point(0, 0, 0));
    CHECK(scene.camera.look_at == Point(0, 0, -1));
    CHECK(scene.camera.up == Point(0, 1, 0));
    CHECK(scene.camera.near == 2);
    CHECK(scene.camera.width == 600);
    CHECK(scene.camera.height == 400);
    const auto window = std::get<ImagePlane>(scene.camera.window);
    CHECK(window.left == -0.5);
    CHECK(window.right == 1);
    CHECK(window.bottom == -1.5);
    CHECK(window.top == 2);
    CHECK(scene.ambient == Colour(0.2, 0.3, 0.4));
    CHECK(scene.background == Colour(1, 0.5, 0));
}

TEST_CASE("settings that go with the course text format") {
    const Settings settings = read(kScene).scene.settings;
    CHECK(settings.pixel_sample == PixelSample::corner);
    CHECK(settings.max_depth == 4);
    CHECK(settings.min_weight == 0);
    CHECK(settings.secondary_background == Colour(0.0));
    CHECK(settings.quantize == Quantize::floor);
    CHECK(settings.specular_model == SpecularModel::phong);
    CHECK(settings.shadows == ShadowMode::opaque);
    CHECK(settings.attenuation == Attenuation{1, 0, 0});
}

TEST_CASE("a sphere is the unit sphere, scaled and moved, with a material of its own") {
    const Scene scene = read(kScene).scene;
    REQUIRE(scene.objects.size() == 1);
    const Object& object = scene.objects[0];
    CHECK(object.name == "s1");
    CHECK(std::get<Sphere>(object.shape).radius == 1);
    CHECK(*object.transform == Affine{{{2, 0, 0, 1}, {0, 4, 0, 2}, {0, 0, 3, -10}}});
    const Material& material = scene.materials[object.material];
    CHECK(material.name == "s1");
    CHECK(material.in_place);
    CHECK(material.color == Colour(0.5, 0, 0.25));
    CHECK(material.specular_color == Colour(1.0));
    CHECK(material.ka == Colour(0.1));
    CHECK(material.kd == Colour(0.2));
    CHECK(material.ks == Colour(0.3));
    CHECK(material.kr == Colour(0.4));
    CHECK(material.kt == Colour(0.0));
    CHECK(material.shininess == 50);
    REQUIRE(scene.lights.size() == 1);
    CHECK(scene.lights[0].name == "l1");
    CHECK(scene.lights[0].intensity == Colour(0.9, 0.8, 0.7));
    CHECK(std::get<PointLight>(scene.lights[0].kind).position == Point(0, 1, 2));
}

TEST_CASE("missing statements take their defaults, but the resolution is needed") {
    const CourseScene result = read("RES 2 3");
    CHECK(result.scene.camera.near == 1);
    const auto window = std::get<ImagePlane>(result.scene.camera.window);
    CHECK(window.left == -1);
    CHECK(window.top == 1);
    CHECK(result.scene.background == Colour(0.0));
    CHECK(result.scene.ambient == Colour(0.0));
    CHECK(!result.output);
    CHECK(refusal("NEAR 1") == "folder/x.txt: has no resolution; one statement RES x y is needed");
}

TEST_CASE("the picture's name is the last part alone") {
    CHECK(read("RES 2 3\nOUTPUT ../../etc/x.ppm").output == "x.ppm");
    CHECK(read("RES 2 3\nOUTPUT c:\\pictures\\x.ppm").output == "x.ppm");
    CHECK_CONTAINS(refusal("RES 2 3\nOUTPUT ../.."), "line 2, column 8: OUTPUT needs the name");
    CHECK_CONTAINS(refusal("RES 2 3\nOUTPUT"), "OUTPUT needs the name of a file");
}

TEST_CASE("what the course text format does not know is refused with line, column and word") {
    CHECK_CONTAINS(refusal("RES 2 2\n  SPERE s1 0 0 0"),
                   "line 2, column 3: found \"SPERE\", must be a statement: NEAR");
    CHECK_CONTAINS(refusal("SPERE"), "did you mean \"SPHERE\"?");
    CHECK_CONTAINS(refusal("RES 2 2 2"), "line 1, column 9: found \"2\" where the statement RES");
    CHECK_CONTAINS(refusal("RES 2\n2"), "line 1, column 6: found the end of the line");
    CHECK_CONTAINS(refusal("RES 2 0"), "found \"0\", must be a whole number from 1 to 65535");
    CHECK_CONTAINS(refusal("NEAR one"), "column 6: found \"one\", must be a finite number: NEAR n");
    CHECK_CONTAINS(refusal("NEAR 0"), "must be over 0");
    CHECK_CONTAINS(refusal("LEFT inf"), "found \"inf\", must be a finite number");
    CHECK_CONTAINS(refusal("NEAR 1\nNEAR 1"),
                   "line 2, column 1: the statement NEAR is there twice, first on line 1");
    CHECK_CONTAINS(refusal("RES 2 2\nLEFT 3"), "line 2: LEFT must be less than RIGHT");
    CHECK_CONTAINS(refusal("RES 2 2\nTOP -1"), "line 2: BOTTOM must be less than TOP");
    const std::string rest = " 0 0 0 1 1 1 1 1 1 0 0 0 0 1\n";
    CHECK_CONTAINS(refusal("SPHERE a" + rest + "SPHERE a" + rest),
                   "line 2, column 8: the SPHERE \"a\" is there twice, first on line 1");
    CHECK_CONTAINS(refusal("SPHERE a 0 0 0 1 0 1 1 1 1 0 0 0 0 1"), "must not be 0 along any axis");
    CHECK_CONTAINS(refusal("SPHERE a 0 0 0 1 1 1 1 1 1 0 -1 0 0 1"),
                   "found \"-1\", must be 0 or more");
    CHECK_CONTAINS(refusal("LIGHT"), "LIGHT needs a name");
    CHECK_CONTAINS(refusal("LIGHT l1 0 0 0 1 1\nRES 2 2"), "found the end of the line");
}

TEST_CASE("a course scene survives being written and read") {
    const Scene scene = read(kScene).scene;
    std::vector<std::string> lost;
    const std::string text = write_course_text(scene, "x.ppm", lost);
    CHECK(lost.empty());
    const CourseScene again = read(text);
    CHECK(again.output == "x.ppm");
    std::string why;
    CHECK_MESSAGE(test::same_scene(scene, again.scene, why), why);
}

TEST_CASE("a scene seen from elsewhere is moved before the course camera") {
    Scene scene = read(kScene).scene;
    // From (5, 0, 0) towards +x: what lies d in front of the eye has x = 5 + d.
    scene.camera.eye = {5, 0, 0};
    scene.camera.look_at = {6, 0, 0};
    scene.objects[0].transform.reset();
    scene.objects[0].shape = Sphere{{15, 1, 2}, 3};
    std::vector<std::string> lost;
    const Scene again = read(write_course_text(scene, "x.ppm", lost)).scene;
    CHECK(lost.empty());
    REQUIRE(again.objects.size() == 1);
    // +z of the world is to the right there
    CHECK(*again.objects[0].transform == Affine{{{3, 0, 0, 2}, {0, 3, 0, 1}, {0, 0, 3, -10}}});
}

TEST_CASE("what the course text format cannot say is told") {
    Scene scene = read(kScene).scene;
    scene.settings.shadows = ShadowMode::none;
    scene.camera.near = 0;
    scene.materials[0].kt = Colour(0.5);
    scene.materials[0].kd = Colour(0, 0.5, 1);
    Object tile;
    tile.name = "tile";
    tile.shape = Polygon{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
    scene.objects.push_back(tile);
    Object skewed;
    skewed.name = "skewed";
    skewed.transform = Affine{{{1, 0.5, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
    scene.objects.push_back(skewed);
    std::vector<std::string> lost;
    const Scene again = read(write_course_text(scene, "x.ppm", lost)).scene;
    std::string all;
    for (const std::string& sentence : lost) {
        all += sentence + '\n';
    }
    CHECK(lost.size() == 6);
    for (const char* part : {"shadows", "near plane", "kt", "Kd of s1", "tile", "skewed"}) {
        CHECK_CONTAINS(all, part);
    }
    CHECK(again.materials[0].kd == Colour(0.5));
    CHECK(again.objects.size() == 1);
}

TEST_CASE("the twelve course scenes load") {
    const auto files = test::files_in(RAYTREE_SHARED_DATA_DIR "/courses", ".txt");
    CHECK((files.empty() || files.size() == 12));
    for (const auto& file : files) {
        CAPTURE(file);
        const CourseScene result = read_course_text(test::text_of(file), file);
        CHECK(result.scene.camera.width == 600);
        CHECK(result.output == file.stem().string() + ".ppm");
        CHECK(!result.scene.objects.empty());
    }
}

}  // namespace
}  // namespace raytree
