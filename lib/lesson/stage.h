#pragma once

#include <any>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <typeindex>

#include "lesson/lesson.h"
#include "lesson/staged_scene.h"
#include "tree/ray_tree.h"

namespace raytree::lesson {

/// Where a stage has its trees from: the tracer, unless a mistake is to be shown or a test wants to
/// know what a changed tracer does to a lesson.
using TreeSource = std::function<RayTree<double>(const World<double>&, int i, int j)>;
TreeSource the_tracer();
/// The tree that a program with this mistake of the check catalogue would give.
TreeSource with_mistake(const std::string& id);

/// A scene prepared for tracing and what has been worked out of it, shared by all that look at it.
class StageWorld {
  public:
    StageWorld(std::shared_ptr<const StagedScene> scene, TreeSource trace);
    StageWorld(const StageWorld&) = delete;
    StageWorld& operator=(const StageWorld&) = delete;

    const StagedScene& staged() const { return *scene_; }
    const std::shared_ptr<const StagedScene>& shared() const { return scene_; }
    const Scene& scene() const { return scene_->scene(); }
    const World<double>& world() const { return world_; }
    const TreeSource& source() const { return trace_; }

    /// Traced once. Throws InputError for a pixel outside the picture.
    std::shared_ptr<const RayTree<double>> tree_at(int i, int j) const;
    /// The tree as a raytree/1.0 document.
    std::shared_ptr<const Json> json_at(int i, int j) const;
    /// Anything else, worked out once under its name.
    std::shared_ptr<const Json> once(const std::string& name,
                                     const std::function<Json()>& work) const;
    /// What is measured would be another thing each time: each kind of it is measured once.
    template <class Measured, class Work> const Measured& measured_once(Work work) const {
        auto& known = measured_[typeid(Measured)];
        if (!known.has_value()) {
            known = work();
        }
        return std::any_cast<const Measured&>(known);
    }

  private:
    struct Traced {
        std::shared_ptr<const RayTree<double>> tree;
        std::shared_ptr<const Json> json;
    };
    Traced& traced_at(int i, int j) const;

    std::shared_ptr<const StagedScene> scene_;
    World<double> world_;
    TreeSource trace_;
    mutable std::map<std::pair<int, int>, Traced> traced_;
    mutable std::map<std::string, std::shared_ptr<const Json>> worked_out_;
    mutable std::map<std::type_index, std::any> measured_;
};

/// Finds other steps for `step(K)`; K from 1. Null where there is no such step.
using StepFinder = std::function<std::shared_ptr<const Scope>(std::size_t step)>;

/// What expressions see of one pixel: scene, camera, pixel, primary, rays, ray, counts, picture,
/// what the features give, and the functions at, step, with, in and mistake. lessons/README.md has
/// the list.
std::shared_ptr<const Scope> pixel_scope(std::shared_ptr<const StageWorld> world, const Show& show,
                                         StepFinder steps);

/// One ray of a pixel's tree, with the rays that it spawned as members.
std::shared_ptr<const Scope> ray_scope(std::shared_ptr<const StageWorld> world, Pixel pixel,
                                       std::size_t ray);

/// `base` with further names, which hide those of `base`.
std::shared_ptr<const Scope> extended(std::shared_ptr<const Scope> base,
                                      std::map<std::string, Value> names);

}  // namespace raytree::lesson
