#include "support/embree.h"

#include <stdexcept>

#include "support/bench.h"

#ifdef RAYTREE_WITH_EMBREE

#include <embree3/rtcore.h>

#include <atomic>
#include <limits>
#include <string>

namespace raytree::bench {
namespace {

float to_float(double x) { return static_cast<float>(x); }

RTCRay ray_of(const Query<double>& query) {
    RTCRay ray{};
    ray.org_x = to_float(query.ray.origin.x);
    ray.org_y = to_float(query.ray.origin.y);
    ray.org_z = to_float(query.ray.origin.z);
    ray.dir_x = to_float(query.ray.direction.x);
    ray.dir_y = to_float(query.ray.direction.y);
    ray.dir_z = to_float(query.ray.direction.z);
    ray.tnear = to_float(query.interval.from);
    ray.tfar = to_float(query.interval.to);
    ray.mask = ~0U;
    return ray;
}

template <class Packet> void put(Packet& packet, std::size_t k, const RTCRay& ray) {
    packet.org_x[k] = ray.org_x;
    packet.org_y[k] = ray.org_y;
    packet.org_z[k] = ray.org_z;
    packet.dir_x[k] = ray.dir_x;
    packet.dir_y[k] = ray.dir_y;
    packet.dir_z[k] = ray.dir_z;
    packet.tnear[k] = ray.tnear;
    packet.tfar[k] = ray.tfar;
    packet.mask[k] = ~0U;
    packet.id[k] = packet.flags[k] = 0;
    packet.time[k] = 0;
}

RTCIntersectContext context_of(bool coherent) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags =
        coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    return context;
}

std::atomic<std::int64_t> held{0};

}  // namespace

struct EmbreeScene::Data {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    double build_seconds = 0;
    double bytes = 0;

    ~Data() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }

    void attach(RTCGeometry geometry) {
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
    }

    void add_mesh(const Mesh& mesh) {
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = static_cast<float*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                    3 * sizeof(float), mesh.vertices.size()));
        for (const Point& p : mesh.vertices) {
            for (int axis = 0; axis < 3; ++axis) {
                *vertices++ = to_float(p[axis]);
            }
        }
        auto* places = static_cast<unsigned*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    3 * sizeof(unsigned), mesh.triangles.size()));
        for (const Mesh::Triangle& triangle : mesh.triangles) {
            for (const Mesh::Corner& corner : triangle) {
                *places++ = static_cast<unsigned>(corner.vertex);
            }
        }
        attach(geometry);
    }

    /// Points with radii: spheres one by one, or the two ends of each cone.
    void add_round(const std::vector<std::pair<Point, double>>& points, bool cones) {
        if (points.empty()) {
            return;
        }
        RTCGeometry geometry = rtcNewGeometry(
            device, cones ? RTC_GEOMETRY_TYPE_CONE_LINEAR_CURVE : RTC_GEOMETRY_TYPE_SPHERE_POINT);
        auto* vertices = static_cast<float*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                    4 * sizeof(float), points.size()));
        for (const auto& [p, radius] : points) {
            for (int axis = 0; axis < 3; ++axis) {
                *vertices++ = to_float(p[axis]);
            }
            *vertices++ = to_float(radius);
        }
        if (cones) {
            auto* places = static_cast<unsigned*>(
                rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT,
                                        sizeof(unsigned), points.size() / 2));
            for (std::size_t k = 0; k < points.size() / 2; ++k) {
                places[k] = static_cast<unsigned>(2 * k);
            }
        }
        attach(geometry);
    }
};

EmbreeScene::EmbreeScene(const Scene& scene, EmbreeMode mode, int threads)
    : data_(std::make_unique<Data>()) {
    data_->device = rtcNewDevice(("threads=" + std::to_string(threads)).c_str());
    const std::int64_t before = held;
    rtcSetDeviceMemoryMonitorFunction(
        data_->device,
        [](void*, ssize_t bytes, bool) {
            held += bytes;
            return true;
        },
        nullptr);
    data_->scene = rtcNewScene(data_->device);
    rtcSetSceneBuildQuality(data_->scene, RTC_BUILD_QUALITY_HIGH);
    if (mode == EmbreeMode::robust) {
        rtcSetSceneFlags(data_->scene, RTC_SCENE_FLAG_ROBUST);
    }
    std::vector<std::pair<Point, double>> spheres, cones;
    for (const Object& object : scene.objects) {
        if (const auto* mesh = std::get_if<Mesh>(&object.shape)) {
            data_->add_mesh(*mesh);
        } else if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
            spheres.emplace_back(sphere->center, sphere->radius);
        } else if (const auto* cone = std::get_if<Cone>(&object.shape)) {
            cones.emplace_back(cone->base, cone->base_radius);
            cones.emplace_back(cone->apex, cone->apex_radius);
        } else {
            throw std::invalid_argument("this benchmark has no polygons for Embree");
        }
    }
    data_->add_round(spheres, false);
    data_->add_round(cones, true);
    const double begin = process_seconds();
    rtcCommitScene(data_->scene);
    data_->build_seconds = process_seconds() - begin;
    data_->bytes = static_cast<double>(held - before);
    if (const RTCError error = rtcGetDeviceError(data_->device); error != RTC_ERROR_NONE) {
        throw std::runtime_error("Embree reports error " + std::to_string(error));
    }
}

