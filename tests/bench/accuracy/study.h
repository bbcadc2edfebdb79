#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "accuracy/work_point.h"
#include "support/bench.h"

namespace raytree::bench {

/// A scene to be studied, and what it is called for people.
struct Subject {
    std::string name, title;
    Scene scene;
};

/// What accuracy costs in one scene: its picture by the three arithmetics, cut trees and other
/// programs, each with the time that it takes and how far it is off.
class Study {
  public:
    Study(const Options& options, Subject subject)
        : options_(options), subject_(std::move(subject)) {}

    void run();

    const std::vector<WorkPoint>& points() const { return points_; }
    const std::string& verdict() const { return verdict_; }

    /// All of it as JSON: what accuracy_plot.py draws.
    void write(const std::string& file) const;

  private:
    /// Something that makes the picture, before it is timed.
    struct Contender {
        WorkPoint point;
        std::unique_ptr<Scene> scene;
        std::function<Picture()> render;
    };

    void choose_size();
    void trace_truth(const Scene& deepest);
    void measure_settings(const Scene& deepest);
    void enter_embree(std::vector<Contender>& all, const Scene& deepest);
    void time(std::vector<Contender>& all);
    void run_povray_too(const Scene& deepest);
    void find_rounding(const Scene& deepest);
    template <class T> void enter(std::vector<Contender>& all, const std::string& family,
                                  const std::string& label, Scene scene) const;
    double pixels() const {
        return static_cast<double>(subject_.scene.camera.width) * subject_.scene.camera.height;
    }

    const Options& options_;
    Subject subject_;
    int truth_depth_ = 0;  ///< levels of its trees
    Truth truth_;
    std::vector<WorkPoint> points_;
    std::vector<Rounding> roundings_;
    std::vector<Steps<float>> embree_steps_;
    std::string embree_why_not_, povray_why_not_, verdict_;
};

}  // namespace raytree::bench
