#include "view3d/picture_image.h"

namespace raytree::inspector {

vtkNew<vtkImageData> image_of(int columns, int rows, const std::vector<std::uint32_t>& pixels,
                              int by) {
    vtkNew<vtkImageData> image;
    image->SetDimensions(columns / by, rows / by, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* byte = static_cast<unsigned char*>(image->GetScalarPointer());
    const int many = by * by;
    for (int row = 0; row < rows / by; ++row) {
        for (int column = 0; column < columns / by; ++column) {
            int red = 0, green = 0, blue = 0;
            for (int k = 0; k < many; ++k) {
                const auto at = static_cast<std::size_t>(row * by + k / by) *
                                    static_cast<std::size_t>(columns) +
                                static_cast<std::size_t>(column * by + k % by);
                red += pixels[at] >> 16 & 255;
                green += pixels[at] >> 8 & 255;
                blue += pixels[at] & 255;
            }
            for (const int sum : {red, green, blue}) {
                *byte++ = static_cast<unsigned char>((sum + many / 2) / many);
            }
        }
    }
    return image;
}

}  // namespace raytree::inspector
