#pragma once

#include <vector>

#include "state/details.h"
#include "state/document.h"

namespace raytree::inspector {

/// The terms of illumination at a hit with their factors (model, section 3), of a tree that was
/// traced: of a shadow ray, how its diffuse and specular come about; of a ray that hits, its
/// ambient term, and the lights one by one where no shadow rays are traced. Empty where there is
/// nothing.
std::vector<DetailSection> lighting_details(const Document& document, const PixelTree& tree,
                                            std::size_t ray);

}  // namespace raytree::inspector
