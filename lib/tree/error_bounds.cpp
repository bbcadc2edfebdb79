#include "tree/error_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "trace/shading.h"
#include "tree/doubts.h"
#include "tree/ray_noise.h"
#include "tree/shape_rounding.h"

namespace raytree {
namespace {

using Vec = Vec3<double>;
using Colour3 = Rgb<double>;

template <class Function> Colour3 each(const Colour3& c, Function&& f) {
    return {f(c.r), f(c.g), f(c.b)};
}

Colour3 scaled(const Colour3& c, double s) {
    return std::abs(s) * each(c, [](double x) { return std::abs(x); });
}

/// `min(1, 1 / (a + b t + c t^2))` and how far it moves with t.
double attenuation_error(const WorldAttenuation<double>& f, double t, double t_error, double u) {
    const double value = f.at(t);
    return std::min(1.0, value * value * (f.b + 2 * f.c * t) * t_error * 1.01 + 6 * u * value);
}

/// What the rays that leave a hit need of it.
struct HitState {
    std::size_t ray = 0;
    PrimitiveId primitive = no_primitive;
    Vec point{}, normal{}, viewing{};  ///< the normal as shaded, turned to the ray's side
    bool front = true;
    double curvature = 0;
    NoiseList surface;    ///< of the point and the shading normal
    NoiseList direction;  ///< the same sources, of the ray's direction (`way`)
};

class Pass {
  public:
    Pass(const World<double>& world, const World<Quad>& reference, const RayTree<double>& tree,
         double u)
        : world_(world),
          reference_(reference),
          tree_(tree),
          u_(u),
          bounds_(tree.rays.size()),
          doubts_(world, reference, u) {
        const ShapeSet<double>& shapes = world.shapes.shapes();
        for (std::size_t k = 0; k < shapes.size(); ++k) {
            const auto id = static_cast<PrimitiveId>(k);
            primitives_.emplace(primitive_name(world.scene(), shapes[id]), id);
        }
    }

    std::vector<RayBounds> run() {
        for (const TreeRay<double>& ray : tree_.rays) {
            if (ray.shadow) {
                shadow_ray(ray);
            } else {
                carrying_ray(ray);
            }
        }
        for (std::size_t k = tree_.rays.size(); k-- > 0;) {
            sum_up(tree_.rays[k]);
        }
        return std::move(bounds_);
    }

  private:
    // ---- rays ----

    void carrying_ray(const TreeRay<double>& ray) {
        NoiseList noise = ray.parent ? onwards(ray) : primary();
        RayBounds& bounds = bounds_[ray.id];
        bounds.origin = total(noise, [](const Noise& n) { return length(n.place); });
        bounds.direction = total(noise, [](const Noise& n) { return length(n.way); });
        bound_weight(ray);
        doubts_.carrying_ray(ray, hit_of(ray.parent), primitive_of(ray), noise, path_to(ray),
                             bounds.doubts);
        if (ray.hit) {
            meet(ray, noise);
        }
    }

    /// The camera's rounding, of its axes above all: they are as uncertain as its view is parallel
    /// to its up.
    NoiseList primary() const {
        const Camera& camera = tree_.camera;
        const Vec view = UnitVec3<double>::of(camera.look_at - camera.eye);
        const double sine = length<double>(outer<double>(view, UnitVec3<double>::of(camera.up)));
        NoiseList noise;
        add_noise(noise, 0, u_ * (16 + 12 / sine));
        return noise;
    }

