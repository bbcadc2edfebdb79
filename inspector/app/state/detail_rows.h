#pragma once

#include <array>
#include <string>
#include <utility>

#include "state/details.h"
#include "state/numbers.h"

/// The usual rows of details: a label, and words, a number or a triple beside it.
namespace raytree::inspector {

inline DetailRow text_row(std::string label, std::string text) {
    return {std::move(label), {std::move(text)}, DetailRow::Weight::normal, true, {}};
}

inline DetailRow number_row(std::string label, double value) {
    return {std::move(label), aligned(std::array{value}), DetailRow::Weight::normal, false, {},
            {value}};
}

inline DetailRow triple_row(std::string label, const Vec3<double>& v) {
    return {std::move(label), aligned(v), DetailRow::Weight::normal, false, {}, {v.x, v.y, v.z}};
}

inline DetailRow triple_row(std::string label, const Rgb<double>& c) {
    return {std::move(label), aligned(c), DetailRow::Weight::normal, false, {}, {c.r, c.g, c.b}};
}

/// Above the columns of triples.
inline DetailRow heading_row(std::vector<std::string> cells) {
    return {"", std::move(cells), DetailRow::Weight::faint, false, {}};
}

}  // namespace raytree::inspector
