#pragma once

#include <QString>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "drawing/extent.h"
#include "drawing/ray_paths.h"
#include "state/state.h"

/// What is written over the 3D view.
namespace raytree::inspector {

/// A name in the 3D view.
struct SceneLabel {
    Point3 at;
    QString text;
    bool strong = false;
    std::optional<Point3> out = std::nullopt;  ///< towards which it may be moved
    QString away = {};  ///< what is written at the edge where it is outside; empty: nothing
    std::optional<Point3> seen_from = std::nullopt;  ///< from which a line leads to it there
    bool ringed = false;  ///< the place itself matters: it is shown where something hides it
    std::optional<Point3> stem = std::nullopt;  ///< likewise, with a line from here
    bool hidden = false;                        ///< behind a solid shape
};

/// What the legend explains: only what is drawn.
struct SceneLegend {
    std::array<bool, look_count> looks = {};
    std::array<bool, look_count> dimmed = {};  ///< of those, the kinds that the filter dims
    bool open = false;                         ///< rays that meet nothing
    bool unsent = false;                       ///< rays that were not sent

    friend bool operator==(const SceneLegend&, const SceneLegend&) = default;
};
SceneLegend legend_of(const State& state, const std::vector<RayPath>& paths);

/// What the signs of a compared tree mean; empty where none is.
std::string contrast_note(const State& state);

/// The selected ray, where it is known by now what it meets; else null.
const TreeRay<double>* selected_and_found(const State& state);

/// The names of what stands in the 3D view just now, and of the lights that are asked and lie
/// outside it.
std::vector<SceneLabel> scene_labels(const State& state, const Extent& extent, const View& view,
                                     bool from_the_eye);

/// Marks those whose place lies behind a shape that is drawn solid.
void mark_hidden(std::vector<SceneLabel>& labels, const Document& document, const View& view);

}  // namespace raytree::inspector
