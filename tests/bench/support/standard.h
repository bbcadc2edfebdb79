#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

/// Scenes in the manner of the Standard Procedural Databases (Haines, "A proposal for standard
/// graphics environments", IEEE CG&A 7(11), 1987), made anew here at about their default sizes.
namespace raytree::bench {

const std::vector<std::string>& standard_names();

/// One of `standard_names()`: 512 x 512 pixels, depth 5. From `folder`/nff/NAME.nff if that is
/// there, else generated.
Scene standard_scene(const std::string& name, const std::string& folder);

}  // namespace raytree::bench
