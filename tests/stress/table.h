#pragma once

#include <string>
#include <vector>

#include "stress.h"

namespace raytree::stress {

/// "10^8 rays: 0 wrong, 12 undecided; worst 0.31 of ...", and the same for float.
std::string outcome_text(const Row& row, const Tally& tally);

/// Puts the row's figures into the table of a Markdown file, between the lines `<!-- table -->` and
/// `<!-- /table -->`; the other rows stay as they are, those without figures say so.
void update_table(const std::string& file, const std::vector<Row>& rows, const Row& row,
                  const Tally& tally, std::uint64_t seed, double seconds);

}  // namespace raytree::stress