EmbreeScene::~EmbreeScene() = default;
double EmbreeScene::build_seconds() const { return data_->build_seconds; }
double EmbreeScene::bytes() const { return data_->bytes; }
bool EmbreeScene::available() { return true; }

void EmbreeScene::closest(std::span<const Query<double>> queries, std::span<EmbreeHit> hits) const {
    RTCIntersectContext context = context_of(false);
    for (std::size_t k = 0; k < queries.size(); ++k) {
        RTCRayHit hit;
        hit.ray = ray_of(queries[k]);
        hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(data_->scene, &context, &hit);
        hits[k] = {hit.ray.tfar, hit.hit.geomID != RTC_INVALID_GEOMETRY_ID};
    }
}

void EmbreeScene::any(std::span<const Query<double>> queries, std::span<EmbreeHit> hits) const {
    RTCIntersectContext context = context_of(false);
    for (std::size_t k = 0; k < queries.size(); ++k) {
        RTCRay ray = ray_of(queries[k]);
        rtcOccluded1(data_->scene, &context, &ray);
        hits[k] = {0, ray.tfar < 0};
    }
}

void EmbreeScene::closest_packets(std::span<const Query<double>> queries, std::span<EmbreeHit> hits,
                                  bool coherent) const {
    RTCIntersectContext context = context_of(coherent);
    for (std::size_t first = 0; first < queries.size(); first += 16) {
        const std::size_t count = std::min<std::size_t>(16, queries.size() - first);
        alignas(64) int valid[16] = {};
        RTCRayHit16 packet;
        for (std::size_t k = 0; k < count; ++k) {
            valid[k] = -1;
            put(packet.ray, k, ray_of(queries[first + k]));
            packet.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
            packet.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
        }
        rtcIntersect16(valid, data_->scene, &context, &packet);
        for (std::size_t k = 0; k < count; ++k) {
            hits[first + k] = {packet.ray.tfar[k], packet.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID};
        }
    }
}

void EmbreeScene::any_packets(std::span<const Query<double>> queries, std::span<EmbreeHit> hits,
                              bool coherent) const {
    RTCIntersectContext context = context_of(coherent);
    for (std::size_t first = 0; first < queries.size(); first += 16) {
        const std::size_t count = std::min<std::size_t>(16, queries.size() - first);
        alignas(64) int valid[16] = {};
        RTCRay16 packet;
        for (std::size_t k = 0; k < count; ++k) {
            valid[k] = -1;
            put(packet, k, ray_of(queries[first + k]));
        }
        rtcOccluded16(valid, data_->scene, &context, &packet);
        for (std::size_t k = 0; k < count; ++k) {
            hits[first + k] = {0, packet.tfar[k] < 0};
        }
    }
}

}  // namespace raytree::bench

#else

namespace raytree::bench {

struct EmbreeScene::Data {};
EmbreeScene::EmbreeScene(const Scene&, EmbreeMode, int) {
    throw std::logic_error("built without Embree");
}
EmbreeScene::~EmbreeScene() = default;
double EmbreeScene::build_seconds() const { return 0; }
double EmbreeScene::bytes() const { return 0; }
bool EmbreeScene::available() { return false; }
void EmbreeScene::closest(std::span<const Query<double>>, std::span<EmbreeHit>) const {}
void EmbreeScene::any(std::span<const Query<double>>, std::span<EmbreeHit>) const {}
void EmbreeScene::closest_packets(std::span<const Query<double>>, std::span<EmbreeHit>,
                                  bool) const {}
void EmbreeScene::any_packets(std::span<const Query<double>>, std::span<EmbreeHit>, bool) const {}

}  // namespace raytree::bench

#endif
