#include "state/diagram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace raytree::inspector {
namespace {

constexpr std::size_t most_boxes = 1500;  // of rays; what a pane draws at once
constexpr std::array<double, 9> steps = {
    0, 0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1, std::numeric_limits<double>::infinity()};

bool is_folded(const TreeRay<double>& ray, double fold_below) {
    return ray.parent && largest_component(ray.weight) < fold_below;
}

/// The boxes of rays and of folded branches; stops counting where there are too many.
std::size_t box_count(const PixelTree& tree, double fold_below) {
    std::size_t count = 0;
    std::vector<std::size_t> stack{0};
    while (!stack.empty() && count <= most_boxes) {
        const std::size_t ray = stack.back();
        stack.pop_back();
        ++count;
        if (is_folded(tree.tree.rays[ray], fold_below)) {
            continue;
        }
        for (const std::size_t child : tree.children[ray]) {
            if (!tree.tree.rays[child].shadow) {
                stack.push_back(child);
            }
        }
    }
    return count;
}

/// Whether a branch that is drawn so would be folded.
bool folds_anything(const PixelTree& tree, double now, double then) {
    std::vector<std::size_t> stack{0};
    while (!stack.empty()) {
        const TreeRay<double>& ray = tree.tree.rays[stack.back()];
        stack.pop_back();
        if (is_folded(ray, now)) {
            continue;
        }
        if (is_folded(ray, then)) {
            return true;
        }
        for (const std::size_t child : tree.children[ray.id]) {
            if (!tree.tree.rays[child].shadow) {
                stack.push_back(child);
            }
        }
    }
    return false;
}

}  // namespace

double fold_of(const PixelTree& tree, double wish) {
    for (const double step : steps) {
        if (step >= wish && box_count(tree, step) <= most_boxes) {
            return step;
        }
    }
    return steps.back();
}

/// The smallest share with which the diagram is no wider than the room, or as narrow as it gets
/// without folding all of it.
double fold_of(const PixelTree& tree, const TreePane& pane) {
    constexpr double narrowest_box = 30;
    if (pane.fold_below || pane.room <= 0) {
        return fold_of(tree, pane.fold_below.value_or(0));
    }
    double best = fold_of(tree, 0.0), least = std::numeric_limits<double>::infinity();
    for (const double step : steps) {
        const auto boxes = static_cast<double>(box_count(tree, step));
        const bool hopeless = boxes * narrowest_box > 40 * pane.room;  // spares its layout
        if (step < fold_of(tree, 0.0) || std::isinf(step) || hopeless) {
            continue;
        }
        const double width = diagram_of(tree.tree, step).width;
        if (width < least) {
            least = width;
            best = step;
        }
        if (width <= pane.room) {
            return step;
        }
    }
    return best;
}

std::optional<double> fold_more(const PixelTree& tree, double wish) {
    const double now = fold_of(tree, wish);
    for (const double step : steps) {
        if (step > now && folds_anything(tree, now, step)) {
            return step;
        }
    }
    return std::nullopt;
}

std::optional<double> fold_less(const PixelTree& tree, double wish) {
    const double now = fold_of(tree, wish);
    for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
        if (*step < now && (folds_anything(tree, *step, now) || *step == 0)) {
            return box_count(tree, *step) <= most_boxes ? std::optional(*step) : std::nullopt;
        }
    }
    return std::nullopt;
}

DiagramPlace frame_of(const DiagramBox& box) {
    return {box.x, box.y + DiagramSizes::label, box.card_width, box.card_height};
}

DiagramPlace light_place(const DiagramBox& box, std::size_t row) {
    constexpr double gap = 8;  // from the frame
    return {box.x + box.card_width + gap,
            box.y + DiagramSizes::label + DiagramSizes::light_row * static_cast<double>(row) - 1,
            box.lights_width - gap, DiagramSizes::light_row};
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
