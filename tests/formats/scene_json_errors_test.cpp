#include "formats/scene_json.h"
#include "formats/support.h"

namespace raytree {
namespace {

using test::mistakes_of;

constexpr const char* kGood = R"({"format": "raytree-scene/1.0",
  "camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0], "horizontal_fov_degrees": 50,
             "width": 640, "height": 480},
  "settings": {"max_depth": 6},
  "materials": {"glass": {"kt": 0.8}, "matt": {"kd": 0.5}},
  "lights": [{"name": "key", "type": "point", "position": [3, 6, 4]}],
  "objects": [{"name": "ball", "type": "sphere", "center": [0, 1, 0], "radius": 1, "material": "glass"},
    {"name": "tile", "type": "polygon", "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "material": "matt"},
    {"name": "rod", "type": "cone", "base": [0, 0, 0], "base_radius": 1, "apex": [0, 1, 0],
     "apex_radius": 1, "material": "matt"}]
})";

std::vector<Mistake> mistakes_in(const std::string& text) {
    return mistakes_of([&] {
        std::vector<std::string> warnings;
        read_scene_json(text, "bad.json", warnings);
    });
}

/// The mistakes in the good scene after one part of it is replaced.
std::vector<Mistake> mistakes_with(const std::string& part, const std::string& replacement) {
    std::string text = kGood;
    const auto at = text.find(part);
    REQUIRE_MESSAGE(at != std::string::npos, part);
    return mistakes_in(text.replace(at, part.size(), replacement));
}

struct Case {
    const char* part;
    const char* replacement;
    const char* place;
    const char* says;
};

void check_all(const std::vector<Case>& cases) {
    for (const Case& each : cases) {
        CAPTURE(each.replacement);
        const auto mistakes = mistakes_with(each.part, each.replacement);
        REQUIRE(mistakes.size() == 1);
        CHECK(mistakes[0].file == "bad.json");
        CHECK(mistakes[0].place == each.place);
        CHECK_CONTAINS(mistakes[0].text, each.says);
    }
}

TEST_CASE("the scene that these tests spoil is good") { CHECK(mistakes_in(kGood).empty()); }

TEST_CASE("an unknown key says what was probably meant") {
    check_all({
        {R"("radius": 1,)", R"("radius": 1, "shinyness": 2,)", "/objects/0/shinyness",
         "is an unknown key, must be \"name\""},
        {R"("kt": 0.8)", R"("kt": 0.8, "colour": 1)", "/materials/glass/colour",
         "is an unknown key; did you mean \"color\"?"},
        {R"("max_depth": 6)", R"("maxdepth": 6)", "/settings/maxdepth",
         "did you mean \"max_depth\"?"},
        {R"("settings")", R"("setings")", "/setings", "did you mean \"settings\"?"},
        {R"("center": [0, 1, 0])", R"("center": [0, 1, 0], "vertices": [])", "/objects/0/vertices",
         "is an unknown key"},
        {R"("position": [3, 6, 4])", R"("position": [3, 6, 4], "direction": [0, 1, 0])",
         "/lights/0/direction", "is an unknown key"},
        {R"("kt": 0.8)", R"("a/b~": 1)", "/materials/glass/a~1b~0", "is an unknown key"},
    });
}

TEST_CASE("a missing key is named with what it must be") {
    check_all({
        {R"(, "radius": 1)", "", "/objects/0/radius", "is missing, must be a number"},
        {R"("eye": [0, 0, 5], )", "", "/camera/eye", "is missing, must be a list of 3 numbers"},
        {R"("width": 640, )", "", "/camera/width", "is missing, must be a whole number from 1 to"},
        {R"(, "position": [3, 6, 4])", "", "/lights/0/position", "is missing"},
        {R"(, "type": "point")", "", "/lights/0/type", "must be \"point\" or \"directional\""},
        {R"(, "material": "glass")", "", "/objects/0/material",
         "is missing, must be the name of a material, or a material"},
        {R"("horizontal_fov_degrees": 50,)", "", "/camera/horizontal_fov_degrees",
         "exactly one of the two is needed"},
    });
}

