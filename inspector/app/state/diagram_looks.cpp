#include "state/diagram_looks.h"

namespace raytree::inspector {
namespace {

/// Whether it is known by now that this branch is not sent.
bool is_decided(const Playback& playback, const TreeRay<double>& ray, RayKind kind) {
    for (std::size_t k = 0; k < ray.skipped.size(); ++k) {
        if (ray.skipped[k].kind == kind) {
            return playback.decided(ray.id, k);
        }
    }
    return playback.stage(ray.id) == Stage::evaluated;
}

bool has_happened(const Playback& playback, const DiagramBox& box) {
    return box.absent ? is_decided(playback, *box.ray, box.branch)
                      : playback.stage(box.ray->id) != Stage::unsent;
}

/// A cause says more than what follows from it, and that more than that all is the same.
int weight_of(RayMark mark) {
    switch (mark) {
        case RayMark::none:
        case RayMark::same:
            return 0;
        case RayMark::cut:
            return 1;
        case RayMark::follows:
            return 2;
        case RayMark::missing:
        case RayMark::extra:
            return 3;
        case RayMark::different:
            return 4;
    }
    return 0;
}

/// The weightiest mark of a branch's rays.
RayMark mark_inside(const PixelTree& tree, std::size_t branch) {
    RayMark most = tree.mark(branch);
    std::vector<std::size_t> stack{branch};
    while (!stack.empty()) {
        const std::size_t ray = stack.back();
        stack.pop_back();
        if (weight_of(tree.mark(ray)) > weight_of(most)) {
            most = tree.mark(ray);
        }
        stack.insert(stack.end(), tree.children[ray].begin(), tree.children[ray].end());
    }
    return most;
}

}  // namespace

std::vector<BoxLook> box_looks(const Diagram& diagram, const PixelTree& tree,
                               const std::optional<Playback>& playback) {
    std::vector<BoxLook> looks;
    looks.reserve(diagram.boxes.size());
    for (const DiagramBox& box : diagram.boxes) {
        BoxLook look;
        if (playback) {
            look.hidden = !has_happened(*playback, box);
            look.met = box.absent || playback->stage(box.ray->id) != Stage::sent;
            look.pending = !box.absent && playback->stage(box.ray->id) != Stage::evaluated;
        }
        if (!box.absent) {
            look.mark = tree.mark(box.ray->id);
            look.inside =
                box.folded > 0 && tree.contrast ? mark_inside(tree, box.ray->id) : RayMark::none;
            look.graft = !tree.is_own(box.ray->id);
            look.given = tree.gives_intensity(box.ray->id);
        }
        for (const LightRow& light : box.lights) {
            look.hidden_lights.push_back(
                playback && (light.ray ? playback->stage(*light.ray) == Stage::unsent
                                       : !playback->decided(box.ray->id, *light.skipped)));
            look.light_marks.push_back(light.ray ? tree.mark(*light.ray) : RayMark::none);
        }
        looks.push_back(std::move(look));
    }
    return looks;
}

}  // namespace raytree::inspector
