#include "support/scenes.h"

#include <random>

namespace raytree::test {

Object& add(Scene& scene, Shape shape, std::size_t material) {
    Object object;
    object.name = "object" + std::to_string(scene.objects.size());
    object.material = material;
    object.shape = std::move(shape);
    return scene.objects.emplace_back(std::move(object));
}

std::size_t add_material(Scene& scene, Material material) {
    if (material.name.empty()) {
        material.name = "material" + std::to_string(scene.materials.size());
    }
    scene.materials.push_back(std::move(material));
    return scene.materials.size() - 1;
}

Scene random_shapes(int count, unsigned seed, double scale, const Point& center) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto point = [&](double size) {
        return size * Point(uniform(random), uniform(random), uniform(random));
    };
    Scene scene;
    scene.materials.push_back({});
    for (int k = 0; k < count; ++k) {
        const Point at = center + point(scale);
        const double size = 0.1 * scale * (1.1 + uniform(random));
        if (k % 4 == 0) {
            add(scene, Sphere{at, size});
        } else if (k % 4 == 1) {
            const Point u = point(size), v = point(size);
            add(scene, Polygon{{at, at + u, at + u + v, at + v}, {}});
        } else if (k % 4 == 2) {
            add(scene, Polygon{{at, at + point(size), at + point(size)}, {}});
        } else {
            add(scene, Cone{at, at + point(size), size / 2, size / 4});
        }
        if (k % 7 == 0) {
            scene.objects.back().transform = {
                {{1, 0.2, 0, 0.01 * scale}, {0, -1.5, 0.1, 0}, {0.3, 0, 0.7, 0.02 * scale}}};
        }
    }
    return scene;
}

Camera one_pixel_camera() {
    Camera camera;
    camera.eye = {0, 0, 5};
    camera.look_at = {0, 0, 0};
    camera.window = HorizontalFov{90};
    camera.width = 1;
    camera.height = 1;
    return camera;
}

}  // namespace raytree::test
