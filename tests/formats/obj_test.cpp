#include "formats/obj.h"

#include <cmath>

#include "formats/support.h"

namespace raytree {
namespace {

using test::refusal_of;

struct Read {
    Mesh mesh;
    std::vector<std::string> warnings;
};

Read read(const std::string& text) {
    Read result;
    result.mesh = read_obj(text, "folder/x.obj", result.warnings);
    return result;
}

std::string refusal(const std::string& text) {
    return refusal_of([&] { read(text); });
}

const std::string kCorners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::vector<int> vertices_of(const Mesh& mesh) {
    std::vector<int> indices;
    for (const Mesh::Triangle& triangle : mesh.triangles) {
        for (const Mesh::Corner& corner : triangle) {
            indices.push_back(corner.vertex);
        }
    }
    return indices;
}

TEST_CASE("faces of an OBJ file are fanned from their first vertex") {
    const Mesh mesh = read(kCorners + "f 2 3 4 1\n").mesh;
    CHECK(mesh.file == "x.obj");
    CHECK(mesh.smooth);
    CHECK(mesh.vertices.size() == 4);
    CHECK(vertices_of(mesh) == std::vector<int>{1, 2, 3, 1, 3, 0});
    CHECK(mesh.triangles[0][0].normal == -1);
}

TEST_CASE("all spellings of a corner, and indices counted backwards") {
    const std::string normals = "vt 0 0\nvn 0 0 2\nvn 0 1 0\n";
    const Mesh mesh = read(kCorners + normals +
                           "f 1 2 3\nf 1/1 2/1 3/1\nf 1//2 2//2 3//1\nf 1/1/2 2/1/2 3/1/2\n"
                           "f -4//-1 -3//-1 -2//-2 # comment\n")
                          .mesh;
    REQUIRE(mesh.triangles.size() == 5);
    CHECK(vertices_of(mesh) == std::vector<int>{0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2});
    CHECK(mesh.triangles[0][0].normal == -1);
    CHECK(mesh.triangles[1][0].normal == -1);
    CHECK(mesh.triangles[2][0].normal == 1);
    CHECK(mesh.triangles[2][2].normal == 0);
    CHECK(mesh.triangles[3][2].normal == 1);
    CHECK(mesh.triangles[4][0].normal == 1);
    CHECK(mesh.triangles[4][2].normal == 0);
    CHECK(mesh.normals[0] == Point(0, 0, 2));
}

TEST_CASE("groups, materials and other statements do not disturb the order of faces") {
    const Mesh mesh = read("mtllib none.mtl\no thing\n" + kCorners +
                           "g a\nusemtl red\ns 1\nf 1 2 3\ng b\nusemtl blue\nf 1 3 4\nl 1 2\np 1\n"
                           "t bomb 2000000000/2000000000/2000000000\nvw 0 1 1\nf 2 3 4\n")
                          .mesh;
    CHECK(vertices_of(mesh) == std::vector<int>{0, 1, 2, 0, 2, 3, 1, 2, 3});
}

TEST_CASE("coordinates are the nearest doubles") {
    const Mesh mesh = read(
                          "v 0.1 123456.789012345678 1e-7\nv 3.14159265358979323846 +1 -.5\n"
                          "v 9007199254740993 2.2250738585072011e-308 0 1\nf 1 2 3\n")
                          .mesh;
    CHECK(mesh.vertices[0] == Point(0.1, 123456.789012345678, 1e-7));
    CHECK(mesh.vertices[1] == Point(3.14159265358979323846, 1, -0.5));
    CHECK(mesh.vertices[2].x == 9007199254740992.0);
    CHECK(mesh.vertices[2].y == 2.2250738585072011e-308);
}

TEST_CASE("line ends of every kind") {
    const std::string text = "v 0 0 0\rv 1 0 0\r\nv 0 1 0\n\r\nf 1 2 3";
    CHECK(read(text).mesh.triangles.size() == 1);
    CHECK_CONTAINS(refusal("v 0 0 0\r\nv 1 0 0\rv 0 1 0\nf 1 2 x"), "line 4: found \"x\"");
}

TEST_CASE("triangles without area are left out and counted") {
    const Read one = read(kCorners + "f 1 2 3\nf 1 1 2\n");
    CHECK(one.mesh.triangles.size() == 1);
    REQUIRE(one.warnings.size() == 1);
    CHECK(one.warnings[0] == "folder/x.obj: 1 triangle has no area and is left out");
    const Read two = read(kCorners + "v 2 0 0\nf 1 2 3\nf 1 1 2\nf 1 2 5\n");
    CHECK(two.warnings[0] == "folder/x.obj: 2 triangles have no area and are left out");
}

TEST_CASE("a triangle that lacks one normal, or has one of length 0, is flat") {
    const Mesh mesh =
        read(kCorners + "vn 0 0 1\nvn 0 0 0\nf 1//1 2//1 3\nf 1//1 2//2 3//1\nf 1//1 2//1 3//1\n")
            .mesh;
    CHECK(mesh.triangles[0][0].normal == -1);
    CHECK(mesh.triangles[1][0].normal == -1);
    CHECK(mesh.triangles[2][0].normal == 0);
}

TEST_CASE("what is no OBJ file is refused with its line") {
    CHECK(refusal("v 0 0 0\nv 1 zero 0\n") ==
          "folder/x.obj: line 2: found \"zero\", must be a finite number: a vertex, v x y z");
    CHECK_CONTAINS(refusal("v 0 nan 0"), "line 1: found \"nan\"");
    CHECK_CONTAINS(refusal("v 0 1e999 0"), "found \"1e999\"");
    CHECK_CONTAINS(refusal("v 0 0"), "found 2 numbers, must be 3");
    CHECK_CONTAINS(refusal("vn 0 0 -inf"),
                   "found \"-inf\", must be a finite number: a vertex norm");
    CHECK_CONTAINS(refusal(kCorners + "f 1 2\n"),
                   "line 5: found a face of 2 vertices, must be from 3 to 255");
    CHECK_CONTAINS(refusal(kCorners + "f 1 2 5\nf 1 2 3\n"),
                   "line 5: the index 5 in a face is out of range: there are 4 vertices");
    CHECK_CONTAINS(refusal(kCorners + "f 1//1 2//1 3//1\n"), "there are 0 vertex normals");
    CHECK_CONTAINS(refusal(kCorners + "f 1/1 2/1 3/1\n"), "there are 0 texture points");
    CHECK_CONTAINS(refusal(kCorners + "f 1 2 -5\n"), "the index -5 in a face goes back before");
    for (const char* corner : {"0", "x", "1.5", "1/", "1//", "1/2/", "/1", "99999999999"}) {
        CAPTURE(corner);
        CHECK_CONTAINS(refusal(kCorners + "f 1 2 " + corner + "\n"),
                       "line 5: found \"" + std::string(corner) + "\" in a face");
    }
    std::string large = kCorners + "f";
    for (int k = 0; k < 256; ++k) {
        large += " 1";
    }
    CHECK_CONTAINS(refusal(large), "a face of 256 vertices");
}

TEST_CASE("a mesh without a face is refused") {
    const std::string empty = "folder/x.obj: the mesh is empty: it has no face with an area";
    CHECK(refusal("") == empty);
    CHECK(refusal(kCorners) == empty);
    CHECK(refusal(kCorners + "f 1 1 1\n") == empty);
    CHECK(refusal("\x89PNG\r\n\x1A\n") == empty);
}

TEST_CASE("a scene around a mesh frames it") {
    // Two triangles that span the cube from (9, 9, 9) to (11, 11, 11): centre 10, radius sqrt 3.
    const std::string text = "v 9 9 9\nv 11 11 11\nv 11 9 9\nv 500 0 0\nf 1 2 3\n";
    for (const auto& [width, height] : {std::pair(640, 480), std::pair(300, 900)}) {
        const Scene scene = scene_around(read(text).mesh, "x", width, height);
        CHECK(scene.name == "x");
        CHECK(scene.camera.look_at == Point(10, 10, 10));
        CHECK(scene.camera.width == width);
        CHECK(scene.lights.size() == 1);
        CHECK(scene.materials.size() == 1);
        CHECK(scene.objects[0].name == "mesh0");
        const double distance = length(scene.camera.eye - scene.camera.look_at);
        const double outline = std::tan(std::asin(std::sqrt(3.0) / distance));
        const double half_width = std::tan(std::get<HorizontalFov>(scene.camera.window).degrees /
                                           2 * 3.14159265358979 / 180);
        const double half_smaller = half_width * std::min(1.0, double(height) / width);
        CHECK(outline / half_smaller == doctest::Approx(0.85));
    }
}

}  // namespace
}  // namespace raytree
