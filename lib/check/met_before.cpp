#include "check/met_before.h"

namespace raytree::check {

template <class Met, class Find> Met MetBefore::from(std::vector<Entry<Met>>& entries,
                                                     std::size_t place, const Sent& sent,
                                                     Find find) {
    if (place >= most_) {
        return find();
    }
    if (place >= entries.size()) {
        entries.resize(place + 1);
    }
    Entry<Met>& entry = entries[place];
    if (entry.known) {
        return entry.sent == sent ? entry.met : find();
    }
    entry = {true, sent, find()};
    return entry.met;
}

std::optional<Hit<double>> MetBefore::meet(const Place& place, const Laws& laws, const Step& step,
                                           const Interval<double>& interval, std::size_t ray) {
    const bool by_the_model = laws.meet == model::meet;
    if (!by_the_model && step.parent && step.parent->total_reflection()) {
        return laws.meet(place, step, interval);  // some ask for that too
    }
    if (!by_the_model && laws.meet != other_meet_) {
        other_meet_ = laws.meet;
        other_hits_.clear();
    }
    const Vec &o = step.origin, &d = step.direction;
    const Sent sent{{o.x, o.y, o.z, d.x, d.y, d.z, interval.from, interval.to},
                    step.leaving,
                    step.parent ? step.parent->primitive : no_primitive,
                    step.kind == RayKind::primary};
    return from(by_the_model ? hits_ : other_hits_, ray, sent,
                [&] { return laws.meet(place, step, interval); });
}

Passage MetBefore::shadow(const Place& place, const Laws& laws, const Step& step,
                          const Shine& shine, std::size_t ray) {
    if (laws.shadow != model::shadow) {
        return laws.shadow(place, step, shine);
    }
    const Vec &o = step.point, &d = shine.towards;
    const Sent sent{
        {o.x, o.y, o.z, d.x, d.y, d.z, 0, shine.distance}, step.surface, no_primitive, false};
    return from(passages_, ray * place.lights.size() + shine.light, sent,
                [&] { return model::shadow(place, step, shine); });
}

}  // namespace raytree::check
