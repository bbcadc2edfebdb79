#include "scene/validate.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/planarity.h"

namespace raytree {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Object named(std::string name, Shape shape) {
    Object object;
    object.name = std::move(name);
    object.shape = std::move(shape);
    return object;
}

/// One light, one material and one object of the given shape.
Scene scene_with(Shape shape) {
    Scene scene;
    scene.materials.emplace_back().name = "matt";
    scene.lights.emplace_back().name = "key";
    scene.objects.push_back(named("thing", std::move(shape)));
    return scene;
}

Scene good() { return scene_with(Sphere{}); }

/// The only mistake's "place: text"; all of them where there are more.
std::string verdict(const Scene& scene) {
    std::string text;
    for (const Mistake& mistake : validate(scene)) {
        CHECK(mistake.file.empty());
        text += (text.empty() ? "" : "\n") + mistake.message();
    }
    return text;
}

template <class Change> std::string verdict_after(Change change) {
    Scene scene = good();
    change(scene);
    return verdict(scene);
}

std::string verdict_of(Shape shape) { return verdict(scene_with(std::move(shape))); }

bool begins(const std::string& text, const std::string& with) { return text.starts_with(with); }

TEST_CASE("a good scene has no mistakes") { CHECK(verdict(good()) == ""); }

TEST_CASE("the camera's ranges") {
    const auto camera = [](auto change) {
        return verdict_after([&](Scene& scene) { change(scene.camera); });
    };
    CHECK(camera([](Camera& c) { c.look_at = c.eye; }) ==
          "/camera: eye and look_at are the same point; they must differ");
    CHECK(camera([](Camera& c) {
              c.up = {0, 0, -3};
          }) == "/camera: up is parallel to the view from eye to look_at; it must not be");
    CHECK(camera([](Camera& c) { c.up = {0, 1e-6, 1}; }) == "");
    CHECK(begins(camera([](Camera& c) { c.up = {0, 0, 0}; }), "/camera/up: found a vector of len"));
    CHECK(begins(camera([](Camera& c) { c.eye.x = kNan; }), "/camera/eye: must be three finite"));
    CHECK(camera([](Camera& c) { c.eye.x = 1e300; }) == "");
    CHECK(begins(camera([](Camera& c) {
                     c.eye.x = 1.5e308;
                     c.look_at.x = -1.5e308;
                 }),
                 "/camera: eye and look_at are too far apart"));
    CHECK(begins(camera([](Camera& c) { c.near = -1; }), "/camera/near: found -1"));
    CHECK(begins(camera([](Camera& c) { c.near = kInfinity; }), "/camera/near: found inf"));
    CHECK(begins(camera([](Camera& c) { c.window = HorizontalFov{0}; }),
                 "/camera/horizontal_fov_degrees: found 0, must be over 0 and under 180"));
    CHECK(begins(camera([](Camera& c) { c.window = HorizontalFov{kNan}; }),
                 "/camera/horizontal_fov_degrees: found nan"));
    CHECK(begins(camera([](Camera& c) {
                     c.window = ImagePlane{1, 1, 0, 1};
                 }),
                 "/camera/image_plane: found [1, 1, 0, 1]"));
    CHECK(begins(camera([](Camera& c) {
                     c.window = ImagePlane{0, kInfinity, 0, 1};
                 }),
                 "/camera/image_plane: found [0, inf, 0, 1]"));
}

TEST_CASE("the picture's size") {
    const auto size = [](int width, int height) {
        return verdict_after([&](Scene& scene) {
            scene.camera.width = width;
            scene.camera.height = height;
        });
    };
    CHECK(size(65535, 4096) == "");   // 2^28 - 4096
    CHECK(size(16384, 16384) == "");  // 2^28
    CHECK(begins(size(16385, 16384), "/camera: width times height is 268451840 pixels; at most"));
    CHECK(begins(size(0, 5), "/camera/width: found 0, must be a whole number from 1 to 65535"));
    CHECK(begins(size(5, 65536), "/camera/height: found 65536"));
}

TEST_CASE("the settings' ranges") {
    const auto settings = [](auto change) {
        return verdict_after([&](Scene& scene) { change(scene.settings); });
    };
    CHECK(begins(settings([](Settings& s) { s.max_depth = 65; }), "/settings/max_depth: found 65"));
    CHECK(begins(settings([](Settings& s) { s.max_depth = 0; }), "/settings/max_depth: found 0"));
    CHECK(begins(settings([](Settings& s) { s.min_weight = kNan; }), "/settings/min_weight: "));
    CHECK(begins(settings([](Settings& s) { s.max_distance = -1; }), "/settings/max_distance: "));
    CHECK(begins(settings([](Settings& s) { s.ray_budget = 0; }), "/settings/ray_budget: "));
    CHECK(begins(settings([](Settings& s) {
                     s.attenuation = {0, 0, 0};
                 }),
                 "/settings/attenuation: found [0, 0, 0]"));
    CHECK(settings([](Settings& s) { s.attenuation = {0, 0, 1}; }) == "");
    CHECK(begins(settings([](Settings& s) { s.secondary_background = Colour(kNan); }),
                 "/settings/secondary_background: "));
    CHECK(begins(verdict_after([](Scene& s) { s.background.g = kInfinity; }), "/background: "));
    CHECK(begins(verdict_after([](Scene& s) { s.ambient.b = kNan; }), "/ambient: "));
}

TEST_CASE("a material's ranges, by its name or by its object") {
    const auto material = [](auto change) {
        return verdict_after([&](Scene& scene) { change(scene.materials[0]); });
    };
    CHECK(begins(material([](Material& m) { m.kr.g = -1; }), "/materials/matt/kr: found -1"));
    CHECK(begins(material([](Material& m) { m.kt.b = kInfinity; }), "/materials/matt/kt: found"));
    CHECK(begins(material([](Material& m) { m.ior = 0; }), "/materials/matt/ior: found 0"));
    CHECK(begins(material([](Material& m) { m.shininess = -1; }), "/materials/matt/shininess: "));
    CHECK(begins(material([](Material& m) { m.color.r = kNan; }), "/materials/matt/color: "));
    CHECK(begins(material([](Material& m) {
                     m.in_place = true;
                     m.ior = -1;
                 }),
                 "/objects/0/material/ior: found -1"));
    CHECK(begins(material([](Material& m) {
                     m.name = "a/b";
                     m.ior = -1;
                 }),
                 "/materials/a~1b/ior"));
    CHECK(begins(verdict_after([](Scene& s) { s.objects[0].material = 1; }),
                 "/objects/0/material: is missing"));
    CHECK(begins(verdict_after([](Scene& s) { s.materials.push_back(s.materials[0]); }),
                 "/materials/matt: the name \"matt\" is given to two materials"));
}

TEST_CASE("a light's ranges") {
    const auto light = [](auto change) {
        return verdict_after([&](Scene& scene) { change(scene.lights[0]); });
    };
    CHECK(begins(light([](Light& l) { l.intensity.r = kNan; }), "/lights/0/intensity: "));
    CHECK(begins(light([](Light& l) {
                     l.kind = DirectionalLight{{0, 0, 0}};
                 }),
                 "/lights/0/direction: found a vector of length 0"));
    CHECK(begins(light([](Light& l) {
                     l.kind = PointLight{{0, kNan, 0}, {}};
                 }),
                 "/lights/0/position: "));
    CHECK(begins(light([](Light& l) {
                     l.kind = PointLight{{0, 0, 0}, {0, -1, 0}};
                 }),
                 "/lights/0/attenuation: found [0, -1, 0]"));
}

TEST_CASE("names are unique within lights and within objects") {
    CHECK(begins(verdict_after([](Scene& s) { s.lights.push_back(s.lights[0]); }),
                 "/lights/1/name: the name \"key\" is that of /lights/0 already"));
    CHECK(begins(verdict_after([](Scene& s) { s.objects.push_back(s.objects[0]); }),
                 "/objects/1/name: the name \"thing\" is that of /objects/0 already"));
    CHECK(verdict_after([](Scene& s) { s.lights[0].name = s.objects[0].name; }) == "");
}

TEST_CASE("spheres and cones") {
    CHECK(begins(verdict_of(Sphere{{0, 0, 0}, 0}), "/objects/0/radius: found 0"));
    CHECK(begins(verdict_of(Sphere{{0, 0, 0}, kNan}), "/objects/0/radius: found nan"));
    CHECK(begins(verdict_of(Sphere{{0, kInfinity, 0}, 1}), "/objects/0/center: "));
    CHECK(verdict_of(Cone{{0, 0, 0}, {0, 1, 0}, 0, 1}) == "");
    CHECK(
        begins(verdict_of(Cone{{0, 0, 0}, {0, 1, 0}, 0, 0}), "/objects/0: base_radius and apex_"));
    CHECK(
        begins(verdict_of(Cone{{0, 1, 0}, {0, 1, 0}, 1, 0}), "/objects/0: base and apex are the"));
    CHECK(
        begins(verdict_of(Cone{{0, 0, 0}, {0, 1, 0}, -1, 1}), "/objects/0/base_radius: found -1"));
}

TEST_CASE("a polygon needs three vertices that span a plane") {
    CHECK(verdict_of(Polygon{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}}) == "");
    CHECK(begins(verdict_of(Polygon{{{0, 0, 0}, {1, 0, 0}}, {}}),
                 "/objects/0/vertices: found 2 vertices, must be 3 or more"));
    for (const std::vector<Point>& line :
         {std::vector<Point>{{0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0.7, 0.7, 0.7}},
          std::vector<Point>{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}},
          std::vector<Point>{{1000.1, 0, 0}, {1000.2, 0, 0}, {1000.7, 0, 0}, {1000.3, 0, 0}},
          std::vector<Point>{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}}) {  // a bow tie
        CHECK(begins(verdict_of(Polygon{line, {}}), "/objects/0/vertices: the vertices are coll"));
    }
    CHECK(begins(verdict_of(Polygon{{{0, 0, 0}, {kNan, 0, 0}, {0, 1, 0}}, {}}),
                 "/objects/0/vertices/1: must be three finite numbers"));
}

