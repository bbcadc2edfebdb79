#include "state/explanation.h"

#include <algorithm>
#include <iterator>
#include <new>

#include "scene/progress.h"
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
    replay.tests.push_back({"production", std::nullopt, count.tests});
    return replay;
}

/// What is known already, of a question asked before.
struct Known {
    const ExplanationAsked& asked;
    const Explanation& all;
};

bool same_ray(const ExplanationAsked& a, const ExplanationAsked& b) {
    return a.document == b.document && a.tree == b.tree && a.ray == b.ray;
}
bool same_replay(const ExplanationAsked& a, const ExplanationAsked& b) {
    const auto &x = a.explained.traversal, &y = b.explained.traversal;
    return same_ray(a, b) && x && y && x->kind == y->kind;
}
bool same_depth(const ExplanationAsked& a, const ExplanationAsked& b) {
    const auto &x = a.explained.depth, &y = b.explained.depth;
    return a.document == b.document && x && y && x->light == y->light && x->size == y->size;
}

void take_scene(const ExplanationAsked& asked, const Known& known, Explanation& all) {
    const Explained &explained = asked.explained, &before = known.asked.explained;
    const bool same = asked.document == known.asked.document;
    const World<double>& world = asked.document->world();
    const auto light_of = [&](const auto& shown) {
        return shown ? place_of_light(world.scene(), shown->light) : std::nullopt;
    };
    if (same && explained.shower == before.shower) {
        all.shower = known.all.shower;
    } else if (const auto light = light_of(explained.shower)) {
        ShowerOptions options;
        options.rays = static_cast<std::size_t>(explained.shower->rays);
        options.eye_radius = explained.shower->eye_radius;
        all.shower = std::make_shared<const LightShower>(drawable(world, *light, options));
    }
    if (same && explained.volumes == before.volumes) {
        all.volumes = known.all.volumes;
    } else if (const auto light = light_of(explained.volumes)) {
        all.volumes = std::make_shared<const ShadowVolumes>(shadow_volumes(world, *light));
    }
    if (same_depth(asked, known.asked)) {
        all.depth = known.all.depth;
    } else if (const auto light = light_of(explained.depth)) {
        all.depth = std::make_shared<const DepthPicture>(world, *light, explained.depth->size);
    }
}

void take_ray(const ExplanationAsked& asked, const Known& known, Explanation& all) {
    const Explained& explained = asked.explained;
    const Document& document = *asked.document;
    if (!asked.tree || asked.ray >= asked.tree->tree.rays.size()) {
        return;
    }
    const TreeRay<double>& ray = asked.tree->tree.rays[asked.ray];
    if (same_replay(asked, known.asked)) {
        all.traversal = known.all.traversal;
    } else if (explained.traversal) {
        all.traversal = std::make_shared<const TraversalReplay>(
            replay_of(document, followed(document, asked.pixel, ray), explained.traversal->kind));
    }
    if (all.volumes) {
        const double t = ray.hit ? ray.hit->t : Real<double>::infinity;
        all.volume_count = count_volumes(*all.volumes, {ray.origin, ray.direction, 0}, t);
    }
    if (all.depth && ray.hit) {
        all.comparison = compare(*all.depth, ray.hit->point, explained.depth->bias);
    }
    if (explained.z_buffer) {
        all.z_buffer = z_buffer_at(document.world(), asked.pixel.i, asked.pixel.j);
    }
    if (explained.crossings) {
        all.crossings = crossing_walk(document.world(), ray, explained.crossings->object);
    }
}

/// What may be shown of the old until the new has come.
Explanation kept(const ExplanationAsked& asked, const Known& known) {
    Explanation all;
    if (!asked.document || !known.asked.document ||
        asked.document->file() != known.asked.document->file()) {
        return all;
    }
    all.shower = asked.explained.shower ? known.all.shower : nullptr;
    all.volumes = asked.explained.volumes ? known.all.volumes : nullptr;
    all.depth = asked.explained.depth ? known.all.depth : nullptr;
    all.traversal = same_replay(asked, known.asked) ? known.all.traversal : nullptr;
    return all;
}

}  // namespace

void Explainer::ask(ExplanationAsked asked) {
    constexpr std::chrono::milliseconds glance(15);
    if (asked == asked_) {
        return;
    }
    asked_ = std::move(asked);
    shown_ = kept(asked_, {done_of_, done_});
    working_ = asked_.document && !asked_.explained.nothing();
    work_.ask([to = working_ ? asked_ : ExplanationAsked{}, done_of = done_of_,
               done = done_](const std::stop_token& stop) {
        Explanation all;
        const ProgressListener until_stopped([&stop](std::string_view, double) {
            if (stop.stop_requested()) {
                throw Stopped();
            }
        });
        try {
            if (to.document) {
                take_scene(to, {done_of, done}, all);
            }
            if (to.document && !stop.stop_requested()) {
                take_ray(to, {done_of, done}, all);
            }
        } catch (const std::bad_alloc&) {
            all.failure = "There is too little memory to explain this.";
        }
        return all;
    });
    if (working_) {
        poll(glance);
    }
}

bool Explainer::poll(std::chrono::milliseconds patience) {
    if (!working_) {
        return false;
    }
    auto all = work_.take(patience);
    if (!all) {
        return false;
    }
    working_ = false;
    shown_ = done_ = std::move(*all);
    done_of_ = asked_;
    return true;
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
