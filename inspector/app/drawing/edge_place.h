#pragma once

#include <optional>

#include "drawing/view.h"
#include "drawing/words.h"

namespace raytree::inspector {

/// On the edge of a frame: where a line from the frame's middle towards something outside leaves
/// it.
struct EdgePlace {
    double x = 0, y = 0;    ///< pixels, y down
    double dx = 0, dy = 0;  ///< the unit direction towards it
};

/// None for what is seen within the frame, and for the viewer's own place. What is behind the
/// viewer lies to the side to which one turns to see it, straight behind: downwards.
std::optional<EdgePlace> edge_place(const View& view, const WordBox& frame, const Point3& p);

/// The same on the line from `from` on to `p`, so that it continues a ray that is drawn from there;
/// from the frame's middle where `from` is not seen within the frame.
std::optional<EdgePlace> edge_place(const View& view, const WordBox& frame, const Point3& p,
                                    const Point3& from);

}  // namespace raytree::inspector
