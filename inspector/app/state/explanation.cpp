#include "state/explanation.h"

#include <algorithm>
#include <iterator>

#include "trace/ray_list.h"

namespace raytree::inspector {
namespace {

using lesson::HierarchyKind;

LectureKind kind_of(HierarchyKind kind) {
    return kind == HierarchyKind::spheres  ? LectureKind::spheres
           : kind == HierarchyKind::octree ? LectureKind::octree
                                           : LectureKind::boxes;
}

/// The ray as the tracer followed it: with the shape that it leaves and as far as hits count.
ListedRay<double> followed(const Document& document, Pixel pixel, const TreeRay<double>& ray) {
    for (const ListedRay<double>& listed : rays_of_pixel(document.world(), pixel.i, pixel.j)) {
        if (listed.ray.origin == ray.origin && listed.ray.direction == ray.direction) {
            return listed;
        }
    }
    return {{ray.origin, ray.direction, 0}, no_primitive, {}, ray.kind};
}

/// The shower with paths to be drawn: all that arrive, and of the others as many as the eye can
/// take in, on all sides. (The first of many would all go to the same side.)
LightShower drawable(const World<double>& world, std::size_t light, ShowerOptions options) {
    constexpr std::size_t most = 600;
    if (options.rays <= most) {
        return shower(world, light, options);
    }
    options.kept = 0;
    LightShower sent = shower(world, light, options);
    std::erase_if(sent.paths, [](const ShowerPath& path) { return !path.reaches_eye; });
    options.rays = options.kept = most;
    const LightShower drawn = shower(world, light, options);
    std::ranges::copy_if(drawn.paths, std::back_inserter(sent.paths),
                         [](const ShowerPath& path) { return !path.reaches_eye; });
    return sent;
}

TraversalReplay replay_of(const Document& document, const ListedRay<double>& ray,
                          HierarchyKind kind) {
    const auto& shapes = document.world().shapes.shapes();
    const LectureIntersector chosen(kind_of(kind), shapes);
    TraversalReplay replay{chosen.hierarchy(), {}, {}};
    if (kind != HierarchyKind::production) {
        replay.steps = chosen.replay(ray.ray, ray.leaving, ray.interval);
    }
    const std::pair<const char*, LectureKind> kinds[] = {{"no hierarchy", LectureKind::brute_force},
                                                         {"spheres", LectureKind::spheres},
                                                         {"boxes", LectureKind::boxes},
                                                         {"octree", LectureKind::octree}};
    for (const auto& [name, lecture] : kinds) {
        LectureCount count;
        LectureIntersector(lecture, shapes).closest(ray.ray, ray.leaving, ray.interval, count);
        replay.tests.push_back({name, count.volumes, count.shapes});
    }
    TestCount count;
    document.world().shapes.closest(ray.ray, ray.leaving, ray.interval, count);
    replay.tests.push_back({"production", 0, count.tests});
    return replay;
}

}  // namespace

const Explanation& Explainer::explain(const std::shared_ptr<const Document>& document,
                                      const std::shared_ptr<const PixelTree>& tree, Pixel pixel,
                                      std::size_t ray, const Explained& explained, int version) {
    const bool same_scene = document == document_ && version == version_;
    if (same_scene && tree == tree_ && ray == ray_) {
        return all_;
    }
    document_ = document;
    version_ = version;
    tree_ = tree;
    ray_ = ray;
    if (!same_scene) {
        all_ = {};
        if (document_) {
            take_scene(*document_, explained);
        }
    }
    if (document_) {
        take_ray(*document_, tree_.get(), pixel, ray, explained);
    }
    return all_;
}

void Explainer::take_scene(const Document& document, const Explained& explained) {
    const Scene& scene = document.scene();
    if (explained.shower) {
        if (const auto light = place_of_light(scene, explained.shower->light)) {
            ShowerOptions options;
            options.rays = static_cast<std::size_t>(explained.shower->rays);
            options.eye_radius = explained.shower->eye_radius;
            all_.shower = drawable(document.world(), *light, options);
        }
    }
    if (explained.volumes) {
        if (const auto light = place_of_light(scene, explained.volumes->light)) {
            all_.volumes = shadow_volumes(document.world(), *light);
        }
    }
    if (explained.depth) {
        if (const auto light = place_of_light(scene, explained.depth->light)) {
            all_.depth.emplace(document.world(), *light, explained.depth->size);
        }
    }
}

void Explainer::take_ray(const Document& document, const PixelTree* tree, Pixel pixel,
                         std::size_t id, const Explained& explained) {
    all_.traversal.reset();
    all_.volume_count.reset();
    all_.comparison.reset();
    all_.z_buffer.clear();
    if (!tree || id >= tree->tree.rays.size()) {
        return;
    }
    const TreeRay<double>& ray = tree->tree.rays[id];
    if (explained.traversal) {
        all_.traversal =
            replay_of(document, followed(document, pixel, ray), explained.traversal->kind);
    }
    if (all_.volumes) {
        const double t = ray.hit ? ray.hit->t : Real<double>::infinity;
        all_.volume_count = count_volumes(*all_.volumes, {ray.origin, ray.direction, 0}, t);
    }
    if (all_.depth && ray.hit) {
        all_.comparison = compare(*all_.depth, ray.hit->point, explained.depth->bias);
    }
    if (explained.z_buffer) {
        all_.z_buffer = z_buffer_at(document.world(), pixel.i, pixel.j);
    }
}

std::vector<int> counts_along(const VolumeCount& count) {
    std::vector<int> counts;
    int now = count.start;
    for (const WallCrossing& crossing : count.crossings) {
        now += crossing.enters ? 1 : -1;
        counts.push_back(now);
    }
    return counts;
}

std::optional<std::size_t> place_of_light(const Scene& scene, const std::string& name) {
    const auto found = std::ranges::find(scene.lights, name, &Light::name);
    return found == scene.lights.end()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(found - scene.lights.begin()));
}

std::string_view name_of(HierarchyKind kind) {
    constexpr std::array<std::string_view, 4> names = {"bounding spheres", "bounding boxes",
                                                       "octree", "production hierarchy"};
    return names[static_cast<std::size_t>(kind)];
}

std::size_t steps_shown(const lesson::TraversalShown& shown, std::size_t all) {
    return shown.step ? std::min(all, static_cast<std::size_t>(std::max(0, *shown.step))) : all;
}

}  // namespace raytree::inspector
