#include "tree/error_bounds.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "trace/shading.h"
#include "tree/doubts.h"
#include "tree/hit_noise.h"
#include "tree/light_rounding.h"

namespace raytree {
namespace {

using Vec = Vec3<double>;
using Colour3 = Rgb<double>;

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
        const NoiseList noise =
            ray.parent ? noise_onwards(state_of(*ray.parent), *tree_.rays[*ray.parent].hit, ray, u_)
                       : primary();
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

    void bound_weight(const TreeRay<double>& ray) {
        RayBounds& bounds = bounds_[ray.id];
        if (!ray.parent) {
            return;
        }
        const TreeRay<double>& parent = tree_.rays[*ray.parent];
        const RayBounds& from = bounds_[*ray.parent];
        const Colour3& k = ray.kind == RayKind::reflected ? parent.hit->kr : parent.hit->kt;
        bounds.weight = scaled(k * from.weight, parent.attenuation) +
                        scaled(k * parent.weight, from.attenuation) +
                        where_any(k) * rounded(ray.weight, 4, u_);
    }

    // ---- hits ----

    void meet(const TreeRay<double>& ray, const NoiseList& noise) {
        const TreeHit<double>& hit = *ray.hit;
        RayBounds& bounds = bounds_[ray.id];
        HitNoise at = noise_at_hit(world_, reference_, *primitive_of(ray), ray, noise, u_);
        bounds.hit.t = at.t_error;
        bounds.hit.point = total(at.surface, [](const Noise& s) { return length(s.place); });
        bounds.hit.normal = total(at.surface, [](const Noise& s) { return length(s.way); });
        double cos_error = 4 * u_;
        for (std::size_t k = 0; k < at.surface.size(); ++k) {
            cos_error += std::abs(inner(at.direction[k].way, hit.normal) +
                                  inner(ray.direction, at.surface[k].way));
        }
        bounds.hit.cos_incident = cos_error;
        if (hit.interface) {
            const double eta = hit.interface->eta1 / hit.interface->eta2;
            bounds.hit.sin2_transmitted =
                eta * eta * (2 * std::abs(hit.cos_incident) + cos_error) * cos_error +
                14 * u_ * hit.interface->sin2_transmitted;
        }
        if (ray.parent) {
            bounds.attenuation = attenuation_error(world_.attenuation, hit.t, at.t_error, u_);
        }
        states_.resize(static_cast<std::size_t>(ray.level));
        states_.back() = std::move(at);
        bound_local_light(ray);
        doubts_.branches(ray, bounds, states_.back().speed, tree_.settings);
    }

    // ---- light ----

    LightRounding light_at(const HitNoise& at, std::size_t light, const Vec& towards,
                           double distance, const Colour3& transmittance,
                           const Colour3& transmittance_error) const {
        const std::size_t object = world_.shapes.shapes()[at.primitive].object;
        return light_rounding(
            {world_.lights[light], towards, distance, transmittance, transmittance_error},
            world_.materials[world_.scene().objects[object].material],
            tree_.settings.specular_model, at, u_);
    }

    /// What light adds where no shadow ray says how it comes.
    void bound_local_light(const TreeRay<double>& ray) {
        RayBounds& bounds = bounds_[ray.id];
        const HitNoise& at = states_.back();
        const std::size_t object = world_.shapes.shapes()[at.primitive].object;
        const std::size_t material = world_.scene().objects[object].material;
        bounds.ambient = where_any(rgb_cast<double>(reference_.materials[material].ambient)) *
                         rounded(ray.ambient, 4, u_);
        for (std::size_t k = 0; k < world_.lights.size(); ++k) {
            const Illumination<double> light = illuminate(world_.lights[k], at.point, at.normal);
            const LightRounding by =
                light_at(at, k, light.towards, light.distance, Colour3(1.0), Colour3(0.0));
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
        const HitNoise& at = state_of(*ray.parent);
        const ShadowPart<double>& shadow = *ray.shadow;
        const std::size_t light = light_named(shadow.light);
        if (tree_.settings.shadows == ShadowMode::transmissive &&
            shadow.transmittance != Colour3(1.0)) {
            // A shape is passed once or twice.
            bounds.transmittance =
                rounded(shadow.transmittance, 2 * static_cast<double>(primitives_.size()), u_);
        }
        const LightRounding by = light_at(at, light, ray.direction, shadow.distance.value_or(0),
                                          shadow.transmittance, bounds.transmittance);
        bounds.origin = bounds_[*ray.parent].hit.point;
        bounds.direction = by.direction;
        bounds.distance = by.distance;
        bounds.diffuse = by.diffuse;
        bounds.specular = by.specular;
        const NoiseList noise = noise_to_light(at, ray, u_);
        if (shadow.blocked_by) {
            const auto blocker = primitives_.find(shadow.blocked_by->object);
            bounds.hit.t = doubts_.t_error(blocker->second, ray, shadow.blocked_by->t, noise);
        }
        doubts_.shadow_ray(ray, at.primitive, at.front,
                           shadow.blocked_by
                               ? std::optional(primitives_.find(shadow.blocked_by->object)->second)
                               : std::nullopt,
                           tree_.settings.shadows, by.distance, noise, bounds.doubts);
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
                           scaled(k * ray.intensity, bounds.attenuation) +
                           where_any(k) * rounded(k * ray.intensity, 4, u_);
    }

    // ---- looking up ----

    const HitNoise& state_of(std::size_t ray) const {
        return states_[static_cast<std::size_t>(tree_.rays[ray].level) - 1];
    }
    std::optional<LeftSurface> hit_of(std::optional<std::size_t> ray) const {
        if (!ray) {
            return std::nullopt;
        }
        const HitNoise& at = state_of(*ray);
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
    Bounded path_to(const TreeRay<double>& ray) const {
        Bounded path;
        for (auto parent = ray.parent; parent; parent = tree_.rays[*parent].parent) {
            path.value += tree_.rays[*parent].hit->t;
            path.error += bounds_[*parent].hit.t;
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
    std::vector<HitNoise> states_;  ///< of the current ray's ancestors, by level
};

}  // namespace

std::vector<RayBounds> error_bounds(const World<double>& world, const World<Quad>& reference,
                                    const RayTree<double>& tree, double unit_roundoff) {
    return Pass(world, reference, tree, unit_roundoff).run();
}

}  // namespace raytree
