#include "state/neighbours.h"

namespace raytree::inspector {

std::vector<Pixel> neighbours_of(Pixel pixel, Neighbours which, const Camera& camera) {
    constexpr int far = 4;
    const int across = which == Neighbours::square ? 1 : which == Neighbours::row ? far : 0;
    const int along = which == Neighbours::square ? 1 : which == Neighbours::column ? far : 0;
    std::vector<Pixel> all;
    for (int j = pixel.j - along; j <= pixel.j + along; ++j) {
        for (int i = pixel.i - across; i <= pixel.i + across; ++i) {
            const bool inside = i >= 0 && j >= 0 && i < camera.width && j < camera.height;
            if (inside && Pixel{i, j} != pixel) {
                all.push_back({i, j});
            }
        }
    }
    return all;
}

}  // namespace raytree::inspector
