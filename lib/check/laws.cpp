#include "check/laws.h"

#include <algorithm>

#include "trace/shading.h"

namespace raytree::check {
namespace model {

double origin_error(const Vec& origin) {
    return 4 * Real<double>::unit_roundoff * largest_component(origin);
}

Vec unit(const Vec& v) {
    if (abs(inner(v, v) - 1) <= 8 * Real<double>::unit_roundoff) {
        return v;
    }
    const double size = largest_component(v);
    return size > 0 && isfinite(size) ? UnitVec3<double>::of(v).vec() : v;
}

Beam primary(const Place& place, const Step& step) {
    const Ray<double> ray = place.camera.primary(step.pixel_i, step.pixel_j);
    return {ray.origin, ray.direction};
}

Interval<double> interval(const Place& place, const Step& step) {
    Interval<double> interval;
    if (step.kind == RayKind::primary) {
        interval.from = place.camera.near_along(step.direction);
    }
    if (place.max_distance) {
        interval.to = *place.max_distance - step.path;
    }
    return interval;
}

std::optional<Hit<double>> meet(const Place& place, const Step& step, Interval<double> interval) {
    const double error = step.kind == RayKind::primary ? 0 : origin_error(step.origin);
    NoTestCount none;
    return place.shapes.closest(Ray<double>{step.origin, step.direction, error}, step.leaving,
                                interval, none);
}

Vec point(const Place&, const Step& step, const Vec& on_surface) {
    // A point of the surface is nearer to the truth than the ray's, unless t is a wrong one.
    const Vec on_ray = along(step.origin, step.t, step.direction);
    const double size = largest_component(step.origin) + abs(step.t);
    return length(on_ray - on_surface) <= 1e-9 * size ? on_surface : on_ray;
}

Turned normal(const Place&, const Step& step) {
    const bool front = inner(step.direction, step.outward) < 0;
    return {front ? step.shading : -step.shading, front};
}

Indices indices(const Place& place, const Step& step) {
    std::vector<std::uint32_t> beyond = step.media;
    if (!step.front) {
        const auto last = std::find(beyond.rbegin(), beyond.rend(), step.material_id);
        if (last != beyond.rend()) {
            beyond.erase(std::next(last).base());
        }
    }
    const double outside = beyond.empty() ? 1 : place.materials[beyond.back()].ior;
    const double inside = step.ready->ior;
    return step.front ? Indices{outside, inside} : Indices{inside, outside};
}

double fade(const Place& place, const Step& step) {
    return step.kind == RayKind::primary ? 1 : place.attenuation.at(step.t);
}

Spectrum coefficient(const Place& place, const Step& step, RayKind kind) {
    if (kind == RayKind::refracted) {
        return step.ready->kt;
    }
    Spectrum kr = step.ready->kr;
    if (step.total_reflection() &&
        place.scene().settings.total_internal_reflection == TotalReflection::reflect) {
        kr += step.ready->kt;
    }
    return kr;
}

Spectrum ambient(const Place&, const Step& step) { return step.ready->ambient; }

Towards towards(const Place& place, const Step& step, std::size_t light) {
    const Illumination<double> at = illuminate(place.lights[light], step.point, step.normal);
    return {at.towards, at.distance};
}

bool faces(const Step&, const Shine& shine) { return shine.cosine > 0; }

Vec sent(const Place&, const Step&, const Shine& shine) { return shine.towards; }

Passage shadow(const Place& place, const Step& step, const Shine& shine) {
    const ShadowMode mode = place.scene().settings.shadows;
    if (mode == ShadowMode::none) {
        return {};
    }
    const Vec from = step.point;
    const Ray<double> ray{from, shine.towards, origin_error(from)};
    const Interval<double> between{0, shine.distance * (1 - 8 * Real<double>::unit_roundoff)};
    NoTestCount none;
    if (mode == ShadowMode::opaque) {
        const auto hit = place.shapes.closest(ray, step.surface, between, none);
        return hit ? Passage{Spectrum(0.0), hit->primitive, hit->t} : Passage{};
    }
    return through(place, place.shapes.all(ray, step.surface, between, none));
}

Passage through(const Place& place, std::span<const Hit<double>> hits) {
    const ShadowMode mode = place.scene().settings.shadows;
    Passage passage;
    for (const Hit<double>& hit : hits) {
        const std::size_t object = place.shapes.shapes()[hit.primitive].object;
        const auto& material = place.materials[place.scene().objects[object].material];
        passage.transmittance *= mode == ShadowMode::opaque ? Spectrum(0.0) : material.kt;
        if (is_zero(passage.transmittance)) {
            passage.blocker = hit.primitive;
            passage.t = hit.t;
            break;
        }
    }
    return passage;
}

namespace {
LocalLight<double> lit_by(const Place& place, const Step& step, const Shine& shine) {
    if (is_zero(shine.transmittance)) {
        return {};
    }
    Illumination<double> at;
    at.towards = shine.towards;
    at.distance = shine.distance;
    at.cosine = shine.cosine;
    return local_light(place.scene().settings.specular_model, *step.ready, *shine.ready, at,
                       step.normal, step.direction, shine.transmittance);
}
}  // namespace

Spectrum diffuse(const Place& place, const Step& step, const Shine& shine) {
    return lit_by(place, step, shine).diffuse;
}
Spectrum specular(const Place& place, const Step& step, const Shine& shine) {
    return lit_by(place, step, shine).specular;
}

std::optional<Reason> why_not(const Place& place, const Step& step, RayKind kind,
                              const Spectrum& weight) {
    const bool reflected = kind == RayKind::reflected;
    if (is_zero(reflected ? step.kr : step.kt)) {
        return reflected ? Reason::not_reflective : Reason::not_transmissive;
    }
    if (!reflected && step.total_reflection()) {
        return Reason::total_internal_reflection;
    }
    if (step.level >= place.scene().settings.max_depth) {
        return Reason::max_depth;
    }
    if (largest_component(weight) < place.min_weight) {
        return Reason::low_intensity;
    }
    return std::nullopt;
}

Vec start(const Place&, const Step& step, RayKind) { return step.point; }

Vec offset(const Step& step, RayKind kind) {
    return kind == RayKind::refracted ? -step.normal : step.normal;
}

int level(const Place&, const Step& step, RayKind) { return step.level + 1; }

Vec reflected(const Place&, const Step& step) {
    return reflected_direction(step.direction, step.normal).vec();
}

Vec refracted(const Place&, const Step& step) {
    const Snell<double> snell{step.eta1, step.eta2, step.sin2_transmitted, step.cos2_transmitted};
    return refracted_direction(snell, step.direction, step.normal).vec();
}

Spectrum miss(const Place& place, const Step& step) {
    return step.kind == RayKind::primary ? place.background : place.secondary_background;
}

Spectrum weight(const Step& from, RayKind kind) {
    const Spectrum& k = kind == RayKind::reflected ? from.kr : from.kt;
    return from.attenuation * (k * from.weight);
}

Spectrum combine(const Place&, const Step&, const Terms& terms) {
    Spectrum sum = terms.ambient + terms.diffuse + terms.specular;
    for (const Terms::Branch& branch : {terms.reflected, terms.refracted}) {
        if (branch.grown) {
            sum += branch.attenuation * (branch.coefficient * branch.intensity);
        }
    }
    return sum;
}

}  // namespace model

const Laws& model_laws() {
    static constexpr Laws laws{
        model::primary,   model::interval, model::meet,        model::point,   model::normal,
        model::indices,   model::fade,     model::coefficient, model::ambient, model::towards,
        model::faces,     model::sent,     model::shadow,      model::diffuse, model::specular,
        model::why_not,   model::start,    model::offset,      model::level,   model::reflected,
        model::refracted, model::miss,     model::combine,     model::weight};
    return laws;
}

void land(const Place& place, const Laws& laws, Step& step, PrimitiveId primitive, double t) {
    step.primitive = primitive;
    step.t = t;
    const Primitive shape = place.shapes.shapes()[primitive];
    step.material_id = static_cast<std::uint32_t>(place.scene().objects[shape.object].material);
    step.material = &place.scene().materials[step.material_id];
    step.ready = &place.materials[step.material_id];
    const Ray<double> ray{step.origin, step.direction, 0};
    const SurfacePoint<double> surface = place.shapes.shapes().surface_at(primitive, ray, t);
    step.outward = surface.geometric_normal;
    step.shading = surface.shading_normal;
    step.point = laws.point(place, step, surface.point);
    const double size = largest_component(step.origin) + abs(t);
    step.surface =
        length(step.point - surface.point) <= on_the_surface * size ? primitive : no_primitive;
    const Turned turned = laws.normal(place, step);
    step.normal = turned.normal;
    step.front = turned.front;
}

void bend(Step& step, const Indices& indices) {
    Snell<double> at = snell(indices.eta1, indices.eta2, step.direction, step.normal);
    if (abs(inner(step.normal, step.normal) - 1) > 1e-4) {
        const double eta = indices.eta1 / indices.eta2;
        at.sin2_transmitted = eta * eta * (1 - step.cosine() * step.cosine());
        at.cos2_transmitted = 1 - at.sin2_transmitted;
    }
    step.eta1 = at.eta1;
    step.eta2 = at.eta2;
    step.sin2_transmitted = at.sin2_transmitted;
    step.cos2_transmitted = at.cos2_transmitted;
}

Shine shine_of(const Place& place, const Laws& laws, const Step& step, std::size_t light) {
    Shine shine;
    shine.light = light;
    shine.ready = &place.lights[light];
    const Towards at = laws.towards(place, step, light);
    shine.towards = at.towards;
    shine.distance = at.distance;
    shine.cosine = inner(step.normal, at.towards);
    return shine;
}

void settle(const Place& place, const Laws& laws, Step& step) {
    if (step.ready->transmissive) {
        bend(step, laws.indices(place, step));
    }
    step.kr = laws.coefficient(place, step, RayKind::reflected);
    step.kt = laws.coefficient(place, step, RayKind::refracted);
    step.attenuation = laws.fade(place, step);
}

Step branch_of(const Place& place, const Laws& laws, const Step& from, RayKind kind,
               const Spectrum& weight) {
    Step step;
    step.parent = &from;
    step.kind = kind;
    step.level = laws.level(place, from, kind);
    step.pixel_i = from.pixel_i;
    step.pixel_j = from.pixel_j;
    step.weight = weight;
    step.path = from.path + from.t;
    step.origin = laws.start(place, from, kind);
    const bool there = length(step.origin - from.point) <= 1e-9 * largest_component(from.point);
    step.leaving = there ? from.surface : no_primitive;
    step.length = kind == RayKind::reflected ? from.length : 1;
    step.direction = model::unit(kind == RayKind::reflected ? laws.reflected(place, from)
                                                            : laws.refracted(place, from));
    step.media = from.media;
    if (kind == RayKind::refracted) {
        const auto last = std::find(step.media.rbegin(), step.media.rend(), from.material_id);
        if (from.front) {
            step.media.push_back(from.material_id);
        } else if (last != step.media.rend()) {
            step.media.erase(std::next(last).base());
        }
    }
    return step;
}

}  // namespace raytree::check