    /// The noise of a branch: what the hit that it leaves knows, through reflection or refraction.
    NoiseList onwards(const TreeRay<double>& ray) const {
        const HitState& at = state_of(*ray.parent);
        const TreeHit<double>& hit = *tree_.rays[*ray.parent].hit;
        const Vec& d = at.viewing;
        const Vec& n = at.normal;
        const double c1 = -inner(d, n);
        const bool reflected = ray.kind == RayKind::reflected;
        const double eta = reflected ? 1 : hit.interface->eta1 / hit.interface->eta2;
        const double cos2 = reflected ? 1 : std::max(0.0, 1 - hit.interface->sin2_transmitted);
        const double cos_t = std::max(std::sqrt(cos2), std::sqrt(14 * u_));
        NoiseList noise;
        for (std::size_t k = 0; k < at.surface.size(); ++k) {
            const Vec& dd = at.direction[k].way;
            const Vec& dn = at.surface[k].way;
            const double dc1 = -(inner(dd, n) + inner(d, dn));
            Vec way;
            if (reflected) {
                way = dd + 2.0 * (dc1 * n + c1 * dn);
            } else {
                const double along_n = eta * c1 - std::sqrt(cos2);
                way = eta * dd + (eta * dc1 - eta * eta * c1 * dc1 / cos_t) * n + along_n * dn;
            }
            noise.push_back({at.surface[k].place, across(way, ray.direction)});
        }
        add_noise(noise, 0, 8 * u_ * (1 + eta));
        if (!reflected) {
            const double s2 = std::max(1.0, hit.interface->sin2_transmitted);
            noise.push_back({Vec(0, 0, 0), (8 * u_ * s2 / cos_t) * n});
        }
        return noise;
    }

    void bound_weight(const TreeRay<double>& ray) {
        RayBounds& bounds = bounds_[ray.id];
        if (!ray.parent) {
            return;
        }
        const TreeRay<double>& parent = tree_.rays[*ray.parent];
        const RayBounds& from = bounds_[*ray.parent];
        const Colour3& k = ray.kind == RayKind::reflected ? parent.hit->kr : parent.hit->kt;
        bounds.weight = scaled(k * from.weight, parent.attenuation) +
                        scaled(k * parent.weight, from.attenuation) + scaled(ray.weight, 4 * u_);
    }

    // ---- hits ----

    void meet(const TreeRay<double>& ray, const NoiseList& noise) {
        const TreeHit<double>& hit = *ray.hit;
        RayBounds& bounds = bounds_[ray.id];
        const PrimitiveId id = *primitive_of(ray);
        const Ray<double> line{ray.origin, ray.direction, 0.0};
        const SurfacePoint<double> own = world_.shapes.shapes().surface_at(id, line, hit.t);
        const Vec n = own.geometric_normal;
        const double speed = inner(n, ray.direction);
        const double cosine = std::max(std::abs(speed), 4 * u_);
        const ShapeRounding rounding = rounding_of(reference_, id, ray.origin, hit.t, u_);
        const Bend bend = bend_at(id, line, hit.t, n);
        const double turned = hit.side == Side::front ? 1 : -1;

        HitState state;
        state.ray = ray.id;
        state.primitive = id;
        state.point = hit.point;
        state.normal = hit.normal;
        state.viewing = ray.direction;
        state.front = hit.side == Side::front;
        double t_error = 4 * u_ * hit.t;
        const auto add = [&](const Vec& moved, const Vec& way, const Vec& own_turn) {
            state.surface.push_back({moved, turned * bend.turn(moved) + own_turn});
            state.direction.push_back({Vec(0, 0, 0), way});
        };
        for (const Noise& each_noise : noise) {
            const Vec w = each_noise.place + hit.t * each_noise.way;
            const double dt = -inner(n, w) / (speed < 0 ? -cosine : cosine);
            t_error += std::abs(dt);
            add(w + dt * ray.direction, each_noise.way, Vec(0, 0, 0));
        }
        const double slip = rounding.distance / cosine;
        t_error += slip;
        add(slip * across(ray.direction, n), Vec(0, 0, 0), Vec(0, 0, 0));
        for (int axis = 0; axis < 3; ++axis) {
            Vec e(0, 0, 0);
            e[axis] = 1;
            add(rounding.point * e, Vec(0, 0, 0), Vec(0, 0, 0));
            add(Vec(0, 0, 0), Vec(0, 0, 0), rounding.normal * e);
        }
        // Of a curved surface the first order is half of it at worst, where the hit is certain.
        if (bend.curvature > 0) {
            for (Noise& source : state.surface) {
                source.place *= 2.0;
                source.way *= 2.0;
            }
            t_error *= 2;
        }
        bounds.hit.t = t_error;
        bounds.hit.point = total(state.surface, [](const Noise& s) { return length(s.place); });
        bounds.hit.normal = total(state.surface, [](const Noise& s) { return length(s.way); });
        double cos_error = 4 * u_;
        for (std::size_t k = 0; k < state.surface.size(); ++k) {
            cos_error += std::abs(inner(state.direction[k].way, hit.normal) +
                                  inner(ray.direction, state.surface[k].way));
        }
        bounds.hit.cos_incident = cos_error;
        if (hit.interface) {
            const double eta = hit.interface->eta1 / hit.interface->eta2;
            bounds.hit.sin2_transmitted =
                eta * eta * (2 * std::abs(hit.cos_incident) + cos_error) * cos_error +
                14 * u_ * hit.interface->sin2_transmitted;
        }
        if (ray.parent) {
            bounds.attenuation = attenuation_error(world_.attenuation, hit.t, t_error, u_);
        }
        states_.resize(static_cast<std::size_t>(ray.level));
        states_.back() = std::move(state);
        bound_local_light(ray);
        doubts_.branches(ray, bounds, std::abs(speed), tree_.settings);
    }

