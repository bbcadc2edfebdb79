#include "support/standard.h"

#include <cmath>
#include <filesystem>
#include <numbers>
#include <stdexcept>

#include "formats/scene_file.h"
#include "support/generate.h"

namespace raytree::bench {
namespace {

constexpr double pi = std::numbers::pi;

void add(Scene& scene, Shape shape, std::size_t material) {
    scene.objects.push_back(
        {"object" + std::to_string(scene.objects.size()), material, {}, std::move(shape)});
}

std::size_t add_material(Scene& scene, const Colour& color, double kd, double ks, double kt,
                         double ior = 1) {
    Material material;
    material.name = "material" + std::to_string(scene.materials.size());
    material.color = color;
    material.kd = Colour(kd);
    material.ks = Colour(ks);
    material.kr = Colour(ks);
    material.kt = Colour(kt);
    material.shininess = ks > 0 ? 10 : 1;
    material.ior = ior;
    scene.materials.push_back(material);
    return scene.materials.size() - 1;
}

/// Background, camera and lights; no object.
Scene setting(const std::string& name, const Point& eye, const std::vector<Point>& lights) {
    Scene scene;
    scene.name = name;
    scene.background = Colour(0.078, 0.361, 0.753);
    scene.camera.eye = eye;
    scene.camera.look_at = {0, 0, 0};
    scene.camera.up = {0, 0, 1};
    scene.camera.window = HorizontalFov{45};
    scene.camera.width = scene.camera.height = 512;
    scene.settings.max_depth = 5;
    scene.settings.min_weight = 0;
    for (const Point& light : lights) {
        scene.lights.push_back({"light" + std::to_string(scene.lights.size()),
                                Colour(1 / std::sqrt(static_cast<double>(lights.size()))),
                                PointLight{light, {}}});
    }
    return scene;
}

void add_floor(Scene& scene, double height) {
    const std::size_t material = add_material(scene, {1, 0.75, 0.33}, 0.8, 0, 0);
    add(scene,
        Polygon{{{12, 12, height}, {-12, 12, height}, {-12, -12, height}, {12, -12, height}}, {}},
        material);
}

/// The shapes of a generated scene, all of one material.
void add_shapes_of(Scene& scene, const std::string& name, std::size_t shapes,
                   std::size_t material) {
    for (Object& object : generate(name, shapes).objects) {
        add(scene, std::move(object.shape), material);
    }
}

const std::vector<Point> three_lights = {{4, 3, 2}, {1, -4, 4}, {-3, 1, 5}};

Scene balls() {
    Scene scene = setting("balls", {2.1, 1.3, 1.7}, three_lights);
    add_floor(scene, -0.6);
    add_shapes_of(scene, "balls", 7'381, add_material(scene, {1, 0.9, 0.7}, 0.5, 0.5, 0));
    return scene;
}

Scene gears() {
    Scene scene = setting("gears", {-2.4, -2.9, 2.4}, three_lights);
    add_floor(scene, -1.4);
    add_shapes_of(scene, "gears", 24'000, add_material(scene, {0.9, 0.9, 0.8}, 0.4, 0.3, 0.3, 1.1));
    return scene;
}

Scene rings() {
    Scene scene = setting("rings", {-2.6, -2.4, 1.8}, three_lights);
    add_floor(scene, -1.4);
    add_shapes_of(scene, "rings", 8'400, add_material(scene, {0.9, 0.6, 0.3}, 0.5, 0.4, 0));
    return scene;
}

Scene mount() {
    Scene scene = setting("mount", {-1.6, 1.6, 1.7}, {{-100, -100, 100}});
    const std::size_t glass = add_material(scene, {1, 1, 1}, 0.1, 0.1, 0.9, 1.5);
    for (int k = 0; k < 4; ++k) {
        const double a = k * 2 * pi / 3;
        const Point at = k == 3 ? Point(-0.8, 0.8, 1.2)
                                : Point(-0.8 + 0.16 * std::cos(a), 0.8 + 0.16 * std::sin(a), 0.93);
        add(scene, Sphere{at, 0.17}, glass);
    }
    add_shapes_of(scene, "terrain", 8'192, add_material(scene, {0.5, 0.45, 0.35}, 1, 0, 0));
    return scene;
}

void add_tetrahedra(Mesh& mesh, const Point& center, double size, int depth) {
    const Point corner[4] = {{1, 1, 1}, {-1, -1, 1}, {1, -1, -1}, {-1, 1, -1}};
    if (depth > 0) {
        for (const Point& c : corner) {
            add_tetrahedra(mesh, center + 0.5 * size * c, 0.5 * size, depth - 1);
        }
        return;
    }
    const int first = static_cast<int>(mesh.vertices.size());
    for (const Point& c : corner) {
        mesh.vertices.push_back(center + size * c);
    }
    const int faces[4][3] = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
    for (const auto& f : faces) {
        mesh.triangles.push_back({{{first + f[0]}, {first + f[1]}, {first + f[2]}}});
    }
}

Scene tetra() {
    Scene scene = setting("tetra", {1.02, 1.55, 1.88}, {{1.9, 0.7, 1.4}});
    Mesh mesh;
    mesh.file = "generated";
    add_tetrahedra(mesh, {0, 0, 0}, 0.55, 5);
    add(scene, mesh, add_material(scene, {1, 0.2, 0.2}, 1, 0, 0));
    return scene;
}

/// A branch with a ball at its end, and two that go on from there.
void add_branches(Scene& scene, const Point& base, const Point& up, const Point& side,
                  double length, int depth, std::size_t material) {
    const Point end = base + length * up;
    add(scene, Cone{base, end, 0.08 * length, 0.055 * length}, material);
    add(scene, Sphere{end, 0.055 * length}, material);
    if (depth == 0) {
        return;
    }
    const Point across = outer(up, side);
    for (const double sign : {1.0, -1.0}) {
        const Point next =
            UnitVec3<double>::of(std::cos(0.6) * up + sign * std::sin(0.6) * side).vec();
        const Point turned = UnitVec3<double>::of(across + 0.2 * side).vec();
        const Point aside = UnitVec3<double>::of(turned - inner(turned, next) * next).vec();
        add_branches(scene, end, next, aside, 0.76 * length, depth - 1, material);
    }
}

Scene tree() {
    Scene scene =
        setting("tree", {4.5, 0.4, 2},
                {{4, 3, 3}, {1, -4, 4}, {-3, 1, 5}, {3, 3, 3}, {-2, -2, 4}, {0, 5, 3}, {5, 0, 4}});
    add_floor(scene, -1.2);
    add_branches(scene, {0, 0, -1.2}, {0, 0, 1}, {1, 0, 0}, 0.8, 11,
                 add_material(scene, {0.55, 0.4, 0.2}, 1, 0, 0));
    return scene;
}

}  // namespace

const std::vector<std::string>& standard_names() {
    static const std::vector<std::string> names = {"balls", "gears", "mount",
                                                   "rings", "tetra", "tree"};
    return names;
}

Scene standard_scene(const std::string& name, const std::string& folder) {
    const std::filesystem::path file = std::filesystem::path(folder) / "nff" / (name + ".nff");
    if (std::filesystem::exists(file)) {
        return load_scene(file).scene;
    }
    return name == "balls"   ? balls()
           : name == "gears" ? gears()
           : name == "mount" ? mount()
           : name == "rings" ? rings()
           : name == "tetra" ? tetra()
           : name == "tree"
               ? tree()
               : throw std::invalid_argument("there is no standard scene \"" + name + '"');
}

}  // namespace raytree::bench
