#include "lesson/feature_work.h"

namespace raytree::lesson {
namespace {

std::string object_name(const StageWorld& world, PrimitiveId primitive) {
    return primitive_name(world.scene(), world.world().shapes.shapes()[primitive]);
}

Json passage_json(const VolumePassage& passage) {
    return passage.met() ? Json::array({passage.enter, passage.leave}) : Json();
}

Json hit_json(const StageWorld& world, const std::optional<Hit<double>>& hit) {
    return hit ? Json{{"object", object_name(world, hit->primitive)}, {"t", hit->t}} : Json();
}

Json step_json(const StageWorld& world, const LectureHierarchy& hierarchy,
               const LectureIntersector::Step& step) {
    Json json = {{"node", step.node}, {"depth", hierarchy.nodes()[step.node].depth}};
    if (step.tested.empty()) {
        json["passage"] = passage_json(step.passage);
        json["opened"] = step.opened;
    } else {
        for (const PrimitiveId item : step.tested) {
            json["tested"].push_back(object_name(world, item));
        }
    }
    json["nearest"] = hit_json(world, step.nearest);
    return json;
}

std::size_t production_tests(const StageWorld& world, const ListedRay<double>& ray) {
    TestCount count;
    world.world().shapes.closest(ray.ray, ray.leaving, ray.interval, count);
    return count.tests;
}

/// What a hierarchy takes for the nearest hits of some rays.
LectureCount tests_of(const LectureIntersector& shapes, std::span<const ListedRay<double>> rays) {
    LectureCount count;
    for (const ListedRay<double>& ray : rays) {
        shapes.closest(ray.ray, ray.leaving, ray.interval, count);
    }
    return count;
}

Json counts_json(const LectureCount& count, std::size_t rays) {
    return {{"volumes", count.volumes},
            {"shapes", count.shapes},
            {"shapes_per_ray", static_cast<double>(count.shapes) / static_cast<double>(rays)},
            {"volumes_per_ray", static_cast<double>(count.volumes) / static_cast<double>(rays)}};
}

constexpr std::size_t most_pixels = 5000;  // of which all rays are asked again

}  // namespace

Json traversal_json(const StageWorld& world, const Show& show, std::size_t ray) {
    if (!show.traversal) {
        not_shown("traversal", "\"traversal\": {\"kind\": …}");
    }
    const ListedRay<double> listed = ray_of_tree(world, show.pixel, ray);
    if (show.traversal->kind == HierarchyKind::production) {
        return {{"shapes", production_tests(world, listed)}};
    }
    const LectureIntersector shapes(lecture_kind(show.traversal->kind),
                                    world.world().shapes.shapes());
    const auto steps = shapes.replay(listed.ray, listed.leaving, listed.interval);
    LectureCount count;
    const auto hit = shapes.closest(listed.ray, listed.leaving, listed.interval, count);
    Json json = {{"volumes", count.volumes},
                 {"shapes", count.shapes},
                 {"nodes", shapes.hierarchy().nodes().size()},
                 {"hit", hit_json(world, hit)},
                 {"steps", Json::array()}};
    for (const LectureIntersector::Step& step : steps) {
        json["steps"].push_back(step_json(world, shapes.hierarchy(), step));
    }
    return json;
}

Json hierarchies_json(const StageWorld& world, const Show& show, std::size_t ray) {
    const Camera& camera = world.scene().camera;
    const auto pixels =
        static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
    const auto all = rays_of_picture(world.world(), std::max<std::size_t>(1, pixels / most_pixels));
    const std::array one{ray_of_tree(world, show.pixel, ray)};
    Json json = {{"rays", all.size()}, {"objects", world.world().shapes.shapes().size()}};
    const std::array<std::pair<const char*, LectureKind>, 4> kinds{
        {{"brute_force", LectureKind::brute_force},
         {"spheres", LectureKind::spheres},
         {"boxes", LectureKind::boxes},
         {"octree", LectureKind::octree}}};
    for (const auto& [name, kind] : kinds) {
        const LectureIntersector shapes(kind, world.world().shapes.shapes());
        json[name] = {{"ray", counts_json(tests_of(shapes, one), 1)},
                      {"picture", counts_json(tests_of(shapes, all), all.size())}};
    }
    LectureCount production;
    for (const ListedRay<double>& listed : all) {
        production.shapes += production_tests(world, listed);
    }
    json["production"] = {{"ray", {{"shapes", production_tests(world, one[0])}}},
                          {"picture",
                           {{"shapes", production.shapes},
                            {"shapes_per_ray", static_cast<double>(production.shapes) /
                                                   static_cast<double>(all.size())}}}};
    return json;
}

ListedRay<double> ray_of_tree(const StageWorld& world, Pixel pixel, std::size_t ray) {
    // Of the truth the rays are those that the tracer lists, in the same order; of a tree with a
    // mistake in it only the primary ray is sure to be.
    const auto listed = rays_of_pixel(world.world(), pixel.i, pixel.j);
    const auto tree = world.tree_at(pixel.i, pixel.j);
    const Vec3<double>& direction = tree->rays[ray].direction;
    for (const ListedRay<double>& candidate : listed) {
        if (candidate.ray.origin == tree->rays[ray].origin &&
            candidate.ray.direction == direction) {
            return candidate;
        }
    }
    return {{tree->rays[ray].origin, direction, 0}, no_primitive, {}, tree->rays[ray].kind};
}

LectureKind lecture_kind(HierarchyKind kind) {
    return kind == HierarchyKind::spheres  ? LectureKind::spheres
           : kind == HierarchyKind::octree ? LectureKind::octree
                                           : LectureKind::boxes;
}

}  // namespace raytree::lesson
