#include "state/pixel_tree.h"

#include <array>

#include "check/submission.h"

namespace raytree::inspector {

const MarkText& text_of(RayMark mark) {
    static constexpr std::array<MarkText, 7> texts = {{
        {"", "", ""},
        {"=", "the same", "the same in both"},
        {"≠", "differs", "differs, and here is why"},
        {"~", "follows", "differs because another ray does"},
        {"−", "missing", "in the reference alone"},
        {"+", "extra", "not in the reference"},
        {"╌", "cut away", "was there before the change"},
    }};
    return texts[static_cast<std::size_t>(mark)];
}

RayTree<double> own_tree(const PixelTree& tree) {
    RayTree<double> own = tree.tree;
    own.rays.resize(tree.own());
    return own;
}

bool PixelTree::gives(std::size_t ray, Field field) const {
    return !recorded || !is_own(ray) || recorded->gives(ray, field);
}

bool PixelTree::gives_intensity(std::size_t ray) const {
    return tree.rays[ray].shadow ? gives(ray, Field::diffuse) || gives(ray, Field::specular)
                                 : gives(ray, Field::intensity);
}

std::string number_of(const PixelTree& tree, std::size_t ray) {
    return tree.contrast ? number_of(tree, *tree.contrast, ray) : "#" + std::to_string(ray);
}

std::string number_of(const PixelTree& tree, const Contrast& contrast, std::size_t ray) {
    return tree.is_own(ray) ? "#" + std::to_string(ray)
                            : "(#" + std::to_string(contrast.counterparts[ray].value_or(ray)) + ")";
}

std::string mark_text(RayMark mark) {
    if (mark == RayMark::none || mark == RayMark::same) {
        return {};
    }
    return std::string(text_of(mark).sign) + " " + std::string(text_of(mark).word);
}

}  // namespace raytree::inspector