    /// How a surface's normals turn along it: finite differences of the shape's own surface_at,
    /// which holds for every kind of shape, transformed or with interpolated normals.
    struct Bend {
        std::array<Vec, 2> tangents, turns;
        double curvature = 0;

        Vec turn(const Vec& moved) const {
            return inner(tangents[0], moved) * turns[0] + inner(tangents[1], moved) * turns[1];
        }
    };

    Bend bend_at(PrimitiveId id, const Ray<double>& ray, double t, const Vec& n) const {
        const ShapeSet<double>& shapes = world_.shapes.shapes();
        const Box box = shapes.bounds(id);
        const double step = 1e-6 * length(box.size());
        Bend bend;
        const Vec axis = std::abs(n.x) < 0.6 ? Vec(1, 0, 0) : Vec(0, 1, 0);
        bend.tangents[0] = UnitVec3<double>::of(outer(n, axis));
        bend.tangents[1] = outer(n, bend.tangents[0]);
        for (std::size_t k = 0; k < 2; ++k) {
            const auto normal_at = [&](double side) {
                Ray<double> beside = ray;
                beside.origin += side * step * bend.tangents[k];
                return shapes.surface_at(id, beside, t);
            };
            const auto ahead = normal_at(1), behind = normal_at(-1);
            const Vec turn = ahead.shading_normal.vec() - behind.shading_normal.vec();
            // What is left by rounding of the difference itself is no bend.
            if (length(turn) > 1e-9) {
                bend.turns[k] = turn / (2 * step);
                bend.curvature = std::max(bend.curvature, length(bend.turns[k]));
            } else {
                bend.turns[k] = Vec(0, 0, 0);
            }
        }
        return bend;
    }

    // ---- light ----

    struct LightBounds {
        double direction = 0, distance = 0, cosine = 0;
        Colour3 diffuse, specular;
    };

