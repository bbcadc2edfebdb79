#include "check/forge.h"

#include <algorithm>
#include <string>

#include "scene/input_error.h"

namespace raytree::check {
namespace {

/// Grows a tree depth first, a law at a time.
class Forge {
  public:
    Forge(const Place& place, const Laws& laws, RayTree<double>& tree)
        : place_(place), laws_(laws), tree_(tree) {}

    void grow(Step& step, std::optional<std::size_t> parent) {
        const std::size_t id = add(step, parent);
        const auto hit = laws_.meet(place_, step, laws_.interval(place_, step));
        if (!hit || !finite(step)) {
            tree_.rays[id].intensity = laws_.miss(place_, step);
            tree_.rays[id].termination =
                place_.max_distance ? Reason::max_distance : Reason::no_intersection;
            return;
        }
        land(place_, laws_, step, hit->primitive, hit->t);
        settle(place_, laws_, step);
        write_hit(id, step);
        Terms terms;
        terms.ambient = laws_.ambient(place_, step);
        shine(id, step, terms);
        const auto not_reflected = branch(id, step, RayKind::reflected, terms.reflected);
        const auto not_refracted = branch(id, step, RayKind::refracted, terms.refracted);
        TreeRay<double>& ray = tree_.rays[id];
        ray.ambient = terms.ambient;
        ray.diffuse = terms.diffuse;
        ray.specular = terms.specular;
        ray.attenuation = step.attenuation;
        ray.intensity = laws_.combine(place_, step, terms);
        if (not_reflected && not_refracted) {
            const Reason later = std::max(*not_reflected, *not_refracted);
            ray.termination = later <= Reason::not_transmissive ? Reason::opaque : later;
        }
    }

  private:
    static bool finite(const Step& step) {
        return isfinite(largest_component(step.direction)) && largest_component(step.direction) > 0;
    }

    std::size_t add(const Step& step, std::optional<std::size_t> parent) {
        TreeRay<double>& ray = tree_.rays.emplace_back();
        ray.id = tree_.rays.size() - 1;
        ray.parent = parent;
        ray.kind = step.kind;
        ray.level = step.level;
        ray.origin = step.origin;
        ray.direction = step.direction;
        ray.weight = step.weight;
        return ray.id;
    }

    std::string name_of(PrimitiveId primitive) const {
        return primitive_name(place_.scene(), place_.shapes.shapes()[primitive]);
    }

    void write_hit(std::size_t id, const Step& step) {
        TreeHit<double>& hit = tree_.rays[id].hit.emplace();
        hit.object = name_of(step.primitive);
        hit.material = step.material->name;
        hit.t = step.t;
        hit.point = step.point;
        hit.normal = step.normal;
        hit.side = step.front ? Side::front : Side::back;
        hit.cos_incident = step.cosine();
        if (step.ready->transmissive) {
            hit.interface = {step.eta1, step.eta2, step.sin2_transmitted};
        }
        hit.kr = step.kr;
        hit.kt = step.kt;
    }

    void shine(std::size_t id, const Step& step, Terms& terms) {
        for (std::size_t k = 0; k < place_.lights.size(); ++k) {
            Shine shine = shine_of(place_, laws_, step, k);
            const bool faces = laws_.faces(step, shine);
            if (!faces || !step.ready->lit) {
                tree_.rays[id].skipped.push_back(
                    {RayKind::shadow, place_.scene().lights[k].name,
                     faces ? Reason::surface_unlit : Reason::light_behind_surface});
                continue;
            }
            const Passage passage = laws_.shadow(place_, step, shine);
            shine.transmittance = passage.transmittance;
            shine.blocker = passage.blocker;
            shine.blocker_t = passage.t;
            const Spectrum diffuse = laws_.diffuse(place_, step, shine);
            const Spectrum specular = laws_.specular(place_, step, shine);
            terms.diffuse += diffuse;
            terms.specular += specular;
            if (place_.scene().settings.shadows != ShadowMode::none) {
                write_shadow(id, step, shine, diffuse, specular);
            }
        }
    }

    void write_shadow(std::size_t id, const Step& step, const Shine& shine, const Spectrum& diffuse,
                      const Spectrum& specular) {
        Step start = step;
        start.kind = RayKind::shadow;
        start.origin = laws_.start(place_, step, RayKind::shadow);
        start.direction = model::unit(laws_.sent(place_, step, shine));
        TreeRay<double>& ray = tree_.rays[add(start, id)];
        ray.weight = Spectrum(1.0);
        ray.diffuse = diffuse;
        ray.specular = specular;
        ShadowPart<double>& part = ray.shadow.emplace();
        part.light = place_.scene().lights[shine.light].name;
        part.transmittance = shine.transmittance;
        if (shine.distance < Real<double>::infinity) {
            part.distance = shine.distance;
        }
        if (shine.blocker != no_primitive) {
            part.blocked_by = {name_of(shine.blocker), shine.blocker_t};
        }
    }

    std::optional<Reason> branch(std::size_t id, const Step& step, RayKind kind,
                                 Terms::Branch& into) {
        const Spectrum weight = laws_.weight(step, kind);
        auto reason = laws_.why_not(place_, step, kind, weight);
        if (!reason && tree_.rays.size() >= place_.scene().settings.ray_budget) {
            reason = Reason::ray_budget;
        }
        if (!reason && step.level >= deepest_) {
            reason = Reason::max_depth;
        }
        if (reason) {
            tree_.rays[id].skipped.push_back({kind, "", *reason});
            return reason;
        }
        Step next = branch_of(place_, laws_, step, kind, weight);
        const std::size_t child = tree_.rays.size();
        grow(next, id);
        into.grown = true;
        into.coefficient = kind == RayKind::reflected ? step.kr : step.kt;
        into.attenuation = next.attenuation;
        into.intensity = tree_.rays[child].intensity;
        return std::nullopt;
    }

    static constexpr int deepest_ = 80;  // where a mistake would never end
    const Place& place_;
    const Laws& laws_;
    RayTree<double>& tree_;
};

void count(RayTree<double>& tree) {
    for (const TreeRay<double>& ray : tree.rays) {
        std::size_t* const by_kind[] = {&tree.counts.primary, &tree.counts.reflected,
                                        &tree.counts.refracted, &tree.counts.shadow};
        ++*by_kind[static_cast<std::size_t>(ray.kind)];
        tree.counts.levels = std::max(tree.counts.levels, ray.level);
    }
}

}  // namespace

RayTree<double> forge_tree(const Place& place, const Laws& laws, int i, int j) {
    const Scene& scene = place.scene();
    RayTree<double> tree;
    tree.scene_name = scene.name;
    tree.pixel_i = i;
    tree.pixel_j = j;
    tree.camera = scene.camera;
    tree.settings = scene.settings;
    Step primary;
    primary.pixel_i = i;
    primary.pixel_j = j;
    const Beam beam = laws.primary(place, primary);
    primary.origin = beam.origin;
    primary.direction = model::unit(beam.direction);
    primary.length = length(beam.direction);
    Forge(place, laws, tree).grow(primary, std::nullopt);
    tree.intensity = tree.rays.front().intensity;
    if (!isfinite(tree.intensity)) {
        throw InputError("", "pixel " + std::to_string(i) + ',' + std::to_string(j),
                         "the intensities of its tree grow beyond the largest number");
    }
    count(tree);
    tree.counts.lights = scene.lights.size();
    return tree;
}

}  // namespace raytree::check
