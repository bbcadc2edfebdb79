#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "support/picture_steps.h"
#include "trace/render.h"

/// How far pictures and rays are from the reference arithmetic's.
namespace raytree::bench {

/// Worst and root mean square of errors.
struct Errors {
    double worst = 0;
    double squares = 0;
    double count = 0;

    void add(double error);
    double rms() const { return count > 0 ? std::sqrt(squares / count) : NAN; }
};

/// What rounding alone does, at the truth's settings.
struct Rounding {
    std::string name;
    Errors distance;                ///< of a hit, relative
    Errors place;                   ///< of a hit point, as a share of the scene's size
    std::vector<Errors> direction;  ///< by the number of bounces
    Errors intensity;
    std::size_t other_shape = 0;
};

/// Of each pixel of a picture, row by row.
using Truth = std::vector<Steps<Quad>>;

template <class Visit> void for_each_pixel(const Scene& scene, Visit&& visit) {
    for (int j = 0; j < scene.camera.height; ++j) {
        for (int i = 0; i < scene.camera.width; ++i) {
            visit(i, j);
        }
    }
}

template <class T> std::vector<Steps<T>> all_steps(const World<T>& world);

/// Over pixels and channels; a pixel brighter than `largest` in truth is left out.
Errors picture_errors(const Picture& picture, const Truth& truth, double largest);

/// Pixels whose tree has another shape than in truth.
template <class T> std::size_t other_shapes(const std::vector<Steps<T>>& own, const Truth& truth);

/// `size`: the scene's.
template <class T> Rounding rounding_of(const std::string& name, const std::vector<Steps<T>>& own,
                                        const Truth& truth, double size);

}  // namespace raytree::bench
