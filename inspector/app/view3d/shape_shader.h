#pragma once

#include <string>

#include "state/palette.h"

/// How shapes are drawn, as code that takes the place of a part of VTK's fragment shader. It reads
/// the alpha of colours as SceneMesh tells.
namespace raytree::inspector {

/// The part of VTK's shader in whose place it stands.
inline constexpr const char* shape_shader_place = "//VTK::Light::Impl";

/// Where a round surface turns away from the viewer it is firmer, and its colour turns into that of
/// lines.
std::string see_through_code(Ink line);

/// Only what goes on far beyond the view fades out.
std::string solid_code();

}  // namespace raytree::inspector
