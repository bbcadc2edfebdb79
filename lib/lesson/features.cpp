#include "lesson/features.h"

#include <array>

#include "lesson/feature_work.h"
#include "trace/render.h"
#include "trace/self_hits.h"
#include "trace/z_buffer.h"
#include "tree/crossing_walk.h"

namespace raytree::lesson {
namespace {

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

Json crossings_json(const StageWorld& world, const Show& show, std::size_t ray) {
    const auto tree = world.tree_at(show.pixel.i, show.pixel.j);
    const auto walk = crossing_walk(world.world(), tree->rays[ray],
                                    show.crossings ? show.crossings->object : std::string());
    if (!walk) {
        return nullptr;
    }
    Json at = Json::array();
    for (const CrossingWalk::Crossed& crossed : walk->crossed) {
        at.push_back(crossed.u);
    }
    return {{"object", walk->object},  {"t", walk->test.t},   {"u", walk->test.u},
            {"v", walk->test.v},       {"at", std::move(at)}, {"count", walk->crossed.size()},
            {"inside", walk->inside()}};
}

Json time_json(const StageWorld& world, const Show&, std::size_t) {
    const TimeShare share = time_share_of(world);
    return {{"rays", share.rays},
            {"intersection_share", share.share()},
            {"brute_force_share", share.brute_force_share()}};
}

Json point_json(const WorkPoint& point) {
    return {{"label", point.label}, {"seconds", point.seconds}, {"error", point.error}};
}

Json accuracy_json(const StageWorld& world, const Show&, std::size_t) {
    const WorkPrecision measured = work_precision_of(world);
    Json json = {{"pixels", measured.pixels}, {"levels", Json::array()}};
    for (const WorkPoint& point : measured.arithmetics) {
        json[point.label] = point_json(point);
    }
    for (const WorkPoint& point : measured.levels) {
        json["levels"].push_back(point_json(point));
    }
    return json;
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
    return {{"intersection_share", Json(lecture_intersection_share)}};
}

struct Feature {
    std::string_view name;
    Json (*work)(const StageWorld&, const Show&, std::size_t ray);
    bool of_scene;  ///< the same whatever is shown of it
};
constexpr Feature features[] = {
    {"picture", picture_json, true},
    {"shower", shower_json, false},
    {"traversal", traversal_json, false},
    {"hierarchies", hierarchies_json, false},
    {"volumes", volumes_json, false},
    {"depth", depth_json, false},
    {"z_buffer", z_buffer_json, false},
    {"crossings", crossings_json, false},
    {"time", time_json, true},
    {"accuracy", accuracy_json, true},
    {"self_hits", self_hits_json, true},
    {"lecture", lecture_json, true},
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
    if (show.crossings) {
        said.push_back({"crossings", show.crossings->object});
    }
    return key + said.dump();
}

}  // namespace

[[noreturn]] void not_shown(const char* feature, const char* member) {
    throw ExpressionError(std::string(feature) + ": what is shown does not say which; it needs " +
                          member);
}

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

TimeShare time_share_of(const StageWorld& world) {
    return world.measured_once<TimeShare>([&] { return measure_time_share(world.world()); });
}

WorkPrecision work_precision_of(const StageWorld& world) {
    return world.measured_once<WorkPrecision>(
        [&] { return measure_work_precision(world.scene()); });
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
    if (show.crossings && !show.crossings->object.empty() &&
        !has_polygon(world.world(), show.crossings->object)) {
        throw ExpressionError("the scene has no polygon '" + show.crossings->object + "'");
    }
}

}  // namespace raytree::lesson
