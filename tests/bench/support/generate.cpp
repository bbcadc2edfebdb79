#include "support/generate.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "scene/plan.h"
#include "trace/camera_rays.h"

namespace raytree::bench {
namespace {

constexpr double pi = std::numbers::pi;

Point to_float(const Point& p) { return vector_cast<double>(vector_cast<float>(p)); }

/// Fixed numbers of [-1, 1], the same with every standard library.
class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-52 - 1; }
    Point in_ball() {
        for (;;) {
            const Point p((*this)(), (*this)(), (*this)());
            if (const double square = inner(p, p); square <= 1 && square > 1e-6) {
                return p;
            }
        }
    }

  private:
    std::mt19937_64 engine_;
};

Scene empty_scene(const std::string& name, const Point& eye, const Point& look_at,
                  const Point& light) {
    Scene scene;
    scene.name = name;
    scene.camera.eye = to_float(eye);
    scene.camera.look_at = to_float(look_at);
    scene.camera.up = {0, 0, 1};
    scene.camera.window = HorizontalFov{60};
    scene.camera.width = scene.camera.height = 512;
    Material material;
    material.name = "plain";
    scene.materials.push_back(material);
    scene.lights.push_back({"light", Colour(1.0), PointLight{to_float(light), {}}});
    return scene;
}

Object object_of(Shape shape, std::size_t number) {
    return {"object" + std::to_string(number), 0, {}, std::move(shape)};
}

/// Triangles that share vertices by their numbers.
class MeshMaker {
  public:
    int vertex(const Point& p) {
        mesh_.vertices.push_back(to_float(p));
        return static_cast<int>(mesh_.vertices.size()) - 1;
    }
    void triangle(int a, int b, int c) { mesh_.triangles.push_back({{{a}, {b}, {c}}}); }
    void quad(int a, int b, int c, int d) {
        triangle(a, b, c);
        triangle(a, c, d);
    }
    /// `at(u, v)`, 0 <= u, v <= 1, in `columns * rows` quads.
    template <class At> void patch(int columns, int rows, At&& at) {
        const int first = static_cast<int>(mesh_.vertices.size());
        for (int j = 0; j <= rows; ++j) {
            for (int i = 0; i <= columns; ++i) {
                vertex(at(static_cast<double>(i) / columns, static_cast<double>(j) / rows));
            }
        }
        for (int j = 0; j < rows; ++j) {
            for (int i = 0; i < columns; ++i) {
                const int corner = first + j * (columns + 1) + i;
                quad(corner, corner + 1, corner + columns + 2, corner + columns + 1);
            }
        }
    }
    Mesh take() {
        mesh_.file = "generated";
        return std::move(mesh_);
    }

  private:
    Mesh mesh_;
};

int side_of(double quads) { return std::max(1, static_cast<int>(std::lround(std::sqrt(quads)))); }

Scene terrain(std::size_t shapes) {
    Scene scene = empty_scene("terrain", {-0.3, -0.9, 0.75}, {0.1, 0.1, 0}, {0.6, -0.5, 2});
    MeshMaker mesh;
    const int side = side_of(static_cast<double>(shapes) / 2);
    mesh.patch(side, side, [](double u, double v) {
        const double x = 2 * u - 1, y = 2 * v - 1;
        double z = 0, size = 0.12, frequency = 3;
        for (int octave = 0; octave < 7; ++octave, size *= 0.5, frequency *= 2.03) {
            z += size * std::sin(frequency * x + 1.7 * octave) *
                 std::cos(frequency * (y + 0.3 * x) + octave);
        }
        return Point(x, y, z);
    });
    scene.objects.push_back(object_of(mesh.take(), 0));
    return scene;
}

