#pragma once

#include <optional>
#include <vector>

#include "state/diagram.h"
#include "state/playback.h"

namespace raytree::inspector {

/// How a box of a diagram differs from one that is simply there.
struct BoxLook {
    bool hidden = false;   ///< has not happened yet
    bool met = true;       ///< it is known what its ray meets
    bool pending = false;  ///< its ray's intensity is not known yet
    bool given = true;     ///< its ray's intensity is in the tree, which was recorded elsewhere
    bool graft = false;    ///< of the tree that is compared with
    RayMark mark = RayMark::none;
    RayMark inside = RayMark::none;  ///< of a folded branch: what says most of its rays
    std::vector<bool> hidden_lights;
    std::vector<RayMark> light_marks;
};

/// One for each box.
std::vector<BoxLook> box_looks(const Diagram& diagram, const PixelTree& tree,
                               const std::optional<Playback>& playback);

}  // namespace raytree::inspector
