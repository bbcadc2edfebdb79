#pragma once

#include <optional>

#include "formats/tree_diagram.h"
#include "state/state.h"

/// The drawing of a ray tree: where its rays are in it.
namespace raytree::inspector {

/// In the diagram's units, y down.
struct DiagramPlace {
    double x = 0, y = 0, width = 0, height = 0;

    bool contains(double px, double py) const {
        return px >= x && px < x + width && py >= y && py < y + height;
    }
};

/// A box's frame, without the label above it.
DiagramPlace frame_of(const DiagramBox& box);
/// Of a shadow ray beside the frame.
DiagramPlace light_place(const DiagramBox& box, std::size_t row);

/// What is drawn somewhere: a box, and perhaps one of its lights.
struct DiagramSpot {
    std::size_t box = 0;
    std::optional<std::size_t> light;
};
std::optional<DiagramSpot> spot_at(const Diagram& diagram, double x, double y);
/// Where a ray is drawn, or else the folded branch that holds it.
DiagramSpot spot_of(const Diagram& diagram, const PixelTree& tree, std::size_t ray);

DiagramPlace place_of(const Diagram& diagram, DiagramSpot spot);
/// The ray that a spot stands for; of one that was not sent, the ray whose hit it is missing from.
std::size_t ray_of(const Diagram& diagram, DiagramSpot spot);

}  // namespace raytree::inspector
