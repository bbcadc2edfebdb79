#include "formats/did_you_mean.h"
#include "lesson/feature_work.h"
#include "trace/depth_picture.h"
#include "trace/light_shower.h"
#include "trace/shadow_volume.h"

namespace raytree::lesson {
namespace {

Json finite(double x) { return isfinite(x) ? Json(x) : Json(); }

}  // namespace

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

}  // namespace raytree::lesson
