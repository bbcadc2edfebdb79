#include <algorithm>
#include <cmath>

#include "check/catalogue.h"
#include "check/forge.h"
#include "formats/tree_json.h"
#include "lesson/stage.h"
#include "tree/record.h"

namespace raytree::lesson {
namespace {

bool is_finite(const Vec3<double>& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Not so with some mistakes, such as the root of a number below zero.
bool has_numbers(const TreeRay<double>& ray) {
    const auto& hit = ray.hit;
    return is_finite(ray.origin) && is_finite(ray.direction) && isfinite(ray.weight) &&
           std::isfinite(ray.attenuation) && isfinite(ray.ambient) && isfinite(ray.diffuse) &&
           isfinite(ray.specular) && isfinite(ray.intensity) &&
           (!hit || (std::isfinite(hit->t) && is_finite(hit->point) && is_finite(hit->normal) &&
                     std::isfinite(hit->cos_incident))) &&
           (!ray.shadow || isfinite(ray.shadow->transmittance));
}

}  // namespace

TreeSource the_tracer() {
    return [](const World<double>& world, int i, int j) { return record_tree(world, i, j); };
}

TreeSource with_mistake(const std::string& id) {
    const check::MistakeRow* const row = check::find_mistake(id);
    if (row == nullptr) {
        throw ExpressionError("the catalogue of mistakes has no '" + id + "'");
    }
    check::Laws laws = check::model_laws();
    row->apply(laws);
    return [laws](const World<double>& world, int i, int j) {
        return check::forge_tree(world, laws, i, j);
    };
}

StageWorld::StageWorld(std::shared_ptr<const StagedScene> scene, TreeSource trace)
    : scene_(std::move(scene)), world_(scene_->scene()), trace_(std::move(trace)) {}

StageWorld::Traced& StageWorld::traced_at(int i, int j) const {
    Traced& traced = traced_[{i, j}];
    if (!traced.tree) {
        const Camera& camera = scene().camera;
        if (i < 0 || j < 0 || i >= camera.width || j >= camera.height) {
            traced_.erase({i, j});
            throw ExpressionError("pixel " + std::to_string(i) + "," + std::to_string(j) +
                                  " lies outside the picture of " + std::to_string(camera.width) +
                                  "x" + std::to_string(camera.height));
        }
        traced.tree = std::make_shared<const RayTree<double>>(trace_(world_, i, j));
    }
    return traced;
}

std::shared_ptr<const RayTree<double>> StageWorld::tree_at(int i, int j) const {
    return traced_at(i, j).tree;
}

std::shared_ptr<const Json> StageWorld::json_at(int i, int j) const {
    Traced& traced = traced_at(i, j);
    if (!traced.json) {
        if (!std::ranges::all_of(traced.tree->rays, has_numbers)) {
            throw ExpressionError("the tree of pixel " + std::to_string(i) + "," +
                                  std::to_string(j) +
                                  " has values that are no numbers: the mistake makes them");
        }
        traced.json = std::make_shared<const Json>(Json::parse(write_tree_json(*traced.tree)));
    }
    return traced.json;
}

std::shared_ptr<const Json> StageWorld::once(const std::string& name,
                                             const std::function<Json()>& work) const {
    auto& known = worked_out_[name];
    if (!known) {
        known = std::make_shared<const Json>(work());
    }
    return known;
}

}  // namespace raytree::lesson
