#include "check/replay_parts.h"

#include <algorithm>
#include <cmath>

#include "tree/explain.h"

namespace raytree::check {
namespace {

double brightness(const Place& place) {
    double most = largest_component(place.background);
    for (const auto& light : place.lights) {
        most = std::max(most, largest_component(light.intensity));
    }
    for (const auto& material : place.materials) {
        most = std::max(most, largest_component(material.ambient));
    }
    return most;
}

bool finite(const Numbers& n) { return isfinite(n.x[0]) && isfinite(n.x[1]) && isfinite(n.x[2]); }

}  // namespace

Replay::Replay(const Place& place, const Names& names, const Laws& laws,
               const Submission& submission, const ReplayOptions& options)
    : place_(place),
      names_(names),
      laws_(laws),
      submission_(submission),
      options_(options),
      darkest_(1e-4 * brightness(place)) {
    if (options.noise != 0) {
        random_.emplace(options.seed);
    }
    if (options.truth) {
        true_children_ = children_of(*options.truth);
    }
}

void Replay::run() {
    Step step;
    step.pixel_i = submission_.tree.pixel_i;
    step.pixel_j = submission_.tree.pixel_j;
    const Beam beam = laws_.primary(place_, step);
    step.origin = beam.origin;
    step.direction = model::unit(beam.direction);
    step.length = length(beam.direction);
    follow({0, options_.truth ? 0 : none}, step, clean);
}

double Replay::moved(double x, double scale) {
    if (options_.noise == 0) {
        return x;
    }
    const Precision& p = submission_.precision;
    std::uniform_real_distribution<double> uniform(-1, 1);
    return x +
           options_.noise * uniform(*random_) * (p.relative * std::max(abs(x), scale) + p.absolute);
}

double Replay::tolerance(std::size_t ray, Field field, double scale) const {
    const Precision& p = submission_.precision;
    double allowed = std::max(options_.rtol, 4 * p.relative) * scale + 2 * p.absolute;
    if (options_.slacks) {
        const auto found = options_.slacks->find(key_of(ray, field));
        allowed += found == options_.slacks->end() ? 0 : found->second.spread;
    }
    return allowed;
}

bool Replay::agree(const Numbers& a, const Numbers& b, double tolerance, double& error) const {
    error = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        error = std::max(error, abs(a.x[k] - b.x[k]));
    }
    return a.size == b.size && error <= tolerance;
}

void Replay::start_finding(Finding& finding, std::size_t ray) const {
    const TreeRay<double>& of = submission_.tree.rays[ray];
    finding.ray = ray;
    finding.kind = of.kind;
    finding.level = of.level;
    finding.light = of.shadow ? of.shadow->light : "";
}

void Replay::count(std::size_t ray, Field field) {
    ++compared_;
    if (options_.tally) {
        const TreeRay<double>& of = submission_.tree.rays[ray];
        ++options_.tally->counts[{field, of.kind, of.level}].compared;
    }
}

Replay::Taint Replay::report(Finding finding) {
    const bool excused = options_.excused && options_.excused->contains(key_of(finding));
    causes_ += finding.follows_from || excused ? 0 : 1;
    if (!finding.follows_from && options_.give_up_at == key_of(finding)) {
        causes_ = std::max(causes_, options_.enough);
    }
    if (options_.tally && !finding.follows_from) {
        const Tally::Key key{finding.field, finding.kind, finding.level};
        if (finding.problem == Problem::missing) {
            ++options_.tally->missing[{Field::origin, key.kind, key.level}];
        } else if (finding.problem == Problem::extra) {
            ++options_.tally->extra[{Field::origin, key.kind, key.level}];
        } else {
            ++options_.tally->counts[key].wrong;
        }
    }
    findings_.push_back(std::move(finding));
    return static_cast<Taint>(findings_.size()) - 1;
}

/// Compares, and goes on with the submission's own value.
void Replay::see_numbers(At at, Field field, Numbers& value, double scale, Taint& taint) {
    const Numbers expected = value;
    if (options_.logs) {
        log_[key_of(at.ray, field)].numbers = expected;
    }
    const Numbers found = numbers_of(submission_.tree, at.ray, field);
    if (submission_.gives(at.ray, field) && found.size != 0 && finite(expected)) {
        count(at.ray, field);
        const double allowed = tolerance(at.ray, field, scale);
        double error = 0;
        const bool follows = agree(found, expected, allowed, error);
        const Numbers truth =
            at.truth == none ? Numbers{} : numbers_of(*options_.truth, at.truth, field);
        double truly = 0;
        const bool is_true = truth.size != 0 && agree(found, truth, allowed, truly);
        if (is_true) {
            taint = clean;
        } else if (!follows || (taint != clean && truth.size != 0)) {
            Finding finding;
            start_finding(finding, at.ray);
            finding.field = field;
            finding.expected.numbers = follows ? truth : expected;
            finding.found.numbers = found;
            finding.error = (follows ? truly : error) / scale;
            if (follows) {
                finding.follows_from = static_cast<std::size_t>(taint);
                report(std::move(finding));
            } else {
                taint = report(std::move(finding));
            }
        }
        value = found;
    }
    for (int k = 0; k < value.size; ++k) {
        double& x = value.x[static_cast<std::size_t>(k)];
        x = moved(x, scale);
    }
}

