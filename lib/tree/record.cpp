#include "tree/record.h"

#include <string>

#include "scene/input_error.h"
#include "scene/plan.h"
#include "trace/tracer.h"

namespace raytree {
namespace {

/// Builds the tree of what the tracer reports.
template <class T> class TreeRecorder {
  public:
    static constexpr bool wants_reasons = true;
    using RayHandle = std::optional<std::size_t>;

    TreeRecorder(const World<T>& world, RayTree<T>& tree, const std::stop_token& stop)
        : world_(world), tree_(tree), stop_(stop) {}

    TestCount tests;

    RayHandle start(RayHandle parent, const RayStart<T>& begun) {
        if (stop_.stop_requested()) {
            throw Stopped();
        }
        TreeRay<T>& ray = add(parent, begun.kind, begun.level);
        ray.origin = begun.ray.origin;
        ray.direction = begun.ray.direction;
        ray.weight = begun.weight;
        return ray.id;
    }

    void hit(RayHandle handle, const HitEvent<T>& event) {
        const Primitive primitive = world_.shapes.shapes()[event.hit.primitive];
        TreeHit<T>& hit = tree_.rays[*handle].hit.emplace();
        hit.object = primitive_name(scene(), primitive);
        hit.material = scene().materials[scene().objects[primitive.object].material].name;
        hit.t = event.hit.t;
        hit.point = event.point;
        hit.normal = event.normal;
        hit.side = event.front ? Side::front : Side::back;
        hit.cos_incident = event.cos_incident;
        if (event.snell) {
            hit.interface = {event.snell->eta1, event.snell->eta2, event.snell->sin2_transmitted};
        }
        hit.kr = event.kr;
        hit.kt = event.kt;
    }

    void shadow(RayHandle handle, const ShadowEvent<T>& event) {
        TreeRay<T>& ray = add(handle, RayKind::shadow, tree_.rays[*handle].level);
        ray.origin = event.origin;
        ray.direction = event.at->towards;
        ray.diffuse = event.adds.diffuse;
        ray.specular = event.adds.specular;
        ShadowPart<T>& part = ray.shadow.emplace();
        part.light = scene().lights[event.light].name;
        part.transmittance = event.transmittance;
        if (!world_.lights[event.light].directional) {
            part.distance = event.at->distance;
        }
        if (event.blocker) {
            part.blocked_by = {
                primitive_name(scene(), world_.shapes.shapes()[event.blocker->primitive]),
                event.blocker->t};
        }
    }

    void skip_light(RayHandle handle, std::size_t light, Reason reason) {
        tree_.rays[*handle].skipped.push_back(
            {RayKind::shadow, scene().lights[light].name, reason});
    }
    void skip_branch(RayHandle handle, RayKind kind, Reason reason) {
        tree_.rays[*handle].skipped.push_back({kind, "", reason});
    }

    void end(RayHandle handle, const RayEnd<T>& end) {
        TreeRay<T>& ray = tree_.rays[*handle];
        ray.attenuation = end.attenuation;
        ray.ambient = end.ambient;
        ray.diffuse = end.diffuse;
        ray.specular = end.specular;
        ray.intensity = end.intensity;
        ray.termination = end.termination;
    }

  private:
    const Scene& scene() const { return world_.scene(); }

    TreeRay<T>& add(RayHandle parent, RayKind kind, int level) {
        TreeRay<T>& ray = tree_.rays.emplace_back();
        ray.id = tree_.rays.size() - 1;
        ray.parent = parent;
        ray.kind = kind;
        ray.level = level;
        return ray;
    }

    const World<T>& world_;
    RayTree<T>& tree_;
    const std::stop_token& stop_;
};

template <class T> TreeCounts count(const RayTree<T>& tree, const Scene& scene) {
    TreeCounts counts;
    for (const TreeRay<T>& ray : tree.rays) {
        std::size_t* const by_kind[] = {&counts.primary, &counts.reflected, &counts.refracted,
                                        &counts.shadow};
        ++*by_kind[static_cast<std::size_t>(ray.kind)];
        counts.levels = max_of(counts.levels, ray.level);
    }
    counts.lights = scene.lights.size();
    counts.full_tree = full_tree_rays(scene);
    return counts;
}

template <class T> bool finite(const Vec3<T>& v) { return isfinite(inner(v, Vec3<T>(T(1)))); }

template <class T> bool finite(const TreeRay<T>& ray) {
    bool all = finite(ray.origin) && finite(ray.direction) && isfinite(ray.weight) &&
               isfinite(ray.attenuation) && isfinite(ray.diffuse) && isfinite(ray.specular) &&
               isfinite(ray.ambient) && isfinite(ray.intensity);
    if (ray.hit) {
        all = all && isfinite(ray.hit->t) && finite(ray.hit->point) && finite(ray.hit->normal) &&
              isfinite(ray.hit->cos_incident);
    }
    if (ray.hit && ray.hit->interface) {
        all = all && isfinite(ray.hit->interface->sin2_transmitted);
    }
    return all && (!ray.shadow || isfinite(ray.shadow->transmittance));
}

/// A scene may hold numbers so large or small that something in the tree is no number any more.
template <class T> void check_finite(const RayTree<T>& tree) {
    for (const TreeRay<T>& ray : tree.rays) {
        if (!finite(ray)) {
            throw InputError(
                "", "pixel " + std::to_string(tree.pixel_i) + ',' + std::to_string(tree.pixel_j),
                "ray " + std::to_string(ray.id) +
                    " of its tree has numbers beyond the range of this precision: "
                    "the scene's lengths or coefficients are too large or too small");
        }
    }
}

}  // namespace

template <class T>
RayTree<T> record_tree(const World<T>& world, int i, int j, const std::stop_token& stop) {
    const Scene& scene = world.scene();
    const Camera& camera = scene.camera;
    if (i < 0 || j < 0 || i >= camera.width || j >= camera.height) {
        throw InputError("", "pixel " + std::to_string(i) + ',' + std::to_string(j),
                         "lies outside the picture; allowed are 0,0 to " +
                             std::to_string(camera.width - 1) + ',' +
                             std::to_string(camera.height - 1));
    }
    RayTree<T> tree;
    tree.generator = "raytree " RAYTREE_VERSION;
    tree.scene_name = scene.name;
    tree.pixel_i = i;
    tree.pixel_j = j;
    tree.camera = camera;
    tree.settings = scene.settings;
    TreeRecorder<T> recorder(world, tree, stop);
    tree.intensity = Tracer<T, TreeRecorder<T>>(world, recorder).trace_pixel(i, j);
    check_finite(tree);
    tree.counts = count(tree, scene);
    tree.counts.intersection_tests = recorder.tests.tests;
    return tree;
}

template RayTree<float> record_tree<float>(const World<float>&, int, int, const std::stop_token&);
template RayTree<double> record_tree<double>(const World<double>&, int, int,
                                             const std::stop_token&);
template RayTree<Quad> record_tree<Quad>(const World<Quad>&, int, int, const std::stop_token&);

}  // namespace raytree
