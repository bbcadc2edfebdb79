#include "lesson/features.h"

#include <array>

#include "trace/render.h"

namespace raytree::lesson {
namespace {

constexpr std::array<std::string_view, 2> names = {"picture", "lecture"};

/// What tracing the whole picture takes.
Json picture_json(const StageWorld& world) {
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

/// What the lecture says itself, where a lesson quotes it.
Json lecture_json() { return {{"intersection_share", Json::array({0.75, 0.95})}}; }

}  // namespace

std::span<const std::string_view> feature_names() { return names; }

std::optional<Value> feature_member(const StageWorld& world, const Show&, std::size_t,
                                    std::string_view name) {
    if (name == "picture") {
        return Value{world.once("picture", [&] { return picture_json(world); }), nullptr};
    }
    if (name == "lecture") {
        return Value{world.once("lecture", lecture_json), nullptr};
    }
    return std::nullopt;
}

void check_features(const StageWorld&, const Show&, std::size_t) {}

}  // namespace raytree::lesson