TEST_CASE("a wrong type or length says what was found and what is allowed") {
    check_all({
        {R"("radius": 1,)", R"("radius": "one",)", "/objects/0/radius",
         "found \"one\", must be a number"},
        {R"([0, 1, 0], "radius")", R"([0, 1], "radius")", "/objects/0/center",
         "found a list of 2, must be a list of 3 numbers"},
        {R"([0, 1, 0], "radius")", R"([0, null, 0], "radius")", "/objects/0/center/1",
         "found null, must be a number"},
        {R"("kt": 0.8)", R"("kt": [1, 2])", "/materials/glass/kt",
         "found a list of 2, must be an RGB list of 3 numbers, or one number"},
        {R"("kt": 0.8)", R"("kt": [1, 2, true])", "/materials/glass/kt/2", "found true"},
        {R"("width": 640)", R"("width": 640.5)", "/camera/width", "found 640.5, must be a whole"},
        {R"("settings": {"max_depth": 6})", R"("settings": [])", "/settings",
         "found a list of 0, must be an object"},
        {R"("materials": {"glass": {"kt": 0.8})", R"("materials": {"glass": 3)", "/materials/glass",
         "found 3, must be an object"},
        {R"([{"name": "key", "type": "point", "position": [3, 6, 4]}])", R"({})", "/lights",
         "found an object, must be a list of objects"},
        {R"("name": "ball")", R"("name": 7)", "/objects/0/name", "found 7, must be a string"},
        {R"("type": "sphere")", R"("type": "spheer")", "/objects/0/type",
         "found \"spheer\", must be \"sphere\", \"polygon\", \"cone\" or \"mesh\"; did you mean "
         "\"sphere\"?"},
        {R"("max_depth": 6)", R"("shadows": "soft")", "/settings/shadows",
         "found \"soft\", must be \"opaque\", \"transmissive\" or \"none\""},
        {R"("radius": 1,)", R"("radius": 1, "transform": [[1]],)", "/objects/0/transform",
         "found a list of 1, must be 4 rows of 4 numbers"},
        {R"("radius": 1,)",
         R"("radius": 1, "transform": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,1,1]],)",
         "/objects/0/transform/3", "must be [0, 0, 0, 1]"},
        {R"("horizontal_fov_degrees": 50,)",
         R"("horizontal_fov_degrees": 50, "image_plane": [-1, 1, -1, 1],)", "/camera/image_plane",
         "exactly one of the two is allowed"},
    });
}

TEST_CASE("a value outside its range says what was found and what is allowed") {
    check_all({
        {R"("radius": 1,)", R"("radius": 0,)", "/objects/0/radius",
         "found 0, must be a finite number over 0"},
        {R"("radius": 1,)", R"("radius": -2,)", "/objects/0/radius", "found -2"},
        {R"("width": 640)", R"("width": 0)", "/camera/width",
         "found 0, must be a whole number from 1 to 65535"},
        {R"("width": 640, "height": 480)", R"("width": 40000, "height": 25000)", "/camera",
         "1000000000 pixels; at most 2^28"},
        {R"("width": 640)", R"("width": 1000000000)", "/camera/width", "found 1000000000"},
        {R"("max_depth": 6)", R"("max_depth": 1000000000)", "/settings/max_depth",
         "found 1000000000, must be a whole number from 1 to 64"},
        {R"("max_depth": 6)", R"("max_depth": 1e18)", "/settings/max_depth", "found 1e+18"},
        {R"("max_depth": 6)", R"("max_depth": 0)", "/settings/max_depth", "found 0"},
        {R"("max_depth": 6)", R"("min_weight": -1)", "/settings/min_weight",
         "found -1, must be a finite number, 0 or more"},
        {R"("max_depth": 6)", R"("max_distance": 0)", "/settings/max_distance", "over 0"},
        {R"("max_depth": 6)", R"("ray_budget": 0)", "/settings/ray_budget", "from 1"},
        {R"("max_depth": 6)", R"("attenuation": [0, 0, 0])", "/settings/attenuation", "not all 0"},
        {R"("max_depth": 6)", R"("attenuation": [1, -1, 0])", "/settings/attenuation",
         "found [1, -1, 0]"},
        {R"("kt": 0.8)", R"("ior": 0)", "/materials/glass/ior", "over 0"},
        {R"("kt": 0.8)", R"("kr": [0, -0.5, 0])", "/materials/glass/kr", "found -0.5"},
        {R"("horizontal_fov_degrees": 50)", R"("horizontal_fov_degrees": 180)",
         "/camera/horizontal_fov_degrees", "found 180, must be over 0 and under 180"},
        {R"("horizontal_fov_degrees": 50)", R"("image_plane": [1, -1, -1, 1])",
         "/camera/image_plane", "found [1, -1, -1, 1], must be finite numbers [left, right"},
        {R"("look_at": [0, 0, 0])", R"("look_at": [0, 0, 5])", "/camera", "the same point"},
        {R"("look_at": [0, 0, 0])", R"("look_at": [0, 7, 5])", "/camera", "parallel"},
    });
}

TEST_CASE("shapes that are none are refused") {
    check_all({
        {"[[0, 0, 0], [1, 0, 0], [0, 1, 0]]", "[[0, 0, 0], [1, 0, 0]]", "/objects/1/vertices",
         "found 2 vertices, must be 3 or more"},
        {"[[0, 0, 0], [1, 0, 0], [0, 1, 0]]", "[[0, 0, 0], [1, 1, 1], [3, 3, 3]]",
         "/objects/1/vertices", "collinear"},
        {"[[0, 0, 0], [1, 0, 0], [0, 1, 0]]", "[[0, 0, 0], [1, 0, 0], [1, 1, 0.1], [0, 1, 0]]",
         "/objects/1/vertices", "not planar"},
        {"[0, 1, 0]], ", R"([0, 1, 0]], "normals": [[0, 0, 1]], )", "/objects/1/normals",
         "found 1 normals for 3 vertices"},
        {"[0, 1, 0]], ", R"([0, 1, 0]], "normals": [[0, 0, 1], [0, 0, 0], [0, 0, 1]], )",
         "/objects/1/normals/1", "length 0"},
        {R"("base_radius": 1, "apex": [0, 1, 0],)", R"("base_radius": 1, "apex": [0, 0, 0],)",
         "/objects/2", "the same point"},
        {R"("radius": 1,)",
         R"("radius": 1, "transform": [[1,2,3,0],[2,4,6,0],[0,0,1,0],[0,0,0,1]],)",
         "/objects/0/transform", "singular"},
    });
}

