#include "check/mistake_search.h"

#include <algorithm>

namespace raytree::check {
namespace {

constexpr std::size_t rays_looked_at = 400;  // enough to tell mistakes apart
constexpr std::size_t few = 12;              // causes that rounding alone may leave
constexpr std::size_t left_of_a_pair = 2;    // by rounding, at most
constexpr double leap = 5000;                // roundings, which no formula adds up to

/// Where rounding tips a decision, what follows leaps from one value to another. That would excuse
/// every value in between, which no mistake gives.
void leave_out_leaps(Slacks& slacks, const Precision& p) {
    for (auto& [key, slack] : slacks) {
        if (slack.spread > leap * (p.relative + p.absolute)) {
            slack.spread = 0;
        }
    }
}

}  // namespace

MistakeSearch::MistakeSearch(const Place& place, const Names& names, const Laws& laws,
                             const Submission& submission, const ReplayOptions& options,
                             const Report& report)
    : place_(place), names_(names), laws_(laws), submission_(submission), options_(options) {
    for (const Finding& finding : report.findings) {
        if (!finding.follows_from && finding.problem != Problem::whole) {
            held_.insert(key_of(finding));
            rays_.insert(finding.ray);
            first_error_ = first_ ? first_error_ : finding.error;
            first_ = first_ ? first_ : std::optional(key_of(finding));
        }
    }
    // By the truth alone some differences are not held against it: nor are they here.
    options_.truth = nullptr;
    options_.met_before = &met_before_;
    options_.most_rays = rays_looked_at;
    for (const Left& left : left_under(laws_, options_.enough)) {
        if (!held_.contains(left.cause)) {
            excused_.insert(left.cause);
        }
    }
    all_ = std::max<std::size_t>(held_.size(), 1);
    if (!is_rounded()) {
        options_.give_up_at = first_;
    }
}

Laws MistakeSearch::under(std::initializer_list<LawChange> changes) const {
    Laws changed = laws_;
    for (const LawChange change : changes) {
        change(changed);
    }
    return changed;
}

/// Where these laws leave no more than `close`, the submission's rounding may be why.
Candidate MistakeSearch::attempt(const Laws& changed, std::size_t enough, std::size_t close) const {
    const std::vector<Left> causes = left_under(changed, enough);
    Candidate candidate = left_by(causes);
    // Where the first is hardly less wrong, rounding is not why.
    const bool as_wrong = std::ranges::any_of(causes, [this](const Left& left) {
        return left.cause == first_ && 2 * left.error >= first_error_;
    });
    if (candidate.left > 0 && candidate.left <= close && is_rounded() && !as_wrong) {
        // What the student's rounding does to a wrong formula is another thing than what it
        // does to the right one.
        ReplayOptions options = options_;
        options.enough = 1000;
        options.met_before = nullptr;
        Slacks own = slacks_of(place_, names_, changed, submission_, options);
        leave_out_leaps(own, submission_.precision);
        candidate = left_by(left_under(changed, options.enough, &own));
    }
    return candidate;
}

Candidate MistakeSearch::attempt(LawChange way, std::size_t enough) const {
    const std::size_t close = (all_ + few) / 4;
    return attempt(under({way}), is_rounded() ? std::max(enough, close + 1) : enough, close);
}

Candidate MistakeSearch::attempt(const Laws& both) const {
    return attempt(both, is_rounded() ? left_of_a_pair + 1 : 1, left_of_a_pair);
}

bool MistakeSearch::is_rounded() const { return submission_.precision.is_rounded(); }

Candidate MistakeSearch::left_by(const std::vector<Left>& causes) const {
    Candidate candidate;
    candidate.explains_first = true;
    for (const auto& [cause, error] : causes) {
        if (!excused_.contains(cause)) {
            ++candidate.left;
            candidate.rays.insert(cause / 256);
            candidate.explains_first = candidate.explains_first && cause != *first_;
        }
    }
    return candidate;
}

std::vector<MistakeSearch::Left> MistakeSearch::left_under(const Laws& laws, std::size_t enough,
                                                           const Slacks* slacks) const {
    ReplayOptions options = options_;
    options.enough = enough;
    options.excused = excused_.empty() ? nullptr : &excused_;
    options.slacks = slacks ? slacks : options.slacks;
    Replay replay(place_, names_, laws, submission_, options);
    replay.run();
    std::vector<Left> causes;
    for (const Finding& finding : replay.findings()) {
        if (!finding.follows_from) {
            causes.push_back({key_of(finding), finding.error});
        }
    }
    return causes;
}

}  // namespace raytree::check
