#pragma once

#include <optional>

#include "formats/measure_map.h"
#include "state/neighbours.h"
#include "state/palette.h"
#include "state/ray_filter.h"

/// How things are shown, apart from what is shown.
namespace raytree::inspector {

enum class ShapeStyle { see_through, solid, wire };

struct Look {
    Theme theme = Theme::light;
    ShapeStyle shapes = ShapeStyle::see_through;
    RayFilter filter;                ///< of the rays in the 3D view
    bool ghosts = true;              ///< whether rays that were not sent are shown
    bool angles = true;              ///< whether those at the selected hit are drawn
    std::optional<Measure> overlay;  ///< shown in the picture's place; none: the picture itself
    /// There instead, while a light's depth picture is explained: where it differs from shadow
    /// rays.
    bool depth_overlay = false;
    bool names = true;    ///< whether things in the 3D view bear their names
    bool bounds = false;  ///< whether numbers are shown with their error bounds
    Neighbours neighbours = Neighbours::none;  ///< pixels whose trees the 3D view shows as well
};

/// Of the pane that shows the tree in one of three ways.
struct TreePane {
    enum class Tab { outline, diagram, counts, filter, explained };
    Tab tab = Tab::outline;
    /// The share of the pixel below which the diagram folds branches; none: as small a one as
    /// leaves a diagram that can be read at a glance.
    std::optional<double> fold_below = std::nullopt;
    double room = 0;    ///< how wide that is, in the diagram's units; 0 where nobody knows
    bool tall = false;  ///< whether the pane has most of the window's height
};

/// What stands in the place for lessons.
enum class LessonSide { hidden, contents, lesson };

/// What stands beside the 3D view.
enum class SidePane { none, steps, change, compare };

}  // namespace raytree::inspector
