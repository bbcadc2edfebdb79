#include <algorithm>
#include <cmath>

#include "check/align.h"
#include "check/replay_parts.h"

namespace raytree::check {
namespace {

constexpr int trials = 12;
constexpr int trials_of_a_large_tree = 3;
constexpr std::size_t large_tree = 3000;

}  // namespace

std::size_t Replay::child(std::size_t parent, RayKind kind) const {
    return corresponding(submission_.tree, submission_.children[parent], kind, "").value_or(none);
}

/// The shadow ray to a light: by its name, else, where rays have no lights, by their order.
std::size_t Replay::shadow_child(std::size_t parent, std::size_t light) const {
    const std::string& name = place_.scene().lights[light].name;
    std::size_t nameless = 0;
    for (const std::size_t ray : submission_.children[parent]) {
        const auto& shadow = submission_.tree.rays[ray].shadow;
        if (!shadow) {
            break;  // shadow rays come first, and a hostile tree has many others
        }
        if (shadow->light == name) {
            return ray;
        }
        if (shadow->light.empty() && nameless++ == light) {
            return ray;
        }
    }
    return none;
}

std::size_t Replay::true_child(std::size_t parent, RayKind kind, const std::string& light) const {
    if (parent == none || !options_.truth) {
        return none;
    }
    return corresponding(*options_.truth, true_children_[parent], kind, light).value_or(none);
}

/// A ray has one reflected and one refracted branch.
void Replay::report_second_children(At at, Taint taint) {
    for (const RayKind kind : {RayKind::reflected, RayKind::refracted}) {
        bool first = true;
        for (const std::size_t ray : submission_.children[at.ray]) {
            if (full()) {
                return;
            }
            if (submission_.tree.rays[ray].kind != kind) {
                continue;
            }
            if (!first) {
                Finding finding;
                start_finding(finding, ray);
                finding.problem = Problem::extra;
                finding.reason = "its parent has another branch of this kind";
                if (taint != clean) {
                    finding.follows_from = static_cast<std::size_t>(taint);
                }
                report(std::move(finding));
            }
            first = false;
        }
    }
}

Replay::Grown Replay::grow(At at, const Step& step, RayKind kind, Taint taint) {
    Grown grown;
    grown.taint = taint;
    const Spectrum weight = laws_.weight(step, kind);
    grown.reason = laws_.why_not(place_, step, kind, weight);
    if (!grown.reason && rays_ >= place_.scene().settings.ray_budget) {
        grown.reason = Reason::ray_budget;
    }
    const std::uint64_t key = key_of(at.ray, kind);
    note(key, grown.reason ? static_cast<std::int64_t>(*grown.reason) : -1);
    const std::size_t ray = child(at.ray, kind);
    const std::size_t truth = true_child(at.truth, kind, "");
    const Spectrum& k = kind == RayKind::reflected ? step.kr : step.kt;
    grown.branch.coefficient = grown.alternative.coefficient = k;
    if (ray == none) {
        const auto* slack = options_.slacks;
        const auto found = slack ? slack->find(key) : Slacks::const_iterator{};
        const bool tie = slack && found != slack->end() && found->second.words.size() > 1;
        if (!grown.reason && !tie && !full()) {
            Finding finding;
            start_finding(finding, at.ray);
            finding.problem = Problem::missing;
            finding.kind = kind;
            finding.level = step.level + 1;
            if (taint != clean && truth == none && options_.truth) {
                finding.follows_from = static_cast<std::size_t>(taint);
                report(std::move(finding));
            } else {
                grown.taint = report(std::move(finding));
            }
        }
        if (!grown.reason && truth != none) {
            const TreeRay<double>& of = options_.truth->rays[truth];
            grown.alternative.grown = true;
            grown.alternative.attenuation = of.attenuation;
            grown.alternative.intensity = of.intensity;
        }
        return grown;
    }
    if (grown.reason && !may_be(key, -1)) {
        Finding finding;
        start_finding(finding, ray);
        finding.problem = Problem::extra;
        finding.reason = std::string(word_of(*grown.reason));
        if (taint != clean && truth == none && options_.truth) {
            finding.follows_from = static_cast<std::size_t>(taint);
            report(std::move(finding));
        } else {
            grown.taint = report(std::move(finding));
        }
    }
    Step next = branch_of(place_, laws_, step, kind, weight);
    if (!isfinite(largest_component(next.direction))) {
        next.direction = submission_.gives(ray, Field::direction)
                             ? submission_.tree.rays[ray].direction
                             : step.direction;
    }
    const Outcome outcome = follow({ray, truth}, next, grown.taint);
    grown.reason = std::nullopt;
    grown.branch.grown = true;
    grown.branch.attenuation = outcome.attenuation;
    grown.branch.intensity = outcome.intensity;
    grown.taint = first_of(grown.taint, outcome.taint);
    return grown;
}

/// The intensity of a hit from its terms; leaves it in `terms.ambient`.
void Replay::sum(At at, const Step& step, Terms& terms, const Grown& reflected,
                 const Grown& refracted, Taint& taint) {
    terms.reflected = reflected.branch;
    terms.refracted = refracted.branch;
    Spectrum total = laws_.combine(place_, step, terms);
    // Of a missing ray the submission may have had the intensity all the same.
    Terms whole = terms;
    whole.reflected = reflected.branch.grown ? reflected.branch : reflected.alternative;
    whole.refracted = refracted.branch.grown ? refracted.branch : refracted.alternative;
    const Spectrum with_missing = laws_.combine(place_, step, whole);
    const double scale =
        std::max(darkest_, std::max(largest_component(total), largest_component(with_missing)));
    if (submission_.gives(at.ray, Field::intensity)) {
        const Numbers found = numbers_of(submission_.tree, at.ray, Field::intensity);
        const Numbers other{3, {with_missing.r, with_missing.g, with_missing.b}};
        double error = 0;
        if (agree(found, other, tolerance(at.ray, Field::intensity, scale), error)) {
            total = with_missing;
        }
    }
    see(at, Field::intensity, total, scale, taint);
    terms.ambient = total;
}

Slacks slacks_of(const Place& place, const Names& names, const Laws& laws,
                 const Submission& submission, const ReplayOptions& options) {
    ReplayOptions quiet = options;
    quiet.slacks = nullptr;
    quiet.truth = nullptr;
    quiet.logs = true;
    Replay exact(place, names, laws, submission, quiet);
    exact.run();
    Slacks slacks;
    const bool large = std::min(submission.tree.rays.size(), options.most_rays) > large_tree;
    for (int k = 0; k < (large ? trials_of_a_large_tree : trials); ++k) {
        // What is rounded is off by the last digit alone; arithmetic in floats adds up.
        quiet.noise = submission.precision.name == "rounded" ? 2 : 4;
        quiet.seed = static_cast<unsigned>(k + 1);
        Replay trial(place, names, laws, submission, quiet);
        trial.run();
        for (const auto& [key, there] : trial.log()) {
            const auto here = exact.log().find(key);
            if (here == exact.log().end()) {
                continue;
            }
            Slack& slack = slacks[key];
            for (std::size_t n = 0; n < 3; ++n) {
                const double off = abs(there.numbers.x[n] - here->second.numbers.x[n]);
                slack.spread = std::max(slack.spread, std::isfinite(off) ? 2 * off : 0.0);
            }
            for (const std::int64_t word : {here->second.word, there.word}) {
                if (std::ranges::find(slack.words, word) == slack.words.end()) {
                    slack.words.push_back(word);
                }
            }
        }
    }
    return slacks;
}

}  // namespace raytree::check
