#include "support/embree_tracer.h"

#include <stdexcept>

#ifdef RAYTREE_WITH_EMBREE

#include <embree3/rtcore.h>

#include "formats/split_polygon.h"
#include "trace/media.h"

namespace raytree::bench {
namespace {

/// As is usual with Embree, a ray sees nothing nearer to its start than this share of the start's
/// largest coordinate.
constexpr float start_gap = 1e-4F;

struct Round {
    std::vector<float> numbers;  ///< centre and radius, four each
    std::vector<PrimitiveId> ids;
    void add(const Point& center, double radius) {
        for (int axis = 0; axis < 3; ++axis) {
            numbers.push_back(static_cast<float>(center[axis]));
        }
        numbers.push_back(static_cast<float>(radius));
    }
};

/// The triangles of everything that has corners.
struct Corners {
    std::vector<float> numbers;
    std::vector<PrimitiveId> ids;
    void add(const Object& object, const std::array<Point, 3>& triangle, PrimitiveId id) {
        for (const Point& p : triangle) {
            Point at = p;
            if (object.transform) {
                const Affine& m = *object.transform;
                for (int k = 0; k < 3; ++k) {
                    const auto& row = m[static_cast<std::size_t>(k)];
                    at[k] = row[0] * p.x + row[1] * p.y + row[2] * p.z + row[3];
                }
            }
            for (int axis = 0; axis < 3; ++axis) {
                numbers.push_back(static_cast<float>(at[axis]));
            }
        }
        ids.push_back(id);
    }
};

template <class Number> Number* buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                                       std::size_t each, std::size_t count) {
    return static_cast<Number*>(
        rtcSetNewGeometryBuffer(geometry, type, 0, format, each * sizeof(Number), count));
}

}  // namespace

struct EmbreeTracer::Data {
    explicit Data(const Scene& s) : scene(s), world(s) {}
    ~Data() {
        rtcReleaseScene(hierarchy);
        rtcReleaseDevice(device);
    }

    const Scene& scene;
    World<float> world;
    RTCDevice device = nullptr;
    RTCScene hierarchy = nullptr;
    std::vector<std::vector<PrimitiveId>> ids;  ///< by geometry and its primitives

    struct Branch {
        RayKind kind = RayKind::primary;
        int level = 1;
        Vec3<float> origin{}, direction{};
        Rgb<float> weight{1.0F};
        Interval<float> interval;
        float path = 0;
        Media media;
    };
    struct Outcome {
        Rgb<float> intensity;
        float attenuation = 1;
    };

    void attach(RTCGeometry geometry, std::vector<PrimitiveId> of_geometry) {
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(hierarchy, geometry);
        rtcReleaseGeometry(geometry);
        ids.push_back(std::move(of_geometry));
    }
    void attach(const Round& round, bool cones) {
        if (round.ids.empty()) {
            return;
        }
        RTCGeometry geometry = rtcNewGeometry(
            device, cones ? RTC_GEOMETRY_TYPE_CONE_LINEAR_CURVE : RTC_GEOMETRY_TYPE_SPHERE_POINT);
        std::ranges::copy(round.numbers,
                          buffer<float>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 4,
                                        round.numbers.size() / 4));
        if (cones) {
            auto* first = buffer<unsigned>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT, 1,
                                           round.ids.size());
            for (unsigned k = 0; k < round.ids.size(); ++k) {
                first[k] = 2 * k;
            }
        }
        attach(geometry, round.ids);
    }
    void attach(const Corners& corners) {
        if (corners.ids.empty()) {
            return;
        }
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        std::ranges::copy(corners.numbers,
                          buffer<float>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, 3,
                                        corners.numbers.size() / 3));
        auto* vertex = buffer<unsigned>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, 3,
                                        corners.ids.size());
        for (unsigned k = 0; k < 3 * corners.ids.size(); ++k) {
            vertex[k] = k;
        }
        attach(geometry, corners.ids);
    }

    std::optional<Hit<float>> closest(const Vec3<float>& o, const Vec3<float>& d,
                                      const Interval<float>& interval) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit query{};
        query.ray = {o.x, o.y, o.z, interval.from, d.x, d.y, d.z, 0, interval.to, ~0U, 0, 0};
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(hierarchy, &context, &query);
        if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
            return std::nullopt;
        }
        return Hit<float>{query.ray.tfar, ids[query.hit.geomID][query.hit.primID]};
    }

    const WorldMaterial<float>& material_of(PrimitiveId id) const {
        return world.materials[scene.objects[world.shapes.shapes()[id].object].material];
    }

    Rgb<float> transmitted(const Vec3<float>& from, const Vec3<float>& towards,
                           float distance) const {
        const float gap = start_gap * largest_component(from);
        Interval<float> between{gap, distance - gap};
        Rgb<float> through(1.0F);
        while (const auto hit = closest(from, towards, between)) {
            if (scene.settings.shadows == ShadowMode::opaque) {
                return Rgb<float>(0.0F);
            }
            through *= material_of(hit->primitive).kt;
            between.from = hit->t + gap;
        }
        return through;
    }

    Rgb<float> trace_pixel(int i, int j, Steps<float>* steps) const {
        const Ray<float> ray = world.camera.primary(i, j);
        Branch branch;
        branch.origin = ray.origin;
        branch.direction = ray.direction;
        branch.interval.from = world.camera.near_along(ray.direction);
        return trace(branch, steps).intensity;
    }

    Outcome trace(Branch branch, Steps<float>* steps) const;
    Rgb<float> branch_out(const Branch& from, RayKind kind, const Rgb<float>& k,
                          const Vec3<float>& point, const Vec3<float>& direction,
                          const Rgb<float>& weight, float t, std::optional<bool> enters,
                          std::uint32_t material, Steps<float>* steps) const;
};

