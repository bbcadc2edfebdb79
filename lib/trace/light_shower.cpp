#include "trace/light_shower.h"

#include <algorithm>
#include <cmath>

#include "scene/progress.h"
#include "trace/eye_space.h"
#include "trace/shading.h"

namespace raytree {
namespace {

constexpr double pi = Real<double>::pi;
const double golden = (1 + std::sqrt(5.0)) / 2;

struct Beam {
    Ray<double> ray;
    PrimitiveId leaving = no_primitive;
};

/// Two numbers from 0 to 1 for bounce `bounce` of ray `k`, evenly spread over all rays.
std::pair<double, double> spread(std::size_t k, int bounce) {
    constexpr double root = 1.32471795724474602596;  // of x^3 = x + 1
    const double n = static_cast<double>(k + 1);
    const double shift = 0.5 + 0.37 * bounce;
    const auto part = [](double x) { return x - std::floor(x); };
    return {part(shift + n / root), part(shift + n / (root * root))};
}

struct Frame {
    Vec3<double> x, y, z;
};
Frame frame_around(const Vec3<double>& z) {
    const Vec3<double> other = std::abs(z.x) < 0.5 ? Vec3<double>(1, 0, 0) : Vec3<double>(0, 1, 0);
    const Vec3<double> x = UnitVec3<double>::of(outer(other, z)).vec();
    return {x, outer(z, x), z};
}

Vec3<double> in_frame(const Frame& frame, double x, double y, double z) {
    return x * frame.x + y * frame.y + z * frame.z;
}

/// Evenly over the sphere.
Vec3<double> lattice_direction(std::size_t k, std::size_t count) {
    const double z = 1 - (2 * static_cast<double>(k) + 1) / static_cast<double>(count);
    const double turn = 2 * pi * static_cast<double>(k) / golden;
    const double radius = std::sqrt(std::max(0.0, 1 - z * z));
    return {radius * std::cos(turn), z, radius * std::sin(turn)};
}

class Shower {
  public:
    Shower(const World<double>& world, std::size_t light, const ShowerOptions& options)
        : world_(world),
          light_(world.lights[light]),
          options_(options),
          space_(world.scene().camera, world.scene().settings.pixel_sample) {
        for (std::size_t k = 0; k < world.shapes.shapes().size(); ++k) {
            bounds_.include(world.shapes.shapes().bounds(static_cast<PrimitiveId>(k)));
        }
        bounds_.include(world.scene().camera.eye);
        far_ = length(bounds_.size());
    }

    LightShower send() {
        result_.rays = options_.rays;
        ProgressCounter progress("following light");
        for (std::size_t k = 0; k < options_.rays; ++k) {
            progress.at(k, options_.rays);
            follow(k);
        }
        return std::move(result_);
    }

  private:
    Beam leaving_light(std::size_t k) const {
        if (!light_.directional) {
            return {{light_.position, lattice_direction(k, options_.rays), 0}, no_primitive};
        }
        const Frame frame = frame_around(Vec3<double>(-light_.towards));
        const double radius =
            0.5 * far_ *
            std::sqrt((static_cast<double>(k) + 0.5) / static_cast<double>(options_.rays));
        const double turn = 2 * pi * static_cast<double>(k) / golden;
        const Vec3<double> start =
            bounds_.center() + far_ * light_.towards +
            in_frame(frame, radius * std::cos(turn), radius * std::sin(turn), 0);
        return {{start, frame.z, 0}, no_primitive};
    }

    /// Whether the ray passes the eye before `t`, coming from in front of it.
    bool passes_eye(const Ray<double>& ray, double t) const {
        const Vec3<double> to_eye = world_.scene().camera.eye - ray.origin;
        const double nearest = inner(to_eye, ray.direction);
        const Vec3<double> off = to_eye - nearest * ray.direction;
        return nearest > 0 && nearest < t && length(off) <= options_.eye_radius;
    }
    bool comes_through_window(const Ray<double>& ray) const {
        const Vec3<double> from = space_.point(ray.origin);
        if (!(from.z > 0)) {
            return false;
        }
        const CameraRays<double>& camera = world_.camera;
        const Camera& size = world_.scene().camera;
        const double width = camera.xp(1) - camera.xp(0);
        const double height = camera.yp(0) - camera.yp(1);
        const double i = (from.x / from.z - camera.xp(0)) / width;
        const double j = (camera.yp(0) - from.y / from.z) / height;
        return i > -0.5 && j > -0.5 && i < size.width - 0.5 && j < size.height - 0.5;
    }

