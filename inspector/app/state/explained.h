#pragma once

#include <optional>

#include "lesson/lesson.h"
#include "trace/time_share.h"
#include "trace/work_precision.h"

namespace raytree::inspector {

/// What is shown of a scene besides its rays: the lecture's ways of explaining what a ray does, or
/// of doing without it.
struct Explained {
    bool eye_space = false;  ///< coordinates in eye space in the details
    bool z_buffer = false;   ///< the z-buffer's answer for the pixel
    std::optional<lesson::ShowerShown> shower;
    std::optional<lesson::TraversalShown> traversal;
    std::optional<lesson::VolumesShown> volumes;
    std::optional<lesson::DepthShown> depth;
    std::optional<lesson::CrossingsShown> crossings;
    std::optional<TimeShare> time;  ///< where the time goes, as measured when it was asked for
    std::optional<WorkPrecision> accuracy;  ///< run time against error, likewise

    bool operator==(const Explained&) const = default;
    bool nothing() const {
        return !z_buffer && !shower && !traversal && !volumes && !depth && !crossings && !time &&
               !accuracy;
    }
};

}  // namespace raytree::inspector
