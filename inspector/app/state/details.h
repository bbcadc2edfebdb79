#pragma once

#include <optional>
#include <string>
#include <vector>

#include "state/state.h"

namespace raytree::inspector {

/// A line of the details: a label and one to three numbers below those of the other lines, or one
/// text.
struct DetailRow {
    enum class Weight { normal, faint, strong };

    std::string label;
    std::vector<std::string> cells;
    Weight weight = Weight::normal;
    bool is_text = false;  ///< the cell is words, not a number
    std::optional<Rgb<double>> swatch;
    std::vector<double> values = {};     ///< of the cells that are numbers, with every digit
    std::vector<std::size_t> rays = {};  ///< of each text cell: the ray that it names
};

struct DetailSection {
    std::string title;
    std::vector<DetailRow> rows;
    std::vector<std::string> sentences;  ///< below the rows
};

/// Everything that is known of a ray.
std::vector<DetailSection> details_of(const PixelTree& tree, std::size_t ray);

/// "#5 refracted ray" and the like: what a ray is called in headings.
std::string title_of(const TreeRay<double>& ray);

/// For the status bar: the pixel's intensity, its 8-bit value, and what was clamped.
std::string pixel_text(const RayTree<double>& tree);
/// The number of rays beside the largest that a tree of this depth could have.
std::string counts_text(const RayTree<double>& tree);
/// Raw and 8-bit value of an intensity, for the pixel under the cursor.
std::string value_text(const Rgb<double>& intensity, Quantize quantize);

}  // namespace raytree::inspector