    void follow(std::size_t k) {
        ShowerPath path;
        Beam beam = leaving_light(k);
        path.points.push_back(beam.ray.origin);
        for (int bounce = 0;; ++bounce) {
            ++result_.segments;
            NoTestCount count;
            const auto hit = world_.shapes.closest(beam.ray, beam.leaving, {}, count);
            if (passes_eye(beam.ray, hit ? hit->t : Real<double>::infinity)) {
                path.reaches_eye = true;
                path.in_picture = comes_through_window(beam.ray);
                path.points.push_back(world_.scene().camera.eye);
                break;
            }
            if (!hit) {
                path.escapes = true;
                path.points.push_back(along(beam.ray.origin, far_, beam.ray.direction));
                break;
            }
            result_.hits += bounce == 0 ? 1 : 0;
            const SurfacePoint<double> surface =
                world_.shapes.shapes().surface_at(hit->primitive, beam.ray, hit->t);
            path.points.push_back(surface.point);
            if (bounce + 1 >= options_.bounces) {
                break;
            }
            beam = onwards(beam, *hit, surface, spread(k, bounce));
        }
        keep(std::move(path), k);
    }

    /// The one direction in which it goes on.
    Beam onwards(const Beam& beam, const Hit<double>& hit, const SurfacePoint<double>& surface,
                 std::pair<double, double> u) const {
        const Vec3<double>& d = beam.ray.direction;
        const bool front = inner(d, surface.geometric_normal) < 0;
        const Vec3<double> n =
            front ? surface.shading_normal.vec() : Vec3<double>(-surface.shading_normal.vec());
        const auto object = world_.shapes.shapes()[hit.primitive].object;
        const WorldMaterial<double>& material =
            world_.materials[world_.scene().objects[object].material];
        const double scattered = largest_component(material.diffuse);
        const double mirrored = largest_component(material.kr);
        const double passed = largest_component(material.kt);
        Vec3<double> direction = scattered_direction(n, u);
        if (passed > scattered && passed >= mirrored) {
            const Snell<double> at =
                front ? snell(1.0, material.ior, d, n) : snell(material.ior, 1.0, d, n);
            direction = at.total_reflection() ? reflected_direction(d, n).vec()
                                              : refracted_direction(at, d, n).vec();
        } else if (mirrored > scattered) {
            direction = reflected_direction(d, n).vec();
        }
        return {{surface.point, direction,
                 4 * Real<double>::unit_roundoff * largest_component(surface.point)},
                hit.primitive};
    }

    /// By the cosine law (Malley's method: evenly over a disc, then up to the hemisphere).
    static Vec3<double> scattered_direction(const Vec3<double>& n, std::pair<double, double> u) {
        const double radius = std::sqrt(u.first);
        const double turn = 2 * pi * u.second;
        return UnitVec3<double>::of(in_frame(frame_around(n), radius * std::cos(turn),
                                             radius * std::sin(turn),
                                             std::sqrt(std::max(1e-12, 1 - u.first))))
            .vec();
    }

    void keep(ShowerPath path, std::size_t k) {
        result_.reach_eye += path.reaches_eye ? 1 : 0;
        result_.in_picture += path.in_picture ? 1 : 0;
        if (path.reaches_eye || k < options_.kept) {
            result_.paths.push_back(std::move(path));
        }
    }

    const World<double>& world_;
    const WorldLight<double>& light_;
    const ShowerOptions& options_;
    EyeSpace<double> space_;
    Box bounds_;
    double far_ = 1;
    LightShower result_;
};

}  // namespace

LightShower shower(const World<double>& world, std::size_t light, const ShowerOptions& options) {
    return Shower(world, light, options).send();
}

}  // namespace raytree
