#pragma once

#include <vtkImageData.h>
#include <vtkNew.h>

#include <cstdint>
#include <vector>

namespace raytree::inspector {

/// A picture, 0xFFRRGGBB row by row, for a texture. Each of its pixels is the mean of `by` times
/// `by` of the picture's; what is left over at the edges is left out.
vtkNew<vtkImageData> image_of(int columns, int rows, const std::vector<std::uint32_t>& pixels,
                              int by);

}  // namespace raytree::inspector
