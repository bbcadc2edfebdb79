#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tree/explain.h"

namespace raytree {

/// A line of a sum: its label is a channel's name, "each" where all channels are equal, or empty
/// for the line that has the symbols.
struct SumLine {
    std::string label;
    std::string text;
};

/// "I = ambient + diffuse + ..." in symbols and, term under term, in numbers: a line for each
/// channel. Terms that are beyond `room` columns stand below the others, under symbols of their
/// own.
std::vector<SumLine> sum_lines(const Rgb<double>& intensity, const std::vector<Term>& terms,
                               std::size_t room);

}  // namespace raytree
