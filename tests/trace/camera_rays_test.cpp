#include "trace/camera_rays.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace raytree;
using doctest::Approx;

namespace {

Camera camera_of(int width, int height) {
    Camera camera;
    camera.eye = {1, 2, 3};
    camera.look_at = {1, 2, -7};
    camera.window = HorizontalFov{90};  // tan θ = 1
    camera.width = width;
    camera.height = height;
    return camera;
}

void check_direction(const Ray<double>& ray, double x, double y) {
    const double scale = std::sqrt(x * x + y * y + 1);
    CHECK(ray.direction.x == Approx(x / scale).epsilon(1e-15));
    CHECK(ray.direction.y == Approx(y / scale).epsilon(1e-15));
    CHECK(ray.direction.z == Approx(-1 / scale).epsilon(1e-15));
}

}  // namespace

TEST_CASE("camera: pixel centres lie on the grid of the lecture") {
    const CameraRays<double> rays(camera_of(4, 2), PixelSample::center);
    // Pixels are 0.5 wide: xp = -0.75, -0.25, 0.25, 0.75; two rows of 0.5 about 0.
    check_direction(rays.primary(0, 0), -0.75, 0.25);
    check_direction(rays.primary(3, 0), 0.75, 0.25);
    check_direction(rays.primary(1, 1), -0.25, -0.25);
    CHECK(rays.primary(2, 1).origin.x == 1);
    CHECK(rays.primary(2, 1).origin.z == 3);
}

TEST_CASE("camera: corner samples have no half pixel") {
    const CameraRays<double> rays(camera_of(4, 2), PixelSample::corner);
    check_direction(rays.primary(0, 0), -1, 0.5);
    check_direction(rays.primary(2, 1), 0, 0);
}

TEST_CASE("camera: a window on the image plane may be off centre") {
    Camera camera = camera_of(4, 2);
    camera.window = ImagePlane{0, 4, -1, 3};
    const CameraRays<double> rays(camera, PixelSample::center);
    check_direction(rays.primary(0, 0), 0.5, 2);
    check_direction(rays.primary(3, 1), 3.5, 0);
}

TEST_CASE("camera: an up that is not across the view is made so, and Vx is to the right") {
    Camera camera = camera_of(3, 3);
    camera.up = {0, 1, -5};
    const CameraRays<double> rays(camera, PixelSample::center);
    CHECK(rays.right().vec().x == Approx(1));
    CHECK(rays.up().y == Approx(1));
    check_direction(rays.primary(1, 1), 0, 0);
}

TEST_CASE("camera: the near distance is measured along the view") {
    Camera camera = camera_of(4, 2);
    camera.near = 2;
    const CameraRays<double> rays(camera, PixelSample::center);
    const auto ray = rays.primary(3, 0);
    CHECK(rays.near_along(ray.direction) == Approx(2 * std::sqrt(1 + 0.75 * 0.75 + 0.25 * 0.25)));
}
