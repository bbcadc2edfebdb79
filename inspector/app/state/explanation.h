#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "accel/lecture_hierarchy.h"
#include "state/document.h"
#include "state/explained.h"
#include "state/tree_worker.h"
#include "trace/depth_picture.h"
#include "trace/light_shower.h"
#include "trace/shadow_volume.h"
#include "trace/z_buffer.h"

namespace raytree::inspector {

/// What one hierarchy takes for the nearest hit of the selected ray.
struct HierarchyTests {
    std::string name;
    std::size_t volumes = 0, shapes = 0;
};

struct TraversalReplay {
    LectureHierarchy hierarchy;
    std::vector<LectureIntersector::Step> steps;
    std::vector<HierarchyTests> tests;  ///< of all hierarchies, for this ray
};

/// All that the features shown have worked out of a scene and its selected ray.
struct Explanation {
    std::optional<LightShower> shower;
    std::optional<TraversalReplay> traversal;
    std::optional<ShadowVolumes> volumes;
    std::optional<VolumeCount> volume_count;  ///< along the selected ray, up to its hit
    std::optional<DepthPicture> depth;
    std::optional<DepthComparison> comparison;  ///< at the selected ray's hit
    std::vector<ZBufferStep> z_buffer;
};

/// Works it out; what the scene alone decides is taken from `before` where that is of the same
/// scene and features.
class Explainer {
  public:
    /// `tree` may be null: then only what the scene alone decides. `version` is another one
    /// whenever `explained` is.
    const Explanation& explain(const std::shared_ptr<const Document>& document,
                               const std::shared_ptr<const PixelTree>& tree, Pixel pixel,
                               std::size_t ray, const Explained& explained, int version);

  private:
    void take_scene(const Document& document, const Explained& explained);
    void take_ray(const Document& document, const PixelTree* tree, Pixel pixel, std::size_t ray,
                  const Explained& explained);

    Explanation all_;
    std::shared_ptr<const Document> document_;
    std::shared_ptr<const PixelTree> tree_;
    std::size_t ray_ = 0;
    int version_ = -1;
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