    LightBounds light_bounds(const HitState& at, std::size_t light_place, const Vec& towards,
                             double distance, const Colour3& transmittance) const {
        const WorldLight<double>& light = world_.lights[light_place];
        const std::size_t object = world_.shapes.shapes()[at.primitive].object;
        const WorldMaterial<double>& m = world_.materials[world_.scene().objects[object].material];
        const bool phong = tree_.settings.specular_model == SpecularModel::phong;
        const Vec v = -at.viewing;
        const Vec& n = at.normal;
        const Vec sum = towards + v;
        const double sum_length = std::max(length(sum), 4 * u_);
        const Vec half = sum / sum_length;
        const double n_l = inner(n, towards), n_v = inner(n, v);
        LightBounds result{light.directional ? 4 * u_ : 6 * u_, 6 * u_ * distance, 6 * u_, {}, {}};
        double h_error = 16 * u_ / (phong ? 1 : std::min(1.0, sum_length));
        for (std::size_t k = 0; k < at.surface.size(); ++k) {
            const Vec& dn = at.surface[k].way;
            const Vec dv = -at.direction[k].way;
            Vec dl(0, 0, 0);
            if (!light.directional) {
                dl = across(-at.surface[k].place, towards) / distance;
                result.distance += std::abs(inner(at.surface[k].place, towards));
            }
            const double cos_moves = inner(dn, towards) + inner(n, dl);
            result.direction += length(dl);
            result.cosine += std::abs(cos_moves);
            h_error +=
                std::abs(phong ? 2 * cos_moves * n_v + 2 * n_l * (inner(dn, v) + inner(n, dv)) -
                                     inner(dl, v) - inner(towards, dv)
                               : inner(dn, half) + inner(n, across(dl + dv, half)) / sum_length);
        }
        if (!(n_l > 0)) {
            return result;
        }
        const double h = specular_cosine(tree_.settings.specular_model, n, towards, v);
        const double s = m.shininess;
        const double power = std::pow(h, s);
        const double power_error = std::max(std::pow(h + h_error, s) - power,
                                            power - std::pow(std::max(0.0, h - h_error), s)) +
                                   4 * u_ * power;
        const double g = light.directional ? 1 : light.attenuation.at(distance);
        const double g_error =
            light.directional ? 0
                              : attenuation_error(light.attenuation, distance, result.distance, u_);
        const Colour3 arriving = scaled(light.intensity * transmittance, 1);
        result.diffuse =
            scaled(m.diffuse * arriving, g * result.cosine + g_error * n_l + 10 * u_ * g * n_l);
        result.specular = scaled(m.specular * arriving,
                                 g * power_error + (g_error + 10 * u_ * g) * (power + power_error));
        return result;
    }

    /// What light adds where no shadow ray says how it comes.
    void bound_local_light(const TreeRay<double>& ray) {
        RayBounds& bounds = bounds_[ray.id];
        const HitState& at = states_.back();
        bounds.ambient = scaled(ray.ambient, 4 * u_);
        for (std::size_t k = 0; k < world_.lights.size(); ++k) {
            const Illumination<double> light = illuminate(world_.lights[k], at.point, at.normal);
            const LightBounds by = light_bounds(at, k, light.towards, light.distance, Colour3(1.0));
            if (std::abs(light.cosine) <= by.cosine) {
                bounds.doubts.push_back(Doubt{
                    "within " + ulps_text(std::abs(light.cosine) / u_ / 2) + " of the light " +
                        world_.scene().lights[k].name + " being on the other side of the surface",
                    std::abs(light.cosine) / u_ / 2});
            }
            if (tree_.settings.shadows == ShadowMode::none && light.in_front()) {
                bounds.diffuse += by.diffuse;
                bounds.specular += by.specular;
            }
        }
    }

