#include "trace/ray_list.h"

namespace raytree {

template <class T> std::vector<ListedRay<T>> rays_of_pixel(const World<T>& world, int i, int j) {
    RayListRecorder<T> recorder(world);
    Tracer<T, RayListRecorder<T>>(world, recorder).trace_pixel(i, j);
    return std::move(recorder.rays);
}

template <class T>
std::vector<ListedRay<T>> rays_of_picture(const World<T>& world, std::size_t stride) {
    const auto width = static_cast<std::size_t>(world.scene().camera.width);
    const auto height = static_cast<std::size_t>(world.scene().camera.height);
    RayListRecorder<T> recorder(world);
    Tracer<T, RayListRecorder<T>> tracer(world, recorder);
    for (std::size_t pixel = 0; pixel < width * height; pixel += stride) {
        recorder.begin_tree();
        tracer.trace_pixel(static_cast<int>(pixel % width), static_cast<int>(pixel / width));
    }
    return std::move(recorder.rays);
}

template std::vector<ListedRay<float>> rays_of_pixel(const World<float>&, int, int);
template std::vector<ListedRay<double>> rays_of_pixel(const World<double>&, int, int);
template std::vector<ListedRay<float>> rays_of_picture(const World<float>&, std::size_t);
template std::vector<ListedRay<double>> rays_of_picture(const World<double>&, std::size_t);

}  // namespace raytree
