#pragma once

#include <string>
#include <vector>

#include "drawing/extent.h"
#include "drawing/mesh.h"
#include "state/explanation.h"
#include "state/state.h"

namespace raytree::inspector {

/// What the features shown put into the 3D view.
struct ExplainedMesh {
    Mesh faces;  ///< see-through
    Mesh solid;
    Lines lines;
};

/// A word beside a place.
struct ExplainedMark {
    Point3 at;
    std::string words;
};

ExplainedMesh explained_mesh(const State& state, const Extent& extent, const View& view);
std::vector<ExplainedMark> explained_marks(const State& state, const Extent& extent);

}  // namespace raytree::inspector
