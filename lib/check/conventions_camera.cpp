#include <algorithm>
#include <cmath>

#include "check/convention_tables.h"

namespace raytree::check {
namespace {

/// The window that the camera has, whichever way it is given.
ImagePlane& window_of(Scene& scene) {
    Camera& camera = scene.camera;
    if (const auto* fov = std::get_if<HorizontalFov>(&camera.window)) {
        const double x = std::tan(fov->degrees * Real<double>::pi / 360);
        const double y = x * camera.height / camera.width;
        camera.window = ImagePlane{-x, x, -y, y};
    }
    return std::get<ImagePlane>(camera.window);
}

void sample_lower_left(Scene& scene) {
    ImagePlane& window = window_of(scene);
    const double row = (window.top - window.bottom) / scene.camera.height;
    window.top -= row;
    window.bottom -= row;
    scene.settings.pixel_sample = PixelSample::corner;
}

/// The first and the last pixel on the window's edges: it is as much wider as a pixel more.
void sample_edges(Scene& scene) {
    ImagePlane& window = window_of(scene);
    const auto stretched = [](double from, double to, int pixels) {
        return pixels > 1 ? from + (to - from) * pixels / (pixels - 1) : to;
    };
    window.right = stretched(window.left, window.right, scene.camera.width);
    window.bottom = stretched(window.top, window.bottom, scene.camera.height);
    scene.settings.pixel_sample = PixelSample::corner;
}

void rows_from_below(Scene& scene) {
    ImagePlane& window = window_of(scene);
    std::swap(window.top, window.bottom);
}

/// A window that follows from an angle of view, `factor` times as large; one that the scene gives
/// stays as it is.
void zoom_out(Scene& scene, double factor) {
    if (std::holds_alternative<HorizontalFov>(scene.camera.window)) {
        ImagePlane& window = window_of(scene);
        for (double* edge : {&window.left, &window.right, &window.bottom, &window.top}) {
            *edge *= factor;
        }
    }
}

void vertical_fov(Scene& scene) {
    zoom_out(scene, static_cast<double>(scene.camera.width) / scene.camera.height);
}

void fov_to_the_edge(Scene& scene) {
    if (const auto* fov = std::get_if<HorizontalFov>(&scene.camera.window)) {
        const double half = fov->degrees * Real<double>::pi / 360;
        if (2 * half < Real<double>::pi / 2) {  // beyond it there is no such picture
            zoom_out(scene, std::tan(2 * half) / std::tan(half));
        }
    }
}

Interval<double> near_for_all(const Place& place, const Step& step) {
    Interval<double> interval = model::interval(place, step);
    interval.from = std::max(interval.from, place.scene().camera.near);
    return interval;
}

}  // namespace

const std::vector<Convention>& camera_conventions() {
    static const std::vector<Convention> table = {
        // First: the others make a window of the angle.
        {"fov", "horizontal", "the angle of view is the horizontal one", nullptr, nullptr, ""},
        {"fov", "vertical", "the angle of view is the vertical one", vertical_fov, nullptr,
         "cam.fov_horizontal"},
        {"fov", "to-the-edge", "the angle of view is that from the middle to the edge",
         fov_to_the_edge, nullptr, "cam.fov_not_halved"},
        {"sample", "scene", "rays go through the pixel where the scene says", nullptr, nullptr, ""},
        {"sample", "centre", "rays go through the middle of the pixel",
         [](Scene& scene) { scene.settings.pixel_sample = PixelSample::center; }, nullptr,
         "cam.half_added_twice"},
        {"sample", "corner", "rays go through the upper left corner of the pixel",
         [](Scene& scene) { scene.settings.pixel_sample = PixelSample::corner; }, nullptr,
         "cam.no_half"},
        {"sample", "corner-bl", "rays go through the lower left corner of the pixel",
         sample_lower_left, nullptr, "cam.no_half"},
        {"sample", "edges", "the first and the last pixel lie on the window's edges", sample_edges,
         nullptr, "cam.wminus1"},
        {"rows", "down", "rows are counted from above", nullptr, nullptr, ""},
        {"rows", "up", "rows are counted from below", rows_from_below, nullptr, "cam.y_flipped"},
        {"near", "primary", "primary rays do not see what is nearer than the near distance",
         nullptr, nullptr, ""},
        {"near", "all", "no ray sees what is nearer than the near distance", nullptr,
         [](Laws& laws) { laws.interval = near_for_all; }, "hit.near_rule_on_secondary"},
        {"near", "image-plane",
         "primary rays do not see what is nearer than the plane at distance 1",
         [](Scene& scene) { scene.camera.near = 1; }, nullptr, ""},
        {"near", "none", "the near distance has no effect",
         [](Scene& scene) { scene.camera.near = 0; }, nullptr, "hit.primary_without_near"},
    };
    return table;
}

}  // namespace raytree::check
