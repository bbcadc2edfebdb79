#include "state/bounds_details.h"

#include <algorithm>
#include <array>

#include "state/numbers.h"
#include "tree/explain.h"

namespace raytree::inspector {
namespace {

const RayBounds* bounds_of(const PixelTree& tree, std::size_t ray) {
    return tree.bounds && ray < tree.bounds->size() ? &(*tree.bounds)[ray] : nullptr;
}

constexpr int digits = 5;  // of bounds, which are small, two are shown

std::string bound_text(double bound) { return "± " + aligned(std::array{bound}, digits).front(); }

DetailRow bound_row(const std::vector<double>& bounds) {
    return {"   ±", aligned(bounds, digits), DetailRow::Weight::faint, false, {}, bounds};
}
DetailRow bound_row(double bound) { return bound_row(std::vector<double>{bound}); }
DetailRow bound_row(const Rgb<double>& bound) {
    return bound_row(std::vector<double>{bound.r, bound.g, bound.b});
}

/// The row that stands below a row of this label; none where it is no number with a bound.
std::optional<DetailRow> row_below(const std::string& label, const TreeRay<double>& ray,
                                   const RayBounds& bounds) {
    if (label == "origin") {
        return bound_row(bounds.origin);
    }
    if (label == "direction") {
        return bound_row(bounds.direction);
    }
    if (label == "point") {
        return bound_row(bounds.hit.point);
    }
    if (label == "normal n") {
        return bound_row(bounds.hit.normal);
    }
    if (label == "ambient" && ray.hit) {
        return bound_row(noticed(bounds.ambient, ray.intensity));
    }
    if (label == "+ diffuse" || label == "diffuse") {
        return bound_row(noticed(bounds.diffuse, ray.intensity));
    }
    if (label == "+ specular") {
        return bound_row(noticed(bounds.specular, ray.intensity));
    }
    if (label == "weight") {
        return bound_row(bounds.weight);
    }
    if (label == "transmittance") {
        return bound_row(bounds.transmittance);
    }
    if (label == "= intensity") {
        return bound_row(bounds.intensity);
    }
    return std::nullopt;
}

/// Of a single number, the bound stands beside it.
std::optional<double> bound_beside(const std::string& label, const RayBounds& bounds) {
    if (label == "t" || label == "at t") {
        return bounds.hit.t;
    }
    if (label == "distance") {
        return bounds.distance;
    }
    if (label == "sin² θ2") {
        return bounds.hit.sin2_transmitted;
    }
    return std::nullopt;
}

DetailSection doubt_section(const RayBounds& bounds) {
    DetailSection section{"≈ It could have gone either way", {}, {}};
    for (const Doubt& doubt : bounds.doubts) {
        section.sentences.push_back("It is " + doubt.text + ".");
    }
    section.sentences.push_back("The bounds below hold for the way it went.");
    return section;
}

}  // namespace

bool in_doubt(const PixelTree& tree, std::size_t ray) {
    const RayBounds* const bounds = bounds_of(tree, ray);
    return bounds && !bounds->doubts.empty();
}

void add_bounds(std::vector<DetailSection>& sections, const PixelTree& tree, std::size_t ray) {
    const RayBounds* const bounds = bounds_of(tree, ray);
    if (!bounds) {
        return;
    }
    for (DetailSection& section : sections) {
        std::vector<DetailRow> rows;
        for (DetailRow& row : section.rows) {
            const auto beside = bound_beside(row.label, *bounds);
            if (beside && !row.is_text && row.cells.size() == 1) {
                row.cells.push_back(bound_text(*beside));
                row.values.push_back(*beside);
            }
            const auto below = row.is_text || row.values.empty()
                                   ? std::nullopt
                                   : row_below(row.label, tree.tree.rays[ray], *bounds);
            rows.push_back(std::move(row));
            const bool exact = below && std::ranges::all_of(
                                            below->values, [](double bound) { return bound == 0; });
            if (below && !exact) {
                rows.push_back(*below);
            }
        }
        section.rows = std::move(rows);
    }
    if (!bounds->doubts.empty()) {
        sections.insert(sections.begin(), doubt_section(*bounds));
    }
}

}  // namespace raytree::inspector
