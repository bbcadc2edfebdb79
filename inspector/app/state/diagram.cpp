#include "state/diagram.h"

#include <algorithm>

namespace raytree::inspector {
DiagramPlace frame_of(const DiagramBox& box) {
    return {box.x, box.y + DiagramSizes::label, box.card_width, box.card_height};
}

DiagramPlace light_place(const DiagramBox& box, std::size_t row) {
    constexpr double gap = 8;  // from the frame
    return {box.x + box.card_width + gap,
            box.y + DiagramSizes::label + box.light_row * static_cast<double>(row) - 1,
            box.lights_width - gap, box.light_row};
}

std::optional<DiagramSpot> spot_at(const Diagram& diagram, double x, double y) {
    for (std::size_t k = 0; k < diagram.boxes.size(); ++k) {
        const DiagramBox& box = diagram.boxes[k];
        DiagramPlace with_label = frame_of(box);
        with_label.y -= DiagramSizes::label;
        with_label.height += DiagramSizes::label;
        if (with_label.contains(x, y)) {
            return DiagramSpot{k, std::nullopt};
        }
        for (std::size_t row = 0; row < box.lights.size(); ++row) {
            if (light_place(box, row).contains(x, y)) {
                return DiagramSpot{k, row};
            }
        }
    }
    return std::nullopt;
}

DiagramSpot spot_of(const Diagram& diagram, const PixelTree& tree, std::size_t ray) {
    const TreeRay<double>& wanted = tree.tree.rays[ray];
    for (const TreeRay<double>* at = &wanted;; at = &tree.tree.rays[*at->parent]) {
        const auto found = std::ranges::find_if(diagram.boxes, [at](const DiagramBox& box) {
            return !box.absent && box.ray->id == at->id;
        });
        if (found == diagram.boxes.end() && at->parent) {
            continue;
        }
        DiagramSpot spot{static_cast<std::size_t>(found - diagram.boxes.begin()), std::nullopt};
        const auto row = std::ranges::find(found->lights, std::optional(ray), &LightRow::ray);
        if (row != found->lights.end()) {
            spot.light = static_cast<std::size_t>(row - found->lights.begin());
        }
        return spot;
    }
}

DiagramPlace place_of(const Diagram& diagram, DiagramSpot spot) {
    const DiagramBox& box = diagram.boxes[spot.box];
    return spot.light ? light_place(box, *spot.light) : frame_of(box);
}

std::size_t ray_of(const Diagram& diagram, DiagramSpot spot) {
    const DiagramBox& box = diagram.boxes[spot.box];
    return spot.light ? box.lights[*spot.light].ray.value_or(box.ray->id) : box.ray->id;
}

}  // namespace raytree::inspector
