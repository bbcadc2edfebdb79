#include "lesson/features.h"

#include <array>

#include "formats/did_you_mean.h"
#include "trace/depth_picture.h"
#include "trace/light_shower.h"
#include "trace/render.h"
#include "trace/self_hits.h"
#include "trace/shadow_volume.h"
#include "trace/time_share.h"
#include "trace/z_buffer.h"

namespace raytree::lesson {
namespace {

std::string object_name(const StageWorld& world, PrimitiveId primitive) {
    return primitive_name(world.scene(), world.world().shapes.shapes()[primitive]);
}

/// What tracing the whole picture takes.
Json picture_json(const StageWorld& world, const Show&, std::size_t) {
    const Measurement measured = render_measured(world.world(), Measure::rays);
    Json json;
    for (const RayKind kind :
         {RayKind::primary, RayKind::reflected, RayKind::refracted, RayKind::shadow}) {
        const auto& of_kind = measured.counts[kind];
        json[std::string(word_of(kind))] = {
            {"rays", of_kind.rays}, {kind == RayKind::shadow ? "blocked" : "hits", of_kind.hits}};
    }
    for (const ReasonText& text : reason_texts()) {
        json["skipped"][std::string(text.word)] =
            measured.counts.skipped[static_cast<std::size_t>(text.reason)];
    }
    json["rays"] = measured.counts.rays();
    json["tests"] = measured.counts.tests;
    return json;
}

[[noreturn]] void not_shown(const char* feature, const char* member) {
    throw ExpressionError(std::string(feature) + ": what is shown does not say which; it needs " +
                          member);
}

Json shower_json(const StageWorld& world, const Show& show, std::size_t) {
    if (!show.shower) {
        not_shown("shower", "\"shower\": {\"light\": …}");
    }
    const ShowerOptions options{static_cast<std::size_t>(show.shower->rays),
                                show.shower->eye_radius};
    const LightShower sent =
        shower(world.world(), light_named(world.scene(), show.shower->light), options);
    return {{"rays", sent.rays},
            {"hits", sent.hits},
            {"escape", sent.rays - sent.hits},
            {"segments", sent.segments},
            {"reach_eye", sent.reach_eye},
            {"in_picture", sent.in_picture},
            {"eye_radius", options.eye_radius}};
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

Json volumes_json(const StageWorld& world, const Show& show, std::size_t ray) {
    if (!show.volumes) {
        not_shown("volumes", "\"volumes\": {\"light\": …}");
    }
    const ShadowVolumes volumes =
        shadow_volumes(world.world(), light_named(world.scene(), show.volumes->light));
    const auto tree = world.tree_at(show.pixel.i, show.pixel.j);
    const TreeRay<double>& followed = tree->rays[ray];
    const double t = followed.hit ? followed.hit->t : Real<double>::infinity;
    const VolumeCount count = count_volumes(volumes, {followed.origin, followed.direction, 0}, t);
    std::size_t walls = 0;
    for (const ShadowVolume& volume : volumes.volumes) {
        walls += volume.walls.size();
    }
    Json json = {{"volumes", volumes.volumes.size()}, {"walls", walls},
                 {"left_out", Json::array()},         {"start", count.start},
                 {"crossings", Json::array()},        {"end", count.end},
                 {"in_shadow", count.end > 0}};
    for (const std::size_t object : volumes.left_out) {
        json["left_out"].push_back(world.scene().objects[object].name);
    }
    for (const WallCrossing& crossing : count.crossings) {
        const std::size_t object = volumes.volumes[crossing.volume].object;
        json["crossings"].push_back({{"t", crossing.t},
                                     {"object", world.scene().objects[object].name},
                                     {"enters", crossing.enters}});
    }
    return json;
}

Json finite(double x) { return isfinite(x) ? Json(x) : Json(); }

Json depth_json(const StageWorld& world, const Show& show, std::size_t ray) {
    if (!show.depth) {
        not_shown("depth", "\"depth\": {\"light\": …}");
    }
    const std::size_t light = light_named(world.scene(), show.depth->light);
    const DepthPicture picture(world.world(), light, show.depth->size);
    const DepthAgreement agreed = agreement(world.world(), light, picture, show.depth->bias);
    Json json = {{"size", picture.size()},
                 {"sides", picture.sides().size()},
                 {"bias", show.depth->bias},
                 {"compared", agreed.compared},
                 {"wrongly_dark", agreed.wrongly_dark},
                 {"wrongly_lit", agreed.wrongly_lit},
                 {"differ", agreed.differ()}};
    const auto tree = world.tree_at(show.pixel.i, show.pixel.j);
    if (tree->rays[ray].hit) {
        const DepthComparison at = compare(picture, tree->rays[ray].hit->point, show.depth->bias);
        json["i"] = at.place.i;
        json["j"] = at.place.j;
        json["stored"] = finite(at.stored);
        json["distance"] = at.distance;
        json["lit"] = at.lit;
    }
    return json;
}

Json z_buffer_json(const StageWorld& world, const Show& show, std::size_t) {
    Json list = Json::array();
    for (const ZBufferStep& step : z_buffer_at(world.world(), show.pixel.i, show.pixel.j)) {
        list.push_back({{"object", world.scene().objects[step.object].name},
                        {"z", step.z},
                        {"t", step.t},
                        {"written", step.written}});
    }
    return list;
}

Json time_json(const StageWorld& world, const Show&, std::size_t) {
    const TimeShare share = measure_time_share(world.world());
    return {{"rays", share.rays},
            {"intersection_share", share.share()},
            {"brute_force_share", share.brute_force_share()}};
}

template <class T> Json self_hits_in(const Scene& scene) {
    const World<T> world(scene);
    const SelfHits hits = self_hits(world);
    return {{"rays", hits.rays}, {"wrong", hits.wrong}, {"share", hits.share()}};
}

Json self_hits_json(const StageWorld& world, const Show&, std::size_t) {
    return {{"float", self_hits_in<float>(world.scene())},
            {"double", self_hits_in<double>(world.scene())}};
}

/// What the lecture says itself, where a lesson quotes it.
Json lecture_json(const StageWorld&, const Show&, std::size_t) {
    return {{"intersection_share", Json::array({0.75, 0.95})}};
}

struct Feature {
    std::string_view name;
    Json (*work)(const StageWorld&, const Show&, std::size_t ray);
    bool of_scene;  ///< the same whatever is shown of it
};
constexpr Feature features[] = {
    {"picture", picture_json, true},      {"shower", shower_json, false},
    {"traversal", traversal_json, false}, {"hierarchies", hierarchies_json, false},
    {"volumes", volumes_json, false},     {"depth", depth_json, false},
    {"z_buffer", z_buffer_json, false},   {"time", time_json, true},
    {"self_hits", self_hits_json, true},  {"lecture", lecture_json, true},
};

/// What two looks at a feature must have in common to be the same.
std::string key_of(const Feature& feature, const Show& show, std::size_t ray) {
    std::string key(feature.name);
    if (feature.of_scene) {
        return key;
    }
    Json said = {show.pixel.i, show.pixel.j, ray};
    if (show.shower) {
        said.push_back({show.shower->light, show.shower->rays, show.shower->eye_radius});
    }
    if (show.traversal) {
        said.push_back({"traversal", static_cast<int>(show.traversal->kind)});
    }
    if (show.volumes) {
        said.push_back({"volumes", show.volumes->light});
    }
    if (show.depth) {
        said.push_back({"depth", show.depth->light, show.depth->size, show.depth->bias});
    }
    return key + said.dump();
}

}  // namespace

std::span<const std::string_view> feature_names() {
    static const auto names = [] {
        std::array<std::string_view, std::size(features)> all;
        std::ranges::transform(features, all.begin(), &Feature::name);
        return all;
    }();
    return names;
}

std::optional<Value> feature_member(const StageWorld& world, const Show& show, std::size_t ray,
                                    std::string_view name) {
    for (const Feature& feature : features) {
        if (feature.name == name) {
            return Value{world.once(key_of(feature, show, ray),
                                    [&] { return feature.work(world, show, ray); }),
                         nullptr};
        }
    }
    return std::nullopt;
}

std::size_t light_named(const Scene& scene, const std::string& name) {
    std::vector<std::string_view> names;
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        if (scene.lights[k].name == name) {
            return k;
        }
        names.push_back(scene.lights[k].name);
    }
    throw ExpressionError("the scene has no light '" + name + "'" + did_you_mean(name, names));
}

LectureKind lecture_kind(HierarchyKind kind) {
    return kind == HierarchyKind::spheres  ? LectureKind::spheres
           : kind == HierarchyKind::octree ? LectureKind::octree
                                           : LectureKind::boxes;
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

void check_features(const StageWorld& world, const Show& show, std::size_t) {
    if (show.shower) {
        light_named(world.scene(), show.shower->light);
    }
    if (show.volumes) {
        light_named(world.scene(), show.volumes->light);
    }
    if (show.depth) {
        light_named(world.scene(), show.depth->light);
    }
}

}  // namespace raytree::lesson