/// A hall with two rows of columns, arches over them, and curtains between: a few large walls,
/// many small triangles.
Scene atrium(std::size_t shapes) {
    Scene scene = empty_scene("atrium", {-2.6, -0.25, 0.7}, {1, 0.15, 0.6}, {0.5, 0.2, 1.7});
    MeshMaker mesh;
    const Point box[8] = {{-3, -1.5, 0}, {3, -1.5, 0}, {3, 1.5, 0}, {-3, 1.5, 0},
                          {-3, -1.5, 2}, {3, -1.5, 2}, {3, 1.5, 2}, {-3, 1.5, 2}};
    int v[8];
    std::transform(std::begin(box), std::end(box), v,
                   [&](const Point& p) { return mesh.vertex(p); });
    mesh.quad(v[0], v[1], v[2], v[3]);
    mesh.quad(v[4], v[7], v[6], v[5]);
    mesh.quad(v[0], v[4], v[5], v[1]);
    mesh.quad(v[2], v[6], v[7], v[3]);
    mesh.quad(v[0], v[3], v[7], v[4]);
    mesh.quad(v[1], v[5], v[6], v[2]);
    const int columns = 9;
    const int side = side_of(static_cast<double>(shapes) / (2.0 * 2 * columns * 3));
    for (int k = 0; k < 2 * columns; ++k) {
        const double x = -2.4 + 0.6 * (k / 2), y = k % 2 == 0 ? -0.8 : 0.8;
        mesh.patch(side, side, [&](double s, double t) {  // a fluted column
            const double r =
                0.09 + 0.015 * std::cos(12 * 2 * pi * s) + 0.05 * std::pow(2 * t - 1, 8);
            return Point(x + r * std::cos(2 * pi * s), y + r * std::sin(2 * pi * s), 1.2 * t);
        });
        mesh.patch(side, side, [&](double s, double t) {  // an arch to the next
            const double a = pi * s, b = 2 * pi * t;
            const double out = 0.3 + 0.05 * std::cos(b);
            return Point(x + 0.3 - out * std::cos(a), y + 0.08 * std::sin(b),
                         1.2 + out * std::sin(a));
        });
        mesh.patch(side, side, [&](double s, double t) {  // a curtain behind it
            const double wave = 0.06 * std::sin(30 * s + k) * (1.2 - t);
            return Point(x + 0.5 * s, (y < 0 ? -1.2 : 1.2) + wave, 0.2 + 1.3 * t);
        });
    }
    scene.objects.push_back(object_of(mesh.take(), 0));
    return scene;
}

/// Gears of long thin triangles in a lattice.
Scene gears(std::size_t shapes) {
    Scene scene = empty_scene("gears", {-2.1, -2.6, 2.2}, {0, 0, -0.2}, {-2, -3, 4});
    constexpr int teeth = 36;
    constexpr std::size_t triangles = 4 * teeth * 6;  // a gear
    MeshMaker mesh;
    const int side = std::max(
        1, static_cast<int>(std::lround(std::cbrt(static_cast<double>(shapes) / triangles))));
    const double radius = 1.0 / side;
    const int points = 4 * teeth;
    for (int k = 0; k < side * side * side; ++k) {
        const Point center = 2.1 * radius * Point(k % side, k / side % side, k / side / side) -
                             1.05 * Point(1 - radius);
        const double turn = k * 0.7;
        int rim[2][4 * teeth], hub[2][4 * teeth];
        for (int face = 0; face < 2; ++face) {
            for (int i = 0; i < points; ++i) {
                const double r = radius * (i % 4 < 2 ? 1.0 : 0.85), a = 2 * pi * i / points + turn;
                const Point out(std::cos(a), std::sin(a), 0);
                const Point up(0, 0, radius * (face == 0 ? -0.3 : 0.3));
                rim[face][i] = mesh.vertex(center + r * out + up);
                hub[face][i] = mesh.vertex(center + 0.3 * radius * out + up);
            }
        }
        for (int i = 0; i < points; ++i) {
            const int j = (i + 1) % points;
            mesh.quad(rim[0][i], rim[0][j], rim[1][j], rim[1][i]);
            mesh.triangle(rim[0][i], hub[0][i], rim[0][j]);
            mesh.triangle(hub[0][i], hub[0][j], rim[0][j]);
            mesh.triangle(rim[1][i], rim[1][j], hub[1][i]);
            mesh.triangle(hub[1][i], rim[1][j], hub[1][j]);
        }
    }
    scene.objects.push_back(object_of(mesh.take(), 0));
    return scene;
}

