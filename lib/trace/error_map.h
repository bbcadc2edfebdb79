#pragma once

#include "trace/render.h"

namespace raytree {

/// A picture in the arithmetic T, and how far each of its pixels is from the same pixel in the
/// reference arithmetic.
struct ErrorMap {
    Picture picture;
    /// |picture - reference| of the channel that is the farthest off; the difference is taken in
    /// the reference arithmetic, so that less than a unit in the last place is seen too. In the
    /// unit of intensities: 1 is white.
    std::vector<double> errors;
};

/// Traces every pixel twice. The worlds must be of the same scene.
template <class T> ErrorMap render_error(const World<T>& world, const World<Quad>& reference,
                                         const RenderOptions& options = {});

}  // namespace raytree
