#include <cmath>
#include <utility>

#include "formats/obj.h"

namespace raytree {
namespace {

constexpr double kFovDegrees = 40;
/// How much of the picture's smaller side the mesh's bounding sphere fills.
constexpr double kFilled = 0.85;
/// From the mesh to the eye: from the front, somewhat from the right and from above.
const Point kTowardsEye{0.55, 0.45, 1};
/// From the mesh to the key light: over the viewer's left shoulder.
const Point kTowardsLight{-0.6, 1.4, 1};
constexpr double kLightDistance = 10;  // in radii of the bounding sphere

struct Ball {
    Point center;
    double radius;
};

Ball bounding_ball(const Mesh& mesh) {
    const auto at = [&](const Mesh::Corner& corner) -> const Point& {
        return mesh.vertices[static_cast<std::size_t>(corner.vertex)];
    };
    Point low = at(mesh.triangles[0][0]);
    Point high = low;
    for (const Mesh::Triangle& triangle : mesh.triangles) {
        for (const Mesh::Corner& corner : triangle) {
            for (int axis = 0; axis < 3; ++axis) {
                low[axis] = min_of(low[axis], at(corner)[axis]);
                high[axis] = max_of(high[axis], at(corner)[axis]);
            }
        }
    }
    Ball ball{low / 2.0 + high / 2.0, 0};
    for (const Mesh::Triangle& triangle : mesh.triangles) {
        for (const Mesh::Corner& corner : triangle) {
            ball.radius = max_of(ball.radius, length(at(corner) - ball.center));
        }
    }
    return ball;
}

Camera framing(const Ball& ball, int width, int height) {
    Camera camera;
    camera.width = width;
    camera.height = height;
    camera.window = HorizontalFov{kFovDegrees};
    const double half_width = std::tan(kFovDegrees / 2 * Real<double>::pi / 180);
    const double half_smaller = half_width * std::min(1.0, static_cast<double>(height) / width);
    // The ball's outline is a cone around the view with sin(half angle) = radius / distance.
    const double distance = ball.radius / std::sin(std::atan(kFilled * half_smaller));
    camera.look_at = ball.center;
    camera.eye = ball.center + distance * UnitVec3<double>::of(kTowardsEye).vec();
    return camera;
}

}  // namespace

Scene scene_around(Mesh mesh, const std::string& name, int width, int height) {
    const Ball ball = bounding_ball(mesh);
    Scene scene;
    scene.name = name;
    scene.camera = framing(ball, width, height);
    scene.background = {0.55, 0.65, 0.75};
    Light key;
    key.name = "key";
    key.kind = PointLight{
        ball.center + kLightDistance * ball.radius * UnitVec3<double>::of(kTowardsLight).vec(), {}};
    scene.lights.push_back(std::move(key));
    Material surface;
    surface.name = "surface";
    surface.ka = Colour(0.2);
    surface.ks = Colour(0.2);
    scene.materials.push_back(std::move(surface));
    Object object;
    object.name = "mesh0";
    object.shape = std::move(mesh);
    scene.objects.push_back(std::move(object));
    return scene;
}

}  // namespace raytree