EmbreeTracer::Data::Outcome EmbreeTracer::Data::trace(Branch branch, Steps<float>* steps) const {
    const Settings& settings = scene.settings;
    if (world.max_distance) {
        branch.interval.to = *world.max_distance - branch.path;
    }
    std::size_t own = 0;
    if (steps) {
        own = steps->rays.size();
        steps->rays.emplace_back(branch.kind, branch.level, branch.direction);
    }
    const auto hit = closest(branch.origin, branch.direction, branch.interval);
    if (!hit) {
        return {branch.kind == RayKind::primary ? world.background : world.secondary_background};
    }
    const Ray<float> ray{branch.origin, branch.direction, 0};
    const SurfacePoint<float> at = world.shapes.shapes().surface_at(hit->primitive, ray, hit->t);
    const Vec3<float>& d = branch.direction;
    const bool front = inner(d, at.geometric_normal) < 0;
    const Vec3<float> n = front ? at.shading_normal.vec() : -at.shading_normal.vec();
    const Object& object = scene.objects[world.shapes.shapes()[hit->primitive].object];
    const auto material_id = static_cast<std::uint32_t>(object.material);
    const WorldMaterial<float>& material = world.materials[object.material];
    Outcome result{material.ambient,
                   branch.kind == RayKind::primary ? 1 : world.attenuation.at(hit->t)};
    int lit_by = 0;
    for (std::size_t k = 0; k < world.lights.size() && material.lit; ++k) {
        const auto light = illuminate(world.lights[k], at.point, n);
        if (!light.in_front()) {
            continue;
        }
        const Rgb<float> through = settings.shadows == ShadowMode::none
                                       ? Rgb<float>(1.0F)
                                       : transmitted(at.point, light.towards, light.distance);
        if (!is_zero(through)) {
            lit_by += settings.shadows == ShadowMode::none ? 0 : 1;
            const auto adds = local_light(settings.specular_model, material, world.lights[k], light,
                                          n, d, through);
            result.intensity += adds.diffuse + adds.specular;
        }
    }
    if (steps) {
        Step<float>& step = steps->rays[own];
        step.met = true;
        step.object = primitive_name(scene, world.shapes.shapes()[hit->primitive]);
        step.t = hit->t;
        step.point = at.point;
        step.lit_by = lit_by;
    }
    Rgb<float> kr = material.kr;
    Snell<float> bends;
    if (material.transmissive) {
        Media outer_media = branch.media;
        if (!front) {
            outer_media.leave(material_id);
        }
        const float outside = outer_media.empty() ? 1.0F : world.materials[outer_media.last()].ior;
        bends = snell(front ? outside : material.ior, front ? material.ior : outside, d, n);
        if (bends.total_reflection() &&
            settings.total_internal_reflection == TotalReflection::reflect) {
            kr += material.kt;
        }
    }
    const Rgb<float> reflected = result.attenuation * (kr * branch.weight);
    result.intensity +=
        branch_out(branch, RayKind::reflected, kr, at.point, reflected_direction(d, n).vec(),
                   reflected, hit->t, std::nullopt, material_id, steps);
    if (!bends.total_reflection()) {
        const Rgb<float> refracted = result.attenuation * (material.kt * branch.weight);
        result.intensity += branch_out(branch, RayKind::refracted, material.kt, at.point,
                                       refracted_direction(bends, d, n).vec(), refracted, hit->t,
                                       front, material_id, steps);
    }
    return result;
}

