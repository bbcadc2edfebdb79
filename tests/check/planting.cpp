#include "check/planting.h"

#include <algorithm>
#include <cmath>

#include "check/forge.h"
#include "formats/tree_json.h"
#include "scene/input_error.h"

namespace raytree::test {

bool finite(const RayTree<double>& tree) {
    for (std::size_t ray = 0; ray < tree.rays.size(); ++ray) {
        for (std::size_t k = 0; k < field_count; ++k) {
            const check::Numbers numbers = check::numbers_of(tree, ray, static_cast<Field>(k));
            if (!std::ranges::all_of(numbers.x, [](double x) { return std::isfinite(x); })) {
                return false;
            }
        }
    }
    return isfinite(tree.intensity);
}

std::string planted(const check::Checker& checker, const check::MistakeRow& row, const Spot& spot) {
    check::Laws laws = check::model_laws();
    row.apply(laws);
    try {
        const RayTree<double> tree = check::forge_tree(checker.place(), laws, spot.i, spot.j);
        const std::string text = write_tree_json(tree);
        const bool numbers =
            text.find("nan") == std::string::npos && text.find(" inf") == std::string::npos;
        return tree.rays.size() < 3000 && numbers ? text : "";
    } catch (const InputError&) {
        return "";
    }
}

}  // namespace raytree::test
