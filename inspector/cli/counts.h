#pragma once

#include <string>

#include "trace/counting.h"

namespace raytree::cli {

/// The document that `render --counts` writes.
std::string counts_json(const RayCounts& counts);

}  // namespace raytree::cli
