#include "state/outline.h"

#include "state/numbers.h"
#include "tree/explain.h"

namespace raytree::inspector {
namespace {

constexpr RayKind order[] = {RayKind::shadow, RayKind::reflected, RayKind::refracted};

class Builder {
  public:
    Builder(const PixelTree& tree, bool ghosts) : tree_(tree), ghosts_(ghosts) {
        outline_.row_of_ray.resize(tree.tree.rays.size());
    }

    Outline build() {
        add({});
        // Rows are visited as they are added: a tree may be deeper than the call stack.
        for (std::size_t row = 0; row < outline_.rows.size(); ++row) {
            if (!outline_.rows[row].skipped) {
                add_children(row);
            }
        }
        return std::move(outline_);
    }

  private:
    std::size_t add(OutlineRow row) {
        const std::size_t place = outline_.rows.size();
        if (!row.skipped) {
            outline_.row_of_ray[row.ray] = place;
        }
        outline_.rows.push_back(std::move(row));
        return place;
    }

    void add_child(std::size_t parent, std::size_t ray, std::optional<std::size_t> skipped) {
        const std::size_t place = outline_.rows[parent].children.size();
        const std::size_t child = add({ray, skipped, parent, place, {}});
        outline_.rows[parent].children.push_back(child);
    }

    void add_children(std::size_t row) {
        const std::size_t id = outline_.rows[row].ray;
        const TreeRay<double>& ray = tree_.tree.rays[id];
        for (const RayKind kind : order) {
            for (const std::size_t child : tree_.children[id]) {
                if (tree_.tree.rays[child].kind == kind) {
                    add_child(row, child, std::nullopt);
                }
            }
            for (std::size_t k = 0; ghosts_ && k < ray.skipped.size(); ++k) {
                if (ray.skipped[k].kind == kind && !told_by_termination(ray, ray.skipped[k])) {
                    add_child(row, id, k);
                }
            }
        }
    }

    const PixelTree& tree_;
    bool ghosts_;
    Outline outline_;
};

std::string named(RayKind kind, const std::string& light) {
    return std::string(word_of(kind)) + (light.empty() ? "" : " → " + light);
}

std::string what_became(const TreeRay<double>& ray) {
    if (ray.shadow->blocked_by) {
        return "blocked by " + ray.shadow->blocked_by->object;
    }
    return reaches_light(ray) ? "reaches the light" : "does not reach the light";
}

}  // namespace

Outline outline_of(const PixelTree& tree, bool ghosts) { return Builder(tree, ghosts).build(); }

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
        texts.met = what_became(ray);
        if (ray.shadow->blocked_by || ray.shadow->distance) {
            texts.t = number_text(ray.shadow->blocked_by ? ray.shadow->blocked_by->t
                                                         : *ray.shadow->distance);
        }
        texts.intensity = rgb_text(ray.diffuse + ray.specular);
        return texts;
    }
    texts.met = ray.hit ? ray.hit->object + (ray.hit->side == Side::back ? ", back" : "") : "nothing";
    texts.t = ray.hit ? number_text(ray.hit->t) : "";
    texts.intensity = rgb_text(ray.intensity);
    texts.ended = ended_text(tree.tree, ray);
    return texts;
}

std::optional<Rgb<double>> swatch_of(const PixelTree& tree, const OutlineRow& row) {
    if (row.skipped) {
        return std::nullopt;
    }
    const TreeRay<double>& ray = tree.tree.rays[row.ray];
    return ray.shadow ? ray.diffuse + ray.specular : ray.intensity;
}

}  // namespace raytree::inspector
