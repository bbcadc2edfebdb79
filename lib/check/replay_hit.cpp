#include <algorithm>

#include "check/replay_parts.h"
#include "trace/shading.h"

namespace raytree::check {

/// What the ray hits. False where it hits nothing, or nothing that is known.
bool Replay::meet(At at, Step& step, Taint& taint) {
    const Interval<double> interval = laws_.interval(place_, step);
    const auto hit = options_.met_before
                         ? options_.met_before->meet(place_, laws_, step, interval, at.ray)
                         : laws_.meet(place_, step, interval);
    const std::int64_t met = hit ? static_cast<std::int64_t>(hit->primitive) : -1;
    note(key_of(at.ray, Field::object), met);
    const auto& given = submission_.tree.rays[at.ray].hit;
    if (submission_.gives(at.ray, Field::hit) && !given) {
        decide(at, Field::object, {met, hit ? names_.of(hit->primitive) : ""}, {-1, ""}, taint);
        return false;
    }
    if (submission_.gives(at.ray, Field::hit)) {
        return meet_given(at, step, hit, interval, taint);
    }
    if (hit) {
        land(place_, laws_, step, hit->primitive, hit->t);
    }
    return hit.has_value();
}

bool Replay::meet_given(At at, Step& step, const std::optional<Hit<double>>& hit,
                        const Interval<double>& interval, Taint& taint) {
    const TreeHit<double>& given = *submission_.tree.rays[at.ray].hit;
    const bool named = submission_.gives(at.ray, Field::object);
    if (step.parent && named && submission_.gives(at.ray, Field::t) &&
        meets_start(*step.parent, step.kind, given.object, given.t)) {
        count(at.ray, Field::object);
        land(place_, laws_, step, step.parent->primitive, given.t);
        return true;
    }
    const bool same = hit && (!named || names_.means(given.object, hit->primitive));
    if (same) {
        if (named) {
            count(at.ray, Field::object);
        }
        double t = hit->t;
        see(at, Field::t, t, largest_component(step.origin) + abs(t), taint);
        land(place_, laws_, step, hit->primitive, t);
        return true;
    }
    const auto other = along_the_ray(step, interval, given);
    const auto primitive = other   ? std::optional(other->primitive)
                           : named ? names_.find(given.object)
                                   : std::nullopt;
    const std::int64_t code = primitive ? static_cast<std::int64_t>(*primitive) : -2;
    decide(at, Field::object,
           {hit ? static_cast<std::int64_t>(hit->primitive) : -1,
            hit ? names_.of(hit->primitive) : ""},
           {code, named ? std::string_view(given.object) : "something"}, taint);
    if (!primitive) {
        return false;
    }
    double t = other ? other->t : hit ? hit->t : 0;
    if (submission_.gives(at.ray, Field::t)) {
        t = given.t;
    }
    land(place_, laws_, step, *primitive, t);
    return true;
}

/// Whether by the laws a ray that starts at the hit `from` may meet this so near to its start.
bool Replay::meets_start(const Step& from, RayKind kind, const std::string& object,
                         double t) const {
    return laws_.may_meet_start[static_cast<std::size_t>(kind)] &&
           abs(t) <= 1e-6 * std::max(1.0, reach(from)) && names_.means(object, from.primitive);
}

/// Where the ray meets the object that the submission names, nearest to where it says.
std::optional<Hit<double>> Replay::along_the_ray(const Step& step, const Interval<double>& interval,
                                                 const TreeHit<double>& given) const {
    NoTestCount count;
    const Ray<double> ray{step.origin, step.direction, model::origin_error(step.origin)};
    std::optional<Hit<double>> nearest;
    for (const Hit<double>& hit : place_.shapes.all(ray, step.leaving, interval, count)) {
        const bool nearer = !nearest || abs(hit.t - given.t) < abs(nearest->t - given.t);
        if (nearer && names_.means(given.object, hit.primitive)) {
            nearest = hit;
        }
    }
    return nearest;
}

/// The point, the normal and what depends on them.
void Replay::surface(At at, Step& step, Taint& taint) {
    const double size = reach(step);
    const Vec due = step.point;
    see(at, Field::point, step.point, size, taint);
    if (length(step.point - due) > on_the_surface * size) {
        step.surface = no_primitive;
    }
    see(at, Field::normal, step.normal, 1, taint);
    note(key_of(at.ray, Field::side), step.front ? 0 : 1);
    if (submission_.gives(at.ray, Field::side) && submission_.tree.rays[at.ray].hit) {
        const bool front = submission_.tree.rays[at.ray].hit->side == Side::front;
        decide(at, Field::side, {step.front ? 0 : 1, step.front ? "front" : "back"},
               {front ? 0 : 1, front ? "front" : "back"}, taint);
        step.front = front;
    }
    // Of a direction of another length the product may be taken as it is.
    const double stretched = step.length * step.cosine();
    const double given = submission_.tree.rays[at.ray].hit
                             ? submission_.tree.rays[at.ray].hit->cos_incident
                             : step.cosine();
    const bool is_stretched = abs(given - stretched) < abs(given - step.cosine());
    double cosine = is_stretched ? stretched : step.cosine();
    Taint own = taint;
    see(at, Field::cos_incident, cosine, 1, own);
    settle(place_, laws_, step);
    if (step.ready->transmissive) {
        Indices indices{step.eta1, step.eta2};
        see(at, Field::eta, indices, std::max(step.eta1, step.eta2), taint);
        bend(step, indices);
        double sin2 = step.sin2_transmitted;
        own = taint;
        see(at, Field::sin2_transmitted, sin2, std::max(1.0, sin2), own);
        step.kr = laws_.coefficient(place_, step, RayKind::reflected);
        step.kt = laws_.coefficient(place_, step, RayKind::refracted);
    }
    see(at, Field::attenuation, step.attenuation, 1, taint);
}

}  // namespace raytree::check