TEST_CASE("a small polygon far away is as good as one at the origin") {
    const Point far{1e6, -1e6, 1e6};
    const Polygon tile{
        {far, far + Point(1e-3, 0, 0), far + Point(1e-3, 1e-3, 0), far + Point(0, 1e-3, 0)}, {}};
    CHECK(verdict_of(tile) == "");
    CHECK(verdict_of(Polygon{{{0, 0, 0}, {1e200, 0, 0}, {0, 1e200, 0}}, {}}) == "");
    CHECK(verdict_of(Polygon{{{0, 0, 0}, {1e-200, 0, 0}, {0, 1e-200, 0}}, {}}) == "");
}

TEST_CASE("a vertex may be off the plane by a millionth of the extent") {
    // Lifting one corner of the unit square by h puts every corner h / 4 off the plane through the
    // mean; the extent is the diagonal, sqrt 2.
    const auto square = [](double h) {
        return Polygon{{{0, 0, 0}, {1, 0, 0}, {1, 1, h}, {0, 1, 0}}, {}};
    };
    CHECK(planarity_of(square(0.01).vertices).off_plane ==
          doctest::Approx(0.01 / 4 / std::sqrt(2)).epsilon(1e-4));
    CHECK(verdict_of(square(4e-6 * std::sqrt(2) * 0.99)) == "");
    CHECK(begins(verdict_of(square(4e-6 * std::sqrt(2) * 1.01)),
                 "/objects/0/vertices: the vertices are not planar"));
}

