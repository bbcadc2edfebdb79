#pragma once

#include <string_view>
#include <vector>

#include "scene/scene.h"

/// The words of raytree-scene for enumerations, in the order of the enumerators.
namespace raytree {

using Words = std::vector<std::string_view>;

inline const Words kSpecularModelWords{"phong", "blinn"};
inline const Words kShadowModeWords{"opaque", "transmissive", "none"};
inline const Words kTotalReflectionWords{"drop", "reflect"};
inline const Words kPixelSampleWords{"center", "corner"};
inline const Words kQuantizeWords{"round", "floor"};
inline const Words kLightTypeWords{"point", "directional"};               ///< as in Light::kind
inline const Words kShapeTypeWords{"sphere", "polygon", "cone", "mesh"};  ///< as in Shape

template <class Enumeration> std::string_view word_of(const Words& words, Enumeration value) {
    return words[static_cast<std::size_t>(value)];
}

/// The type of a shape in words; with its place in the list of objects, the object's default name.
inline std::string_view type_word(const Shape& shape) { return kShapeTypeWords[shape.index()]; }

}  // namespace raytree