void add_sphere(Scene& scene, const Point& center, double radius) {
    scene.objects.push_back(
        object_of(Sphere{to_float(center), static_cast<float>(radius)}, scene.objects.size()));
}

/// A sphere with nine of a third of its radius around it, and so on.
void add_flake(Scene& scene, const Point& center, double radius, const Point& axis, int depth) {
    add_sphere(scene, center, radius);
    if (depth == 0) {
        return;
    }
    const auto up = UnitVec3<double>::of(axis);
    const auto u = UnitVec3<double>::of(
        outer(up.vec(), std::abs(up.vec().x) < 0.5 ? Point(1, 0, 0) : Point(0, 1, 0)));
    const Point v = outer(up.vec(), u.vec());
    for (int k = 0; k < 9; ++k) {
        const bool upper = k >= 6;
        const double a = 2 * pi * (upper ? k - 5.5 : k) / (upper ? 3 : 6);
        const double height = upper ? 0.8 : 0.1, across = std::sqrt(1 - height * height);
        const Point out = across * (std::cos(a) * u.vec() + std::sin(a) * v) + height * up.vec();
        add_flake(scene, center + radius * (4.0 / 3) * out, radius / 3, out, depth - 1);
    }
}

Scene balls(std::size_t shapes) {
    Scene scene = empty_scene("balls", {2.1, 1.3, 1.7}, {0, 0, 0.1}, {4, 3, 5});
    int depth = 0;
    for (double all = 1; all * 9.5 < 2.2 * static_cast<double>(shapes); all = 9 * all + 1) {
        ++depth;
    }
    add_flake(scene, {0, 0, 0}, 0.55, {0.1, 0.2, 1}, depth);
    return scene;
}

/// A lattice of rings, each of spheres joined by cylinders.
Scene rings(std::size_t shapes) {
    Scene scene = empty_scene("rings", {-2.4, -2.2, 1.6}, {0, 0, 0}, {-3, -1, 5});
    constexpr int joints = 10;
    const int side = std::max(
        1, static_cast<int>(std::lround(std::cbrt(static_cast<double>(shapes) / (2 * joints)))));
    const double size = 1.0 / side;
    for (int k = 0; k < side * side * side; ++k) {
        const Point center =
            2 * size * Point(k % side, k / side % side, k / side / side) - Point(1 - size);
        const double tilt = 0.9 * k;
        const Point u(std::cos(tilt), std::sin(tilt), 0), v(-0.5 * u.y, 0.5 * u.x, 0.8);
        const auto joint = [&](int i) {
            const double a = 2 * pi * i / joints;
            return to_float(center + 1.1 * size * (std::cos(a) * u + std::sin(a) * v));
        };
        for (int i = 0; i < joints; ++i) {
            add_sphere(scene, joint(i), 0.12 * size);
            const auto r = static_cast<double>(static_cast<float>(0.07 * size));
            scene.objects.push_back(
                object_of(Cone{joint(i), joint(i + 1), r, r}, scene.objects.size()));
        }
    }
    return scene;
}

Ray<double> float_ray(const Point& origin, const Point& direction) {
    return {to_float(origin), to_float(UnitVec3<double>::of(direction)), 0};
}