TEST_CASE("vertex normals are one for each vertex and have a length") {
    const std::vector<Point> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    CHECK(verdict_of(Polygon{vertices, {{0, 0, 1}, {0, 0, 5}, {1, 1, 1}}}) == "");
    CHECK(begins(verdict_of(Polygon{vertices, {{0, 0, 1}, {0, 0, 1}}}),
                 "/objects/0/normals: found 2 normals for 3 vertices"));
    CHECK(begins(verdict_of(Polygon{vertices, {{0, 0, 1}, {0, 0, 0}, {0, 0, 1}}}),
                 "/objects/0/normals/1: found a vector of length 0"));
}

TEST_CASE("a mesh's triangles refer to what is there") {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals = {{0, 0, 1}};
    mesh.triangles.push_back({Mesh::Corner{0, 0}, Mesh::Corner{1, 0}, Mesh::Corner{2, -1}});
    CHECK(verdict_of(mesh) == "");
    Mesh bad = mesh;
    bad.triangles[0][1].vertex = 3;
    CHECK(
        begins(verdict_of(bad), "/objects/0/file: triangle 0 of the mesh has a vertex or normal"));
    bad = mesh;
    bad.triangles[0][1].normal = 1;
    CHECK(begins(verdict_of(bad), "/objects/0/file: triangle 0"));
    bad = mesh;
    bad.vertices[0].x = kNan;
    CHECK(begins(verdict_of(bad), "/objects/0/file: "));
    bad.triangles.clear();
    bad.vertices[0].x = 0;
    CHECK(begins(verdict_of(bad), "/objects/0/file: the mesh has no triangle"));
}

TEST_CASE("a transform is invertible") {
    const auto transform = [](const Affine& m) {
        return verdict_after([&](Scene& scene) { scene.objects[0].transform = m; });
    };
    CHECK(transform(Affine{{{1, 0, 0, 5}, {0, -2, 0, 6}, {0, 0, 1e-3, 7}}}) == "");
    CHECK(transform(Affine{{{1, 0, 0, 0}, {0, 1e9, 0, 0}, {0, 0, 1e-9, 0}}}) == "");
    CHECK(transform(Affine{{{1, 1e6, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}}) == "");
    CHECK(begins(transform(Affine{{{0, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}}),
                 "/objects/0/transform: is singular"));
    CHECK(begins(transform(Affine{{{0.1, 0.2, 0.3, 0}, {0.7, 1.4, 2.1, 0}, {0, 1, 1, 0}}}),
                 "/objects/0/transform: is singular"));
    CHECK(begins(transform(Affine{{{1, 0, 0, 0}, {0, 1e-320, 0, 0}, {0, 0, 1, 0}}}),
                 "/objects/0/transform: is singular"));
    CHECK(begins(transform(Affine{{{1, 0, 0, kNan}, {0, 1, 0, 0}, {0, 0, 1, 0}}}),
                 "/objects/0/transform: must be finite"));
}

TEST_CASE("many mistakes end after a readable number") {
    Scene scene = good();
    for (int k = 0; k < 1000; ++k) {
        scene.objects.push_back(named("s" + std::to_string(k), Sphere{{0, 0, 0}, 0}));
    }
    const auto mistakes = validate(scene);
    CHECK(mistakes.size() == 51);
    CHECK(mistakes.back().text == "and 950 more mistakes");
}

}  // namespace
}  // namespace raytree
