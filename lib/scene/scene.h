#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "math/rgb.h"
#include "math/vector.h"
#include "scene/affine.h"

/// A scene as it is described: what every file format is read into and written from. All numbers
/// are the doubles nearest to those in the file. A Scene that a reader or `validate` has passed
/// keeps every range stated here.
namespace raytree {

using Point = Vec3<double>;
using Colour = Rgb<double>;

/// The window on the plane at distance 1 from the eye, in eye space: left < right, bottom < top.
struct ImagePlane {
    double left = -1;
    double right = 1;
    double bottom = -1;
    double top = 1;
};

/// The full horizontal angle of view, in degrees, over 0 and under 180.
struct HorizontalFov {
    double degrees = 50;
};

struct Camera {
    Point eye{0, 0, 0};
    Point look_at{0, 0, -1};
    Point up{0, 1, 0};
    std::variant<HorizontalFov, ImagePlane> window = HorizontalFov{};
    double near = 0;  ///< what lies closer along the view is not seen by primary rays; >= 0
    int width = 640;  ///< pixels, 1 to 65535; width * height at most 2^28
    int height = 480;
};

/// `1 / (a + b t + c t^2)`, never above 1; each coefficient >= 0, not all 0.
struct Attenuation {
    double a = 1;
    double b = 0;
    double c = 0;
    bool operator==(const Attenuation&) const = default;
};

enum class SpecularModel { phong, blinn };
enum class ShadowMode { opaque, transmissive, none };
enum class TotalReflection { drop, reflect };
enum class PixelSample { center, corner };
enum class Quantize { round, floor };

struct Settings {
    int max_depth = 6;                   ///< levels, 1 to 64
    double min_weight = 0.001;           ///< >= 0; 0 turns it off
    std::optional<double> max_distance;  ///< > 0, along the path from the eye
    Attenuation attenuation;             ///< of reflected and refracted rays
    SpecularModel specular_model = SpecularModel::phong;
    ShadowMode shadows = ShadowMode::opaque;
    TotalReflection total_internal_reflection = TotalReflection::drop;
    PixelSample pixel_sample = PixelSample::center;
    std::optional<Colour> secondary_background;  ///< none: as the scene's background
    Quantize quantize = Quantize::round;
    std::size_t ray_budget = 1'000'000;  ///< >= 1, rays of one pixel's tree
};

struct Material {
    std::string name;
    Colour color{0.8, 0.8, 0.8};
    Colour specular_color{1, 1, 1};
    Colour ka{0.1}, kd{0.7}, ks{0.0}, kr{0.0}, kt{0.0};  ///< each channel >= 0
    double shininess = 32;                               ///< >= 0
    double ior = 1.5;                                    ///< > 0, relative to vacuum
    bool in_place = false;  ///< written inside the one object that has it, whose name it bears
};

struct PointLight {
    Point position{0, 0, 0};
    Attenuation attenuation;
};

struct DirectionalLight {
    Point direction{0, -1, 0};  ///< the way the light travels; any length but 0
};

struct Light {
    std::string name;
    Colour intensity{1.0};
    std::variant<PointLight, DirectionalLight> kind = PointLight{};
};

struct Sphere {
    Point center{0, 0, 0};
    double radius = 1;  ///< > 0
};

/// Planar, three or more vertices in order, convex or concave.
struct Polygon {
    std::vector<Point> vertices;
    std::vector<Point> normals;  ///< none, or one for each vertex; any length but 0
};

/// The lateral surface of a cone frustum or cylinder, open at both ends.
struct Cone {
    Point base{0, 0, 0};
    Point apex{0, 1, 0};
    double base_radius = 1;  ///< >= 0; not both radii 0
    double apex_radius = 0;
};

struct Mesh {
    struct Corner {
        int vertex = 0;
        int normal = -1;  ///< -1: none
    };
    using Triangle = std::array<Corner, 3>;

    std::string file;    ///< as written in the scene, relative to it
    bool smooth = true;  ///< whether the file's vertex normals are used
    std::vector<Point> vertices;
    std::vector<Point> normals;
    std::vector<Triangle> triangles;
};

using Shape = std::variant<Sphere, Polygon, Cone, Mesh>;

struct Object {
    std::string name;
    std::size_t material = 0;         ///< place in Scene::materials
    std::optional<Affine> transform;  ///< from the shape's own space to the world; invertible
    Shape shape;
};

struct Scene {
    std::string name;
    Camera camera;
    Colour background{0.0};
    Colour ambient{1.0};
    Settings settings;
    std::vector<Material> materials;
    std::vector<Light> lights;
    std::vector<Object> objects;
};

}  // namespace raytree
