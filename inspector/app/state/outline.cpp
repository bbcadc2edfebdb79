#include "state/outline.h"

#include <algorithm>

#include "state/numbers.h"
#include "tree/explain.h"

namespace raytree::inspector {
namespace {

constexpr RayKind order[] = {RayKind::shadow, RayKind::reflected, RayKind::refracted};

std::string named(RayKind kind, const std::string& light) {
    return std::string(word_of(kind)) + (light.empty() ? "" : " → " + light);
}

/// What a shadow ray meets, and why its light does not come.
void add_fate(const PixelTree& tree, const TreeRay<double>& ray, OutlineTexts& texts) {
    const ShadowPart<double>& shadow = *ray.shadow;
    if (shadow.blocked_by) {
        texts.met = shadow.blocked_by->object;
        texts.ended = "blocked";
    } else if (reaches_light(ray)) {
        texts.met = "the light";
    } else if (tree.recorded && tree.is_own(ray.id) &&
               !tree.recorded->gives(ray.id, Field::blocked_by)) {
        texts.met = "not given";
        texts.ended = "blocked";
    } else {
        texts.met = "the light";
        texts.ended = "dimmed to 0";
    }
}

}  // namespace

Outline::Outline(std::shared_ptr<const PixelTree> tree, bool ghosts, Shown shown)
    : tree_(std::move(tree)), ghosts_(ghosts), shown_(std::move(shown)) {
    if (tree_) {
        rows_.emplace_back();
    }
}

const std::vector<std::size_t>& Outline::children_of(std::size_t row) const {
    if (rows_[row].children) {
        return *rows_[row].children;
    }
    std::vector<std::size_t> children;
    if (!rows_[row].row.skipped) {
        const std::size_t id = rows_[row].row.ray;
        const TreeRay<double>& ray = tree_->tree.rays[id];
        for (const RayKind kind : order) {
            for (const std::size_t child : tree_->children[id]) {
                if (tree_->tree.rays[child].kind == kind) {
                    add_child(row, children, child, std::nullopt);
                }
            }
            for (std::size_t k = 0; ghosts_ && k < ray.skipped.size(); ++k) {
                if (ray.skipped[k].kind == kind && !told_by_termination(ray, ray.skipped[k])) {
                    add_child(row, children, id, k);
                }
            }
        }
    }
    return rows_[row].children.emplace(std::move(children));
}

void Outline::add_child(std::size_t parent, std::vector<std::size_t>& children, std::size_t ray,
                        std::optional<std::size_t> skipped) const {
    const std::size_t row = rows_.size();
    const OutlineRow added{ray, skipped, parent, children.size()};
    if (shown_ && !shown_(added)) {
        return;
    }
    rows_.push_back({added, std::nullopt});
    children.push_back(row);
}

std::size_t Outline::row_of(std::size_t ray) const {
    std::vector<std::size_t> way;  // from the ray up to the primary one, which is left out
    for (std::size_t at = ray; tree_->tree.rays[at].parent; at = *tree_->tree.rays[at].parent) {
        way.push_back(at);
    }
    std::size_t row = 0;
    for (auto next = way.rbegin(); next != way.rend(); ++next) {
        const auto& children = children_of(row);
        const auto found = std::ranges::find_if(children, [&](std::size_t child) {
            return rows_[child].row.ray == *next && !rows_[child].row.skipped;
        });
        if (found == children.end()) {
            break;
        }
        row = *found;
    }
    return row;
}

OutlineTexts texts_of(const PixelTree& tree, const OutlineRow& row) {
    const TreeRay<double>& ray = tree.tree.rays[row.ray];
    if (row.skipped) {
        const Skipped& skipped = ray.skipped[*row.skipped];
        return {named(skipped.kind, skipped.light), "not sent", "", "",
                skipped_text(tree.tree, ray, skipped)};
    }
    OutlineTexts texts;
    texts.ray = named(ray.kind, ray.shadow ? ray.shadow->light : "");
    if (ray.shadow) {
        add_fate(tree, ray, texts);
        if (ray.shadow->blocked_by || ray.shadow->distance) {
            texts.t = number_text(ray.shadow->blocked_by ? ray.shadow->blocked_by->t
                                                         : *ray.shadow->distance);
        }
        texts.intensity = rgb_text(ray.diffuse + ray.specular);
        return texts;
    }
    texts.met =
        ray.hit ? ray.hit->object + (ray.hit->side == Side::back ? ", back" : "") : "nothing";
    texts.t = ray.hit ? number_text(ray.hit->t) : "";
    texts.intensity = rgb_text(ray.intensity);
    texts.ended = ended_text(tree.tree, ray);
    return texts;
}

std::optional<Rgb<double>> swatch_of(const PixelTree& tree, const OutlineRow& row) {
    if (row.skipped || !tree.gives_intensity(row.ray)) {
        return std::nullopt;
    }
    const TreeRay<double>& ray = tree.tree.rays[row.ray];
    return ray.shadow ? ray.diffuse + ray.specular : ray.intensity;
}

}  // namespace raytree::inspector
