#include "formats/nff.h"

#include <cmath>

#include "folders.h"
#include "formats/support.h"

namespace raytree {
namespace {

using test::refusal_of;

const std::string kView =
    "v\nfrom 1 2 3\nat 0 0 0\nup 0 0 1\nangle 90\nhither 0.5\nresolution 512 256\n";
const std::string kMaterial = "f 1 0.5 0.25 0.8 0.1 30 0.5 1.5\n";

struct Read {
    Scene scene;
    std::vector<std::string> warnings;
};

Read read(const std::string& text, std::optional<std::pair<int, int>> size = {}) {
    Read result;
    result.scene = read_nff(text, "folder/x.nff", size, result.warnings);
    return result;
}

std::string refusal(const std::string& text) {
    return refusal_of([&] { read(text); });
}

TEST_CASE("the view of a Neutral File Format file") {
    const Scene scene = read("b 0.1 0.2 0.3\n" + kView).scene;
    CHECK(scene.name == "x");
    CHECK(scene.background == Colour(0.1, 0.2, 0.3));
    CHECK(scene.ambient == Colour(0.0));
    CHECK(scene.camera.eye == Point(1, 2, 3));
    CHECK(scene.camera.look_at == Point(0, 0, 0));
    CHECK(scene.camera.up == Point(0, 0, 1));
    CHECK(scene.camera.near == 0.5);
    CHECK(scene.camera.width == 512);
    CHECK(scene.camera.height == 256);
    CHECK(scene.settings.max_depth == 5);
    CHECK(scene.settings.min_weight == 0);
    CHECK(scene.settings.pixel_sample == PixelSample::center);
    CHECK(scene.settings.quantize == Quantize::round);
    // tan 45 degrees is 1; between the first row's centre and the last's lie 255 of 256 rows
    const auto window = std::get<ImagePlane>(scene.camera.window);
    CHECK(window.top == doctest::Approx(256.0 / 255).epsilon(1e-15));
    CHECK(window.right == doctest::Approx(512.0 / 255).epsilon(1e-15));
    CHECK(window.left == -window.right);
    CHECK(window.bottom == -window.top);
}

TEST_CASE("the window follows the size that was asked for") {
    const Scene scene = read(kView, std::pair(33, 11)).scene;
    CHECK(scene.camera.width == 33);
    CHECK(scene.camera.height == 11);
    const auto window = std::get<ImagePlane>(scene.camera.window);
    CHECK(window.top == doctest::Approx(1.1).epsilon(1e-15));
    CHECK(window.right == doctest::Approx(3.3).epsilon(1e-15));
    CHECK_CONTAINS(refusal_of([] { read(kView, std::pair(33, 1)); }), "the height must be 2");
}

TEST_CASE("statements are words, whatever their lines, and comments end with the line") {
    const std::string one_line =
        "# s 1 2 3 4\nv from 1 2 3 at 0 0 0 up 0 0 1 angle 90 hither 0.5 "
        "resolution 512 256 f 1 0.5 0.25 0.8 0.1 30 0.5 1.5# end\n"
        "s 1\n2\t3\r\n 4 l 0 0 0";
    const Scene scene = read(one_line).scene;
    CHECK(scene.objects.size() == 1);
    CHECK(std::get<Sphere>(scene.objects[0].shape).radius == 4);
    CHECK(scene.lights.size() == 1);
}

TEST_CASE("materials take the coefficients that the mapping gives them") {
    const Scene scene = read(kView + kMaterial + "s 0 0 0 1\nf 0 0 1 1 0 1 0 0\ns 0 0 0 2\n").scene;
    REQUIRE(scene.materials.size() == 2);
    const Material& first = scene.materials[0];
    CHECK(first.name == "material0");
    CHECK(first.color == Colour(1, 0.5, 0.25));
    CHECK(first.specular_color == Colour(1.0));
    CHECK(first.ka == Colour(0.0));
    CHECK(first.kd == Colour(0.8));
    CHECK(first.ks == Colour(0.1));
    CHECK(first.kr == Colour(0.1));
    CHECK(first.shininess == 30);
    CHECK(first.kt == Colour(0.5));
    CHECK(first.ior == 1.5);
    CHECK(!first.in_place);
    CHECK(scene.materials[1].name == "material1");
    CHECK(scene.materials[1].ior == 1);  // 0 in the file
    CHECK(scene.objects[0].material == 0);
    CHECK(scene.objects[1].material == 1);
}

TEST_CASE("lights without a colour share the light among all of them") {
    const Scene scene = read(kView + "l 1 2 3\nl 4 5 6 0.5 0.25 1\nl 0 0 0\nl 0 1 0").scene;
    REQUIRE(scene.lights.size() == 4);
    CHECK(scene.lights[0].intensity == Colour(0.5));  // 1 / sqrt 4
    CHECK(scene.lights[1].intensity == Colour(0.5, 0.25, 1));
    CHECK(scene.lights[3].intensity == Colour(0.5));
    CHECK(scene.lights[3].name == "light3");
    CHECK(std::get<PointLight>(scene.lights[1].kind).position == Point(4, 5, 6));
}

TEST_CASE("shapes are named by their place; negative radii are taken as positive") {
    const Scene scene = read(kView + kMaterial +
                             "s 1 2 3 -0.5\nc 0 0 0 1 0 0 2 -0.25\np 3 0 0 0 1 0 0 0 1 0\n"
                             "pp 3 0 0 0 0 0 1 1 0 0 0 1 1 0 1 0 1 0 1")
                            .scene;
    REQUIRE(scene.objects.size() == 4);
    CHECK(scene.objects[0].name == "sphere0");
    CHECK(std::get<Sphere>(scene.objects[0].shape).radius == 0.5);
    CHECK(scene.objects[1].name == "cone1");
    CHECK(std::get<Cone>(scene.objects[1].shape).apex == Point(0, 0, 2));
    CHECK(std::get<Cone>(scene.objects[1].shape).apex_radius == 0.25);
    CHECK(scene.objects[2].name == "polygon2");
    CHECK(std::get<Polygon>(scene.objects[2].shape).normals.empty());
    CHECK(scene.objects[3].name == "polygon3");
    CHECK(std::get<Polygon>(scene.objects[3].shape).vertices[2] == Point(0, 1, 0));
    CHECK(std::get<Polygon>(scene.objects[3].shape).normals[1] == Point(0, 1, 1));
}

TEST_CASE("a polygon out of plane is split, with a warning") {
    const Read result = read(kView + kMaterial + "p 4 0 0 0 1 0 0 1 1 0.5 0 1 0\ns 0 0 0 1");
    REQUIRE(result.scene.objects.size() == 3);
    CHECK(result.scene.objects[1].name == "polygon1");
    CHECK(result.scene.objects[2].name == "sphere2");
    REQUIRE(result.warnings.size() == 1);
    CHECK_CONTAINS(result.warnings[0],
                   "x.nff: line 9, column 1: the polygon of 4 vertices is not planar; it is split "
                   "into 2 triangles");
}

TEST_CASE("a concave polygon out of plane keeps its outline when it is split") {
    // An arrowhead: a triangle of area 2 without one of area 1/2.
    const Read result = read(kView + kMaterial + "p 4 0 0 0 1 0.5 0 2 0 0.01 1 2 0\n");
    double area = 0;
    for (const Object& object : result.scene.objects) {
        const auto& v = std::get<Polygon>(object.shape).vertices;
        area += length(outer(v[1] - v[0], v[2] - v[0])) / 2;
    }
    CHECK(area == doctest::Approx(1.5).epsilon(1e-3));
}

TEST_CASE("what the format does not know is refused with line, column and word") {
    CHECK(
        refusal(kView + "x 1 2 3") ==
        "folder/x.nff: line 8, column 1: found \"x\", must be a statement: v, b, l, f, s, c, p or "
        "pp");
    CHECK_CONTAINS(refusal("b 1 2 three"), "line 1, column 7: found \"three\", must be a finite");
    CHECK_CONTAINS(refusal("b 1 2"), "found the end of the file");
    CHECK_CONTAINS(refusal("b 1 nan 2"), "line 1, column 5: found \"nan\"");
    CHECK_CONTAINS(refusal("b 1 1e999 2"), "found \"1e999\", must be a finite number");
    CHECK_CONTAINS(refusal("b 1 2 3"), "has no view");
    CHECK_CONTAINS(refusal(kView + kView), "line 8, column 1: a second view");
    CHECK_CONTAINS(refusal("v from 0 0 1 at 0 0 0 up 0 1 0 angle 45 hither 0 b 0 0 0"),
                   "\"resolution\" is missing");
    CHECK_CONTAINS(refusal("v from 0 0 1 from 0 0 1"), "column 14: a second \"from\"");
    CHECK_CONTAINS(refusal(kView + "s 0 0 0 1"), "needs a material before it");
    CHECK_CONTAINS(refusal(kView + kMaterial + "s 0 0 0 0"),
                   "line 9, column 9: a sphere's radius must not be 0");
    CHECK_CONTAINS(refusal(kView + kMaterial + "c 0 0 0 0 1 0 0 0"), "radii are both 0");
    CHECK_CONTAINS(refusal(kView + kMaterial + "c 1 0 0 1 1 0 0 1"), "the same point");
    CHECK_CONTAINS(refusal(kView + kMaterial + "p 2 0 0 0 1 0 0"),
                   "found \"2\", must be a whole number from 3");
    CHECK_CONTAINS(refusal(kView + kMaterial + "p 3 0 0 0 1 1 1 2 2 2"), "on one line");
    CHECK_CONTAINS(refusal(kView + kMaterial + "pp 3 0 0 0 0 0 0"), "must have a length");
    CHECK_CONTAINS(refusal(kView + "f 1 1 1 1 0 1 0.5 0"), "ior is 0");
    CHECK_CONTAINS(refusal(kView + "f 1 1 1 -1 0 1 0 1"), "must be 0 or more");
    CHECK_CONTAINS(refusal(kView + kMaterial + "p 99999999 0 0 0"), "found the end of the file");
}

TEST_CASE("angles and sizes out of range are refused") {
    const auto view = [](const std::string& rest) {
        return "v from 0 0 1 at 0 0 0 up 0 1 0 " + rest;
    };
    CHECK_CONTAINS(refusal(view("angle 180 hither 0 resolution 5 5")), "under 180 degrees");
    CHECK_CONTAINS(refusal(view("angle 45 hither -1 resolution 5 5")), "hither must be 0 or more");
    CHECK_CONTAINS(refusal(view("angle 45 hither 0 resolution 5 1")), "the height must be 2");
    CHECK_CONTAINS(refusal(view("angle 45 hither 0 resolution 5 70000")), "from 1 to 65535");
    CHECK_CONTAINS(refusal(view("angle 45 hither 0 resolution 5.5 5")), "found \"5.5\"");
}

TEST_CASE("a scene that the format can say survives being written and read") {
    const Scene scene = read("b 0.1 0.2 0.3\n" + kView + "l 1 2 3 1 1 1\n" + kMaterial +
                             "s 1 2 3 0.5\nf 0 0 1 1 0 1 0 1\nc 0 0 0 1 0 0 2 0.25\n"
                             "p 3 0 0 0 1 0 0 0 1 0\npp 3 0 0 0 0 0 1 1 0 0 0 1 1 0 1 0 1 0 1")
                            .scene;
    std::vector<std::string> lost;
    Scene again = read(write_nff(scene, lost)).scene;
    CHECK(lost.empty());
    const auto window = std::get<ImagePlane>(scene.camera.window);
    CHECK(std::get<ImagePlane>(again.camera.window).top ==
          doctest::Approx(window.top).epsilon(1e-14));
    again.camera.window = window;  // the angle is rounded
    std::string why;
    CHECK_MESSAGE(test::same_scene(scene, again, why), why);
}

TEST_CASE("transforms are carried out, and what cannot be said is told") {
    Scene scene = read(kView + kMaterial +
                       "s 1 0 0 1\nc 0 0 0 1 0 0 2 0\np 3 0 0 0 1 0 0 0 1 0\n"
                       "s 0 0 0 1")
                      .scene;
    scene.settings.max_depth = 9;
    scene.objects[0].transform = Affine{{{0, -2, 0, 5}, {2, 0, 0, 0}, {0, 0, 2, 0}}};
    scene.objects[1].transform = Affine{{{1, 0, 0, 5}, {0, 1, 0, 6}, {0, 0, 1, 7}}};
    scene.objects[2].transform = Affine{{{1, 0, 0, 0}, {0, 3, 0, 0}, {0, 0, 1, 1}}};
    scene.objects[3].transform = Affine{{{1, 0, 0, 0}, {0, 3, 0, 0}, {0, 0, 1, 1}}};
    Light sun;
    sun.name = "sun";
    sun.kind = DirectionalLight{};
    scene.lights.push_back(sun);
    std::vector<std::string> lost;
    const Scene again = read(write_nff(scene, lost)).scene;
    REQUIRE(again.objects.size() == 3);
    CHECK(std::get<Sphere>(again.objects[0].shape).center == Point(5, 2, 0));
    CHECK(std::get<Sphere>(again.objects[0].shape).radius == 2);
    CHECK(std::get<Cone>(again.objects[1].shape).apex == Point(5, 6, 9));
    CHECK(std::get<Polygon>(again.objects[2].shape).vertices[2] == Point(0, 3, 1));
    REQUIRE(lost.size() == 3);
    CHECK_CONTAINS(lost[0], "max_depth");
    CHECK_CONTAINS(lost[1], "sun");
    CHECK_CONTAINS(lost[2], "sphere3");
}

TEST_CASE("the Standard Procedural Databases load as their description counts them") {
    const std::filesystem::path folder = RAYTREE_SHARED_DATA_DIR "/nff";
    if (!std::filesystem::exists(folder)) {
        return;
    }
    const auto load = [&](const char* name) { return read(test::text_of(folder / name)); };
    CHECK(load("balls.nff").scene.objects.size() == 7382);
    CHECK(load("mount.nff").scene.objects.size() == 8196);
    CHECK(load("rings.nff").scene.objects.size() == 8401);
    CHECK(load("tetra.nff").scene.objects.size() == 4096);
    CHECK(load("tree.nff").scene.objects.size() == 8191);
    CHECK(load("tree.nff").scene.lights.size() == 7);
    CHECK(load("mount.nff").warnings.empty());
}

}  // namespace
}  // namespace raytree
