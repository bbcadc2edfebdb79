#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "check/submission.h"
#include "trace/reason.h"

namespace raytree::check {

/// A number, a vector, a colour, a name, or nothing.
struct Value {
    Numbers numbers;
    std::string word;
    bool none() const { return numbers.size == 0 && word.empty(); }
};

enum class Problem {
    differs,  ///< a quantity is not what follows from the ray's own inputs
    missing,  ///< a ray that there should be
    extra,    ///< a ray that there should not be
    whole,    ///< what concerns the submission as a whole: `subject` and `reason` say it
};

/// One thing that is wrong with a submission.
struct Finding {
    Problem problem = Problem::differs;
    std::size_t ray = 0;  ///< of the submission; of a missing ray: its parent
    RayKind kind = RayKind::primary;
    int level = 1;
    Field field = Field::intensity;  ///< where it differs
    std::string light;               ///< of a shadow ray
    std::string subject;             ///< "pixel", "camera", ...: of the whole
    std::string reason;              ///< why an extra ray should not be there
    Value expected, found;
    double error = 0;  ///< relative to the size of the quantity
    /// Place of the finding that causes this one: it alone is not what follows from the ray's own
    /// inputs. None for a cause.
    std::optional<std::size_t> follows_from;
};

/// What is wrong, for telling one difference from another.
inline std::uint64_t key_of(const Finding& finding) {
    const auto what = finding.problem == Problem::differs
                          ? static_cast<std::uint64_t>(place_of(finding.field))
                          : static_cast<std::uint64_t>(finding.kind);
    return (finding.ray * 4 + static_cast<std::uint64_t>(finding.problem)) * 64 + what;
}

}  // namespace raytree::check
