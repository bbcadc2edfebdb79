#include "bodies.h"
#include "tree_comparison.h"

namespace raytree::stress {
namespace {

constexpr int picture = 8;

Polygon jagged(Random& random, const Point& center, double size) {
    const Vec3<double> n = random.direction();
    const Vec3<double> u = random.across(n);
    const Vec3<double> v = outer(n, u);
    Polygon polygon;
    const int corners = 3 + static_cast<int>(random.below(6));
    for (int k = 0; k < corners; ++k) {
        const double angle = 2 * Real<double>::pi * k / corners;
        const double radius = size * random.log_uniform(0.1, 1);
        polygon.vertices.push_back(center + radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
    return polygon;
}

/// A shape of any kind about a point, its transform included.
void add_shape(Random& random, Scene& scene, const Point& center, double size) {
    const bool transformed = random.chance(0.3);
    const Point at = transformed ? random.in_cube() : center;
    const double own_size = transformed ? 1 : size;
    const std::size_t kind = random.below(4);
    if (kind == 0) {
        add(scene, Sphere{at, own_size});
    } else if (kind == 1) {
        add(scene, jagged(random, at, own_size));
    } else if (kind == 2) {
        const Vec3<double> axis = own_size * random.direction().vec();
        const double radius = own_size * random.log_uniform(0.05, 1);
        add(scene, Cone{at - axis, at + axis, radius,
                        random.chance(0.3) ? radius : radius * random.uniform(0, 1)});
    } else {
        add(scene, rough_ball(random, at, own_size, static_cast<int>(random.below(2)), 0.2));
    }
    if (transformed) {
        scene.objects.back().transform = stretched(random, size, 3, center);
    }
}

/// Two shapes beside each other, of mirrors or glass, small or large, near the origin or far from
/// it, seen from near or far.
Scene make_scene(Random& random) {
    Scene scene;
    const double size = random.log_uniform(1e-9, 1e9);
    const Point center = random.chance(0.4)
                             ? Point(0, 0, 0)
                             : size * random.log_uniform(1, 1e8) * random.direction().vec();
    for (int k = 0; k < 2; ++k) {
        add_shape(random, scene, center + 1.5 * size * random.in_cube(), size);
    }
    Material& material = scene.materials[0];
    material.ks = Colour(0.5);
    (random.chance(0.5) ? material.kr : material.kt) = Colour(0.7);
    material.ior = random.uniform(1, 2);
    Light light;
    light.name = "light";
    light.kind = PointLight{center + 20 * size * random.direction().vec(), {}};
    scene.lights.push_back(light);
    scene.camera.eye = center + size * random.log_uniform(2.5, 1e6) * random.direction().vec();
    scene.camera.look_at = center + 0.5 * size * random.in_cube();
    const Vec3<double> view = scene.camera.look_at - scene.camera.eye;
    scene.camera.up = random.across(UnitVec3<double>::of(view));
    scene.camera.window =
        HorizontalFov{2 * 180 / Real<double>::pi * std::atan(size / length(view))};
    scene.camera.width = scene.camera.height = picture;
    scene.settings.max_depth = 5;
    return scene;
}

Tally run(Random& random, std::uint64_t trials) {
    Tally tally;
    while (tally.trials < trials) {
        const Scene scene = make_scene(random);
        const World<double> own(scene);
        const World<Quad> reference(scene);
        for (int k = 0; k < picture && tally.trials < trials; ++k, ++tally.trials) {
            const int i = static_cast<int>(random.below(picture));
            const int j = static_cast<int>(random.below(picture));
            try_tree(own, reference, i, j, tally, [&](std::ostream& out) {
                out << "shapes " << scene.objects[0].shape.index() << " and "
                    << scene.objects[1].shape.index() << " seen from " << scene.camera.eye;
            });
        }
    }
    return tally;
}

}  // namespace

Row bounds() {
    Row row{"bounds",
            "trees of two shapes of any kinds, mirrors or glass, of size 10^-9 to 10^9, up to 10^8 "
            "sizes from the origin, seen from up to 10^6 sizes away",
            "trees",
            "the same shape as in the reference arithmetic, or marked as undecided there; every "
            "number within its bound",
            "its bound",
            400,
            1'000'000,
            80,
            run};
    row.in_float = false;
    return row;
}

}  // namespace raytree::stress
