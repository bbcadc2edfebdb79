#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace raytree {

/// One way to compute a picture: the time that it takes and how far it is off.
struct WorkPoint {
    std::string label;   ///< "float", "double", "reference"; "3 levels" of a tree that is cut there
    double seconds = 0;  ///< for a pixel, of one thread's processor time
    /// Root mean square over pixels and channels against the reference arithmetic at the scene's
    /// own settings, in the unit of intensities (1 is white); 0 for the reference itself.
    double error = 0;
    bool operator==(const WorkPoint&) const = default;
};

/// What a smaller error costs.
struct WorkPrecision {
    std::size_t pixels = 0;              ///< of the picture, that were traced
    std::vector<WorkPoint> arithmetics;  ///< float, double, reference, at the scene's own settings
    std::vector<WorkPoint> levels;       ///< in double, with fewer levels than the scene allows
    bool operator==(const WorkPrecision&) const = default;
};

/// Traces some pixels of the picture, evenly spread, in about a second: as many as have about
/// 16,000 rays, from 64 to 1,024. The times differ from run to run, pixels and errors do not.
WorkPrecision measure_work_precision(const Scene& scene);

}  // namespace raytree