TEST_CASE("a name that nothing defines, or that is there twice, is refused") {
    check_all({
        {R"("material": "glass")", R"("material": "galss")", "/objects/0/material",
         "there is no material \"galss\"; did you mean \"glass\"?"},
        {R"("material": "glass")", R"("material": 3)", "/objects/0/material",
         "found 3, must be the name of a material, or a material"},
        {R"("name": "tile")", R"("name": "ball")", "/objects/1/name",
         "the name \"ball\" is that of /objects/0 already"},
    });
}

TEST_CASE("a default name collides with a given one") {
    std::string text = kGood;
    text.replace(text.find(R"("name": "tile", )"), 16, "");
    text.replace(text.find(R"("ball")"), 6, R"("polygon1")");
    const auto mistakes = mistakes_in(text);
    REQUIRE(mistakes.size() == 1);
    CHECK(mistakes[0].place == "/objects/1/name");
    CHECK_CONTAINS(mistakes[0].text, "given or by default");
}

TEST_CASE("several mistakes are reported together, each once") {
    const auto mistakes = mistakes_in(R"({"format": "raytree-scene/1.0",
        "camera": {"look_at": [0, 0, 0], "horizontal_fov_degrees": 500, "width": 0, "height": 3},
        "settings": {"max_dept": 3, "min_weight": -1},
        "objects": [{"type": "polygon", "material": "none"},
                    {"type": "sphere", "center": [0, 0], "radius": -1, "material": {"kr": -1}}]})");
    std::vector<std::string> places;
    for (const Mistake& mistake : mistakes) {
        places.push_back(mistake.place);
    }
    CHECK(places == std::vector<std::string>{"/camera/eye", "/camera/width", "/settings/max_dept",
                                             "/objects/0/material", "/objects/0/vertices",
                                             "/objects/1/center", "/camera/horizontal_fov_degrees",
                                             "/settings/min_weight", "/objects/1/material/kr",
                                             "/objects/1/radius"});
}

TEST_CASE("a million mistakes end after a readable number") {
    std::string objects = "[";
    for (int k = 0; k < 100000; ++k) {
        objects += R"({"type": "sphere", "center": [0, 0, 0], "radius": 1, "material": "glas"},)";
    }
    std::string text = kGood;
    const auto at = text.find("[{\"name\": \"ball\"");
    const auto mistakes = mistakes_in(text.substr(0, at) + objects + "{}]}");
    CHECK(mistakes.size() < 60);
    CHECK_CONTAINS(mistakes.back().text, "left out");
}

TEST_CASE("another format, another major version or none is refused at once") {
    const auto refusal = [](const std::string& format) {
        return mistakes_with("\"format\": \"raytree-scene/1.0\"", format);
    };
    for (const char* format : {"\"raytree-scene/2.0\"", "\"raytree/1.0\"", "\"raytree-scene\"",
                               "\"raytree-scene/1\"", "\"raytree-scene/1.0x\"", "1.0"}) {
        CAPTURE(format);
        const auto mistakes = refusal("\"format\": " + std::string(format));
        REQUIRE(mistakes.size() == 1);
        CHECK(mistakes[0].place == "/format");
        CHECK_CONTAINS(mistakes[0].text, "must be \"raytree-scene/1.0\"");
        CHECK_CONTAINS(mistakes[0].text, format);
    }
    CHECK_CONTAINS(refusal("\"frmat\": 1")[0].text, "is missing");
    CHECK_CONTAINS(mistakes_in("[]")[0].text, "found a list of 0, must be an object");
}

TEST_CASE("a mesh's mistakes name the mesh's file and line") {
    const test::ScratchFolder folder;
    folder.write("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 x 0\nf 1 2 3\n");
    const auto read = [&](const char* file) {
        std::string text = kGood;
        const std::string sphere = R"("type": "sphere", "center": [0, 1, 0], "radius": 1)";
        text.replace(text.find(sphere), sphere.size(),
                     R"("type": "mesh", "file": ")" + std::string(file) + '"');
        return mistakes_of([&] {
            std::vector<std::string> warnings;
            read_scene_json(text, folder.path("scene.json"), warnings);
        });
    };
    const auto bad = read("bad.obj");
    REQUIRE(bad.size() == 1);
    CHECK(bad[0].place == "/objects/0/file");
    CHECK_CONTAINS(bad[0].text, "bad.obj: line 3: found \"x\"");
    CHECK_CONTAINS(read("none.obj")[0].text, "there is no such file");
}

}  // namespace
}  // namespace raytree
