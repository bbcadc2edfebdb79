#pragma once

#include <vector>

#include "trace/world.h"

namespace raytree {

/// What the z-buffer algorithm (Catmull, 1974) does in one pixel: objects come in the order of the
/// scene, and each that covers the pixel is written where it is nearer than what is there.
struct ZBufferStep {
    std::size_t object = 0;  ///< place in Scene::objects
    double z = 0;            ///< depth along the view, in eye space
    double t = 0;            ///< distance along the pixel's ray
    bool written = false;    ///< nearer than all before
};

/// The objects that cover the sample point of pixel (i, j), which must lie in the picture. The last
/// one written is what is seen.
std::vector<ZBufferStep> z_buffer_at(const World<double>& world, int i, int j);

}  // namespace raytree