    void shadow_ray(const TreeRay<double>& ray) {
        RayBounds& bounds = bounds_[ray.id];
        const HitState& at = state_of(*ray.parent);
        const ShadowPart<double>& shadow = *ray.shadow;
        const std::size_t light = light_named(shadow.light);
        const LightBounds by = light_bounds(at, light, ray.direction, shadow.distance.value_or(0),
                                            shadow.transmittance);
        bounds.origin = bounds_[*ray.parent].hit.point;
        bounds.direction = by.direction;
        bounds.distance = by.distance;
        bounds.diffuse = by.diffuse;
        bounds.specular = by.specular;
        bounds.transmittance =
            scaled(shadow.transmittance, u_ * static_cast<double>(primitives_.size()));
        if (shadow.transmittance == Colour3(1.0)) {
            bounds.transmittance = Colour3(0.0);
        }
        NoiseList noise;
        for (const Noise& source : at.surface) {
            const Vec turned = world_.lights[light].directional
                                   ? Vec(0, 0, 0)
                                   : across(-source.place, ray.direction) / *shadow.distance;
            noise.push_back({source.place, turned});
        }
        add_noise(noise, 0, 4 * u_);
        if (shadow.blocked_by) {
            const auto blocker = primitives_.find(shadow.blocked_by->object);
            bounds.hit.t = doubts_.t_error(blocker->second, ray, shadow.blocked_by->t, noise);
        }
        doubts_.shadow_ray(ray, at.primitive, at.front,
                           shadow.blocked_by
                               ? std::optional(primitives_.find(shadow.blocked_by->object)->second)
                               : std::nullopt,
                           tree_.settings.shadows, noise, bounds.doubts);
    }

    // ---- bottom up ----

    void sum_up(const TreeRay<double>& ray) {
        RayBounds& bounds = bounds_[ray.id];
        if (!ray.shadow) {
            bounds.intensity +=
                bounds.ambient + bounds.diffuse + bounds.specular + scaled(ray.intensity, 8 * u_);
        }
        if (!ray.parent) {
            return;
        }
        RayBounds& above = bounds_[*ray.parent];
        const TreeRay<double>& parent = tree_.rays[*ray.parent];
        if (ray.shadow) {
            above.diffuse += bounds.diffuse + scaled(parent.diffuse, 2 * u_);
            above.specular += bounds.specular + scaled(parent.specular, 2 * u_);
            return;
        }
        const Colour3& k = ray.kind == RayKind::reflected ? parent.hit->kr : parent.hit->kt;
        above.intensity += scaled(k * bounds.intensity, ray.attenuation + bounds.attenuation) +
                           scaled(k * ray.intensity, bounds.attenuation + 4 * u_);
    }

    // ---- looking up ----

    const HitState& state_of(std::size_t ray) const {
        return states_[static_cast<std::size_t>(tree_.rays[ray].level) - 1];
    }
    std::optional<LeftSurface> hit_of(std::optional<std::size_t> ray) const {
        if (!ray) {
            return std::nullopt;
        }
        const HitState& at = state_of(*ray);
        return LeftSurface{at.primitive, at.front};
    }
    std::optional<PrimitiveId> primitive_of(const TreeRay<double>& ray) const {
        return ray.hit ? std::optional(primitives_.find(ray.hit->object)->second) : std::nullopt;
    }
    std::size_t light_named(const std::string& name) const {
        const auto& lights = world_.scene().lights;
        return static_cast<std::size_t>(std::ranges::find(lights, name, &Light::name) -
                                        lights.begin());
    }
    double path_to(const TreeRay<double>& ray) const {
        double path = 0;
        for (auto parent = ray.parent; parent; parent = tree_.rays[*parent].parent) {
            path += tree_.rays[*parent].hit->t;
        }
        return path;
    }

    const World<double>& world_;
    const World<Quad>& reference_;
    const RayTree<double>& tree_;
    double u_;
    std::vector<RayBounds> bounds_;
    DoubtFinder doubts_;
    std::unordered_map<std::string, PrimitiveId> primitives_;
    std::vector<HitState> states_;  ///< of the current ray's ancestors, by level
};

}  // namespace

std::vector<RayBounds> error_bounds(const World<double>& world, const World<Quad>& reference,
                                    const RayTree<double>& tree, double unit_roundoff) {
    return Pass(world, reference, tree, unit_roundoff).run();
}

}  // namespace raytree
