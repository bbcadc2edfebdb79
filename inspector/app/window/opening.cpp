#include "window/opening.h"

#include "drawing/extent.h"
#include "state/start_pixel.h"

namespace raytree::inspector {

Opened open_for_window(const std::filesystem::path& file,
                       const std::optional<std::filesystem::path>& scene_of_tree) {
    Opened opened = open_file(file, scene_of_tree);
    if (!opened.pixel) {
        opened.pixel = start_pixel(*opened.document);
    }
    extent_of(*opened.document);
    return opened;
}

}  // namespace raytree::inspector