/// What a branch adds to the hit's intensity; 0 where it is not grown.
Rgb<float> EmbreeTracer::Data::branch_out(const Branch& from, RayKind kind, const Rgb<float>& k,
                                          const Vec3<float>& point, const Vec3<float>& direction,
                                          const Rgb<float>& weight, float t,
                                          std::optional<bool> enters, std::uint32_t material,
                                          Steps<float>* steps) const {
    if (is_zero(k) || from.level >= scene.settings.max_depth ||
        largest_component(weight) < world.min_weight) {
        return {};
    }
    Branch next{kind, from.level + 1, point, direction, weight, {}, from.path + t, from.media};
    next.interval.from = start_gap * largest_component(point);
    if (enters) {
        if (*enters) {
            next.media.enter(material);
        } else {
            next.media.leave(material);
        }
    }
    const Outcome outcome = trace(std::move(next), steps);
    return outcome.attenuation * (k * outcome.intensity);
}

EmbreeTracer::EmbreeTracer(const Scene& scene) : data_(std::make_unique<Data>(scene)) {
    Data& data = *data_;
    data.device = rtcNewDevice("threads=1");
    data.hierarchy = rtcNewScene(data.device);
    rtcSetSceneBuildQuality(data.hierarchy, RTC_BUILD_QUALITY_HIGH);
    rtcSetSceneFlags(data.hierarchy, RTC_SCENE_FLAG_ROBUST);
    Round spheres, cones;
    Corners corners;
    PrimitiveId id = 0;
    for (const Object& object : scene.objects) {
        if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
            spheres.add(sphere->center, sphere->radius);
            spheres.ids.push_back(id++);
        } else if (const auto* cone = std::get_if<Cone>(&object.shape)) {
            cones.add(cone->base, cone->base_radius);
            cones.add(cone->apex, cone->apex_radius);
            cones.ids.push_back(id++);
        } else if (const auto* polygon = std::get_if<Polygon>(&object.shape)) {
            for (const Polygon& part : split_into_triangles(*polygon)) {
                corners.add(object, {part.vertices[0], part.vertices[1], part.vertices[2]}, id);
            }
            ++id;
        } else {
            const Mesh& mesh = std::get<Mesh>(object.shape);
            for (const Mesh::Triangle& triangle : mesh.triangles) {
                const auto vertex = [&](std::size_t k) {
                    return mesh.vertices[static_cast<std::size_t>(triangle[k].vertex)];
                };
                corners.add(object, {vertex(0), vertex(1), vertex(2)}, id++);
            }
        }
    }
    data.attach(spheres, false);
    data.attach(cones, true);
    data.attach(corners);
    rtcCommitScene(data.hierarchy);
    if (const RTCError error = rtcGetDeviceError(data.device); error != RTC_ERROR_NONE) {
        throw std::runtime_error("Embree reports error " + std::to_string(error));
    }
}

EmbreeTracer::~EmbreeTracer() = default;

std::string EmbreeTracer::why_not(const Scene& scene) {
    for (const Object& object : scene.objects) {
        const bool round = std::holds_alternative<Sphere>(object.shape) ||
                           std::holds_alternative<Cone>(object.shape);
        if (round && object.transform) {
            return "Embree has no transformed spheres and cones";
        }
        if (const auto* cone = std::get_if<Cone>(&object.shape);
            cone && !(cone->base_radius > 0 && cone->apex_radius > 0)) {
            return "Embree's cones do not end in a point";
        }
    }
    return "";
}

Picture EmbreeTracer::render() const {
    const Camera& camera = data_->scene.camera;
    Picture picture{camera.width, camera.height, {}};
    for (int j = 0; j < camera.height; ++j) {
        for (int i = 0; i < camera.width; ++i) {
            picture.pixels.push_back(rgb_cast<double>(data_->trace_pixel(i, j, nullptr)));
        }
    }
    return picture;
}

Steps<float> EmbreeTracer::steps(int i, int j) const {
    Steps<float> steps;
    steps.intensity = data_->trace_pixel(i, j, &steps);
    return steps;
}

}  // namespace raytree::bench

#else

namespace raytree::bench {

struct EmbreeTracer::Data {};

EmbreeTracer::EmbreeTracer(const Scene&) { throw std::runtime_error("built without Embree"); }
EmbreeTracer::~EmbreeTracer() = default;
std::string EmbreeTracer::why_not(const Scene&) { return "built without Embree"; }
Picture EmbreeTracer::render() const { return {}; }
Steps<float> EmbreeTracer::steps(int, int) const { return {}; }

}  // namespace raytree::bench

#endif