bool Replay::may_be(std::uint64_t key, std::int64_t word) const {
    if (!options_.slacks) {
        return false;
    }
    const auto found = options_.slacks->find(key);
    // One answer alone is the model's own, and no excuse under other laws.
    return found != options_.slacks->end() && found->second.words.size() > 1 &&
           std::ranges::find(found->second.words, word) != found->second.words.end();
}

/// Compares a decision. The caller goes on with the submission's.
void Replay::decide(At at, Field field, const Word& expected, const Word& found, Taint& taint) {
    count(at.ray, field);
    if (expected.code == found.code || may_be(key_of(at.ray, field), found.code)) {
        return;
    }
    Finding finding;
    start_finding(finding, at.ray);
    finding.field = field;
    finding.expected.word = expected.text;
    finding.found.word = found.text;
    finding.error = 1;
    taint = report(std::move(finding));
}

/// How far two points may be apart that are one but for the submission's digits, and for what
/// `moved` adds.
double Replay::rounding(double size) const {
    const Precision& p = submission_.precision;
    return (1e-9 + 20 * p.relative) * size + 20 * p.absolute;
}

/// Many programs start secondary rays a little off the surface, along its normal or along the ray,
/// so as not to meet it again. That is a convention: the ray is judged from where it starts. To the
/// wrong side of the surface it is none.
bool Replay::set_off(At at, const Step& from, RayKind kind, const Vec& direction, Vec& origin) {
    if (!submission_.gives(at.ray, Field::origin)) {
        return false;
    }
    const Vec found = submission_.tree.rays[at.ray].origin;
    const Vec off = found - from.point;
    const double size = length(off);
    const double most = largest_offset * std::max(1.0, reach(from));
    if (!(size > rounding(reach(from)) / 10) || !(size <= most)) {
        return false;
    }
    const auto along_it = [&](const Vec& axis) {
        return length(off - inner(off, axis) * axis) <= 0.02 * size && inner(off, axis) > 0;
    };
    if (!along_it(model::unit(laws_.offset(from, kind))) && !along_it(direction)) {
        return false;
    }
    count(at.ray, Field::origin);
    origin = found;
    return true;
}

Replay::Outcome Replay::follow(At at, Step& step, Taint taint) {
    if (full()) {
        Outcome unseen;
        unseen.intensity = submission_.tree.rays[at.ray].intensity;
        unseen.attenuation = submission_.tree.rays[at.ray].attenuation;
        return unseen;
    }
    ++rays_;
    const Vec due = step.origin;
    const bool offset =
        step.parent && set_off(at, *step.parent, step.kind, step.direction, step.origin);
    if (!offset) {
        see(at, Field::origin, step.origin,
            step.parent ? reach(*step.parent) : std::max(1.0, largest_component(due)), taint);
    }
    see(at, Field::direction, step.direction, 1, taint);
    step.direction = model::unit(step.direction);
    if (submission_.units[at.ray] != 1) {
        step.length = submission_.units[at.ray];
    }
    see(at, Field::weight, step.weight, std::max(darkest_, largest_component(step.weight)), taint);
    if (offset || length(step.origin - due) > rounding(step.parent ? reach(*step.parent) : 1)) {
        step.leaving = no_primitive;  // it starts beside the surface
    }
    if (!meet(at, step, taint)) {
        return end(at, step, taint);
    }
    surface(at, step, taint);
    Terms terms;
    terms.ambient = laws_.ambient(place_, step);
    Taint lit = taint;
    see(at, Field::ambient, terms.ambient, std::max(darkest_, largest_component(terms.ambient)),
        lit);
    lit = first_of(lit, lights(at, step, terms, taint));
    const Grown reflected = grow(at, step, RayKind::reflected, taint);
    const Grown refracted = grow(at, step, RayKind::refracted, taint);
    report_second_children(at, taint);
    if (reflected.reason && refracted.reason && submission_.gives(at.ray, Field::termination)) {
        const Reason later = std::max(*reflected.reason, *refracted.reason);
        const Reason expected = later <= Reason::not_transmissive ? Reason::opaque : later;
        const auto found = submission_.tree.rays[at.ray].termination;
        Taint ended = taint;
        if (found) {
            decide(at, Field::termination, {static_cast<std::int64_t>(expected), word_of(expected)},
                   {static_cast<std::int64_t>(*found), word_of(*found)}, ended);
        }
    }
    Outcome outcome;
    outcome.taint = first_of(lit, first_of(reflected.taint, refracted.taint));
    sum(at, step, terms, reflected, refracted, outcome.taint);
    outcome.intensity = terms.ambient;  // `sum` leaves it there
    outcome.attenuation = step.attenuation;
    return outcome;
}

Replay::Outcome Replay::end(At at, const Step& step, Taint taint) {
    Outcome outcome;
    outcome.intensity = laws_.miss(place_, step);
    outcome.taint = taint;
    see(at, Field::intensity, outcome.intensity,
        std::max(darkest_, largest_component(outcome.intensity)), outcome.taint);
    report_second_children(at, taint);
    for (const std::size_t ray : submission_.children[at.ray]) {
        if (full()) {
            break;
        }
        Finding finding;
        start_finding(finding, ray);
        finding.problem = Problem::extra;
        finding.reason = submission_.tree.rays[at.ray].hit
                             ? "what the ray that it should start from hits is not known"
                             : "the ray that it should start from hits nothing";
        if (taint != clean) {
            finding.follows_from = static_cast<std::size_t>(taint);
        }
        report(std::move(finding));
    }
    return outcome;
}

}  // namespace raytree::check
