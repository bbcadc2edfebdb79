#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <vector>

#include "formats/json_reader.h"
#include "trace/reason.h"

namespace raytree {

/// More levels than any tracer's limit; a tree that goes deeper was grown by a mistake.
inline constexpr std::size_t most_tree_levels = 1000;

/// A ray of a raytree document, and where it stands in the tree.
struct ShapedRay {
    const Json* members = nullptr;     ///< an object of the document
    const JsonPlace* place = nullptr;  ///< of it
    RayKind kind = RayKind::primary;
    std::string id;
    std::size_t parent = 0;  ///< place in TreeShape::rays; of the first, itself
    int level = 1;
};

/// How the rays of a raytree document hang together, whether nested or by their `parent`.
struct TreeShape {
    std::vector<ShapedRay> rays;   ///< depth first: a ray, its shadow rays, reflected, refracted
    std::deque<JsonPlace> places;  ///< that rays refer to
};

/// Reads the shape alone from the document's `rays`. Throws InputError for what is no tree with one
/// primary ray at its root, and with what `report` already held.
TreeShape read_tree_shape(const Json& document, JsonReport& report);

}  // namespace raytree