std::vector<Query<double>> camera_rays(const Scene& scene, std::size_t count) {
    Camera camera = scene.camera;
    camera.width = camera.height =
        4 * std::max(1, static_cast<int>(std::sqrt(static_cast<double>(count)) / 4));
    const CameraRays<double> rays(camera, PixelSample::center);
    std::vector<Query<double>> queries;
    for (int tile_j = 0; tile_j < camera.height; tile_j += 4) {
        for (int tile_i = 0; tile_i < camera.width; tile_i += 4) {
            for (int k = 0; k < 16; ++k) {
                const Ray<double> ray = rays.primary(tile_i + k % 4, tile_j + k / 4);
                queries.push_back({float_ray(ray.origin, ray.direction), no_primitive, {}});
            }
        }
    }
    return queries;
}

Box box_of(const Intersector<double>& shapes) {
    Box box;
    for (PrimitiveId id = 0; id < shapes.shapes().size(); ++id) {
        box.include(shapes.shapes().bounds(id));
    }
    return box;
}

}  // namespace

const std::vector<std::string>& generated_names() {
    static const std::vector<std::string> names = {"terrain", "atrium", "gears", "balls", "rings"};
    return names;
}

Scene generate(const std::string& name, std::size_t shapes) {
    if (name == "terrain") {
        return terrain(shapes);
    }
    if (name == "atrium") {
        return atrium(shapes);
    }
    if (name == "gears") {
        return gears(shapes);
    }
    if (name == "balls") {
        return balls(shapes);
    }
    if (name == "rings") {
        return rings(shapes);
    }
    throw std::invalid_argument("there is no generated scene \"" + name + '"');
}

std::size_t shape_count(const Scene& scene) { return plan_of(scene).shapes(); }

std::string name_of(RayOrder order) {
    return order == RayOrder::coherent  ? "coherent"
           : order == RayOrder::diffuse ? "diffuse"
                                        : "random";
}

std::vector<Query<double>> make_rays(const Scene& scene, const Intersector<double>& shapes,
                                     RayOrder order, bool any, std::size_t count) {
    Random random(7);
    NoTestCount tests;
    if (order == RayOrder::random) {
        const Box box = box_of(shapes);
        const auto point = [&] {
            return Point(box.center() + 0.5 * box.size() * Point(random(), random(), random()));
        };
        std::vector<Query<double>> queries(count);
        for (Query<double>& query : queries) {
            const Point from = point(), to = point();
            query.ray = float_ray(from, to - from);
            if (any) {
                query.interval.to = static_cast<float>(length<double>(to - from));
            }
        }
        return queries;
    }
    std::vector<Query<double>> queries = camera_rays(scene, count);
    if (order == RayOrder::coherent && !any) {
        return queries;
    }
    const Point light = std::get<PointLight>(scene.lights.at(0).kind).position;
    std::vector<Query<double>> next;
    for (const Query<double>& query : queries) {
        const auto hit = shapes.closest(query.ray, no_primitive, {}, tests);
        if (!hit) {
            continue;
        }
        const auto surface = shapes.shapes().surface_at(hit->primitive, query.ray, hit->t);
        const bool front = inner(surface.geometric_normal, query.ray.direction) < 0;
        const Point n = front ? surface.geometric_normal.vec() : -surface.geometric_normal.vec();
        Point towards = light - surface.point;
        if (order == RayOrder::diffuse) {
            towards = n + UnitVec3<double>::of(random.in_ball()).vec();
        } else if (inner(n, towards) <= 0) {
            continue;
        }
        Ray<double> ray = float_ray(surface.point + 1e-5 * n, towards);
        Interval<double> interval;
        if (any) {
            interval.to = order == RayOrder::coherent ? static_cast<float>(length(towards)) : 0.5F;
        }
        next.push_back({ray, no_primitive, interval});
    }
    if (order == RayOrder::diffuse) {  // any order: neighbours are not to be together
        for (std::size_t k = next.size(); k > 1; --k) {
            const auto other =
                static_cast<std::size_t>((random() + 1) / 2 * static_cast<double>(k));
            std::swap(next[k - 1], next[std::min(other, k - 1)]);
        }
    }
    return next;
}

}  // namespace raytree::bench
