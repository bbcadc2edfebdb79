#include "trace/error_map.h"

#include "trace/picture_tiles.h"
#include "trace/tracer.h"

namespace raytree {
namespace {

template <class T> Rgb<Quad> difference(const Rgb<T>& own, const Rgb<Quad>& exact) {
    return {abs(Quad(own.r) - exact.r), abs(Quad(own.g) - exact.g), abs(Quad(own.b) - exact.b)};
}

}  // namespace

template <class T> ErrorMap render_error(const World<T>& world, const World<Quad>& reference,
                                         const RenderOptions& options) {
    const Camera& camera = world.scene().camera;
    const std::size_t pixels =
        static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
    ErrorMap map{{camera.width, camera.height, std::vector<Rgb<double>>(pixels)},
                 std::vector<double>(pixels)};
    for_each_tile(camera.width, camera.height, options, [&](const Tile& t) {
        NoRecorder<T> silent;
        NoRecorder<Quad> silent_too;
        Tracer<T, NoRecorder<T>> tracer(world, silent);
        Tracer<Quad, NoRecorder<Quad>> exact(reference, silent_too);
        for (int j = t.rows().begin(); j < t.rows().end(); ++j) {
            for (int i = t.cols().begin(); i < t.cols().end(); ++i) {
                const std::size_t k =
                    static_cast<std::size_t>(j) * static_cast<std::size_t>(camera.width) +
                    static_cast<std::size_t>(i);
                const Rgb<T> own = tracer.trace_pixel(i, j);
                map.picture.pixels[k] = rgb_cast<double>(own);
                map.errors[k] = static_cast<double>(
                    largest_component(difference(own, exact.trace_pixel(i, j))));
            }
        }
    });
    return map;
}

template ErrorMap render_error<float>(const World<float>&, const World<Quad>&,
                                      const RenderOptions&);
template ErrorMap render_error<double>(const World<double>&, const World<Quad>&,
                                       const RenderOptions&);
template ErrorMap render_error<Quad>(const World<Quad>&, const World<Quad>&, const RenderOptions&);

}  // namespace raytree
