#pragma once

#include <functional>
#include <vector>

#include "trace/counting.h"
#include "trace/world.h"

namespace raytree {

/// A picture of linear, unclamped intensities, row by row from the top left.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<Rgb<double>> pixels;

    const Rgb<double>& at(int i, int j) const {
        return pixels[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(i)];
    }
};

/// What can be measured of each pixel's tree.
enum class Measure { rays, levels, tests, nanoseconds, ended };

struct RenderOptions {
    int threads = 0;  ///< 0: all cores
    /// Called now and then, from any thread, with the share done so far, 0 to 1. Returning false
    /// cancels: the picture comes back with its missing pixels black.
    std::function<bool(double)> progress;
};

struct Measurement {
    Picture picture;
    std::vector<double> map;  ///< a value for each pixel; for Measure::ended the Reason's number
    RayCounts counts;
};

/// Traces every pixel of the scene's camera. The result does not depend on the number of threads.
template <class T> Picture render(const World<T>& world, const RenderOptions& options = {});

/// The same picture, with what it took.
template <class T> Measurement render_measured(const World<T>& world, Measure measure,
                                               const RenderOptions& options = {});

}  // namespace raytree
