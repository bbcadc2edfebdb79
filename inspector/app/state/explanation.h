#pragma once

#include <array>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "accel/lecture_hierarchy.h"
#include "state/document.h"
#include "state/explained.h"
#include "state/newest_work.h"
#include "state/pixel_tree.h"
#include "trace/depth_picture.h"
#include "trace/light_shower.h"
#include "trace/shadow_volume.h"
#include "trace/z_buffer.h"
#include "tree/crossing_walk.h"

namespace raytree::inspector {

/// What one hierarchy takes for the nearest hit of the selected ray.
struct HierarchyTests {
    std::string name;
    std::optional<std::size_t> volumes;  ///< none: they are not tested one by one
    std::size_t shapes = 0;
};

struct TraversalReplay {
    LectureHierarchy hierarchy;
    std::vector<LectureIntersector::Step> steps;
    std::vector<HierarchyTests> tests;  ///< of all hierarchies, for this ray
};

/// All that the features shown have worked out of a scene and its selected ray.
struct Explanation {
    // What the scene alone decides; null where it is not shown.
    std::shared_ptr<const LightShower> shower;
    std::shared_ptr<const ShadowVolumes> volumes;
    std::shared_ptr<const DepthPicture> depth;
    // Of the selected ray.
    std::shared_ptr<const TraversalReplay> traversal;
    std::optional<VolumeCount> volume_count;    ///< along it, up to its hit
    std::optional<DepthComparison> comparison;  ///< at the selected ray's hit
    std::vector<ZBufferStep> z_buffer;
    std::optional<CrossingWalk> crossings;
    std::string failure;  ///< why there is less of it than was asked for; else empty
};

/// What is to be explained.
struct ExplanationAsked {
    std::shared_ptr<const Document> document;  ///< null: nothing
    std::shared_ptr<const PixelTree> tree;     ///< may be null: then what the scene alone decides
    Pixel pixel;
    std::size_t ray = 0;
    Explained explained;

    bool operator==(const ExplanationAsked&) const = default;
};

/// Works explanations out beside whoever asks: a shower of a million rays takes seconds.
class Explainer {
  public:
    /// Does nothing where it is the same as was asked last. What takes no longer than a glance is
    /// waited for; until it comes, what was shown of the scene stays, and nothing of another ray.
    void ask(ExplanationAsked asked);
    bool working() const { return working_; }
    /// Whether something new has come; waits for it no longer than `patience`.
    bool poll(std::chrono::milliseconds patience);
    const Explanation& explanation() const { return shown_; }

  private:
    ExplanationAsked asked_;
    bool working_ = false;
    Explanation shown_;
    Explanation done_;  ///< the last that was worked out
    ExplanationAsked done_of_;
    NewestWork<Explanation> work_;
};

/// How many volumes the ray is inside of after each crossing.
std::vector<int> counts_along(const VolumeCount& count);

/// The place of a light by its name; none where the scene has no such light.
std::optional<std::size_t> place_of_light(const Scene& scene, const std::string& name);

/// "boxes"
std::string_view name_of(lesson::HierarchyKind kind);

/// What a step of a replay shows: how many of them are there yet.
std::size_t steps_shown(const lesson::TraversalShown& shown, std::size_t all);

}  // namespace raytree::inspector
