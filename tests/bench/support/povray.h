#pragma once

#include <string>

#include "trace/render.h"

/// POV-Ray (Debian's povray), as another program on the same scene.
namespace raytree::bench {

/// Nothing: the scene means the same there. Otherwise what it has that POV-Ray has not.
std::string povray_why_not(const Scene& scene);

/// The scene in POV-Ray's language, as far as povray_why_not has nothing against it.
std::string povray_text(const Scene& scene);

struct PovrayRun {
    Picture picture;             ///< 16 bits a channel, clamped to 1
    double seconds_a_pixel = 0;  ///< of processor time, without reading the scene
};

/// Runs the program in a folder of its own, twice, the second picture with 16 times the pixels:
/// what the difference takes is the tracing. Throws where it fails.
PovrayRun run_povray(const Scene& scene);

}  // namespace raytree::bench
