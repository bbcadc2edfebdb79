#include "check/diagnose.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>

#include "check/catalogue.h"
#include "check/evidence.h"
#include "check/lessons.h"
#include "check/mistake_search.h"
#include "check/one_factor.h"

namespace raytree::check {
namespace {

constexpr std::size_t tried_with_others = 3;   // the best, in search of pairs
constexpr std::size_t most_causes_left = 500;  // by a mistake that is to be named
constexpr std::size_t most_causes_of_a_pair = 200;

/// The fewest left first; of equals in the order of the catalogue. Once one leaves nothing, only
/// others that leave nothing are of interest.
std::vector<Candidate> singles(const MistakeSearch& search) {
    std::vector<Candidate> found;
    std::size_t enough = std::min(search.all(), most_causes_left);
    for (const MistakeRow& row : catalogue()) {
        std::optional<Candidate> best;
        for (const LawChange way : row.ways()) {
            Candidate candidate = search.attempt(way, enough);
            candidate.rows = {&row};
            candidate.way = way;
            if (candidate.explains_first && candidate.left < enough &&
                (!best || candidate.left < best->left)) {
                best = std::move(candidate);
            }
        }
        if (best) {
            enough = best->left == 0 ? 1 : enough;
            found.push_back(*std::move(best));
        }
    }
    std::ranges::stable_sort(found, {}, &Candidate::left);
    return found;
}

/// The two in whichever order leaves nothing. Two that change different steps are the same in both
/// orders; where one undoes the other they are no pair.
std::optional<Candidate> pair_of(const MistakeSearch& search, LawChange one,
                                 const MistakeRow& other) {
    const Laws first = search.under({one});
    for (const LawChange way : other.ways()) {
        const Laws second = search.under({way});
        const Laws after = search.under({one, way});
        const Laws before = search.under({way, one});
        for (const Laws* both : {&after, &before}) {
            const bool tried = both == &before && before == after;
            if (tried || *both == first || *both == second) {
                continue;
            }
            Candidate candidate = search.attempt(*both);
            if (candidate.left == 0) {
                return candidate;
            }
        }
    }
    return std::nullopt;
}

/// Pairs that leave nothing; none where there is none.
std::vector<Candidate> pairs(const MistakeSearch& search, const std::vector<Candidate>& best) {
    std::vector<Candidate> found;
    for (std::size_t k = 0; k < best.size() && k < tried_with_others; ++k) {
        const MistakeRow* const one = best[k].rows.front();
        for (const MistakeRow& other : catalogue()) {
            if (&other == one) {
                continue;
            }
            if (auto pair = pair_of(search, best[k].way, other)) {
                pair->rows = {one, &other};
                found.push_back(*std::move(pair));
            }
        }
        if (!found.empty()) {
            break;
        }
    }
    return found;
}

std::size_t explained(const MistakeSearch& search, const Candidate& candidate) {
    return static_cast<std::size_t>(std::ranges::count_if(
        search.rays(), [&](std::size_t ray) { return !candidate.rays.contains(ray); }));
}

/// What the named mistake makes wrong again and again is one mistake.
void join_causes(Report& report) {
    std::optional<std::size_t> first;
    for (std::size_t k = 0; k < report.findings.size(); ++k) {
        Finding& finding = report.findings[k];
        if (finding.problem == Problem::whole || finding.follows_from) {
            continue;
        }
        if (first) {
            finding.follows_from = first;
        }
        first = first ? first : std::optional(k);
    }
}

std::string rounded_text(double x) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", x);
    return text.data();
}

}  // namespace

NamedMistake named_mistake(const MistakeRow& row) {
    NamedMistake mistake;
    mistake.id = row.id;
    mistake.text = row.text;
    mistake.topic = row.topic;
    mistake.lesson = lesson_of(row.id).name();
    return mistake;
}

void diagnose(const Place& place, const Names& names, const Laws& laws,
              const Submission& submission, const ReplayOptions& options, Report& report) {
    const MistakeSearch search(place, names, laws, submission, options, report);
    if (!search.any()) {
        return;
    }
    const std::vector<Candidate> alone = singles(search);
    if (alone.empty()) {
        return;
    }
    const std::size_t fewest = alone.front().left;
    const auto as_good =
        std::ranges::count_if(alone, [&](const Candidate& c) { return c.left == fewest; });
    if (fewest > 0) {
        const std::vector<Candidate> two =
            search.all() <= most_causes_of_a_pair ? pairs(search, alone) : std::vector<Candidate>();
        if (!two.empty()) {
            const MistakeRow& second = *two.front().rows.back();
            for (const MistakeRow* row : two.front().rows) {
                report.mistakes.push_back(named_mistake(*row));
                report.mistakes.back().rays = explained(search, two.front());
            }
            for (const Candidate& other : alone) {
                const MistakeRow* const row = other.rows.front();
                if (other.left == fewest && row != two.front().rows.front() && row != &second &&
                    pair_of(search, other.way, second)) {
                    report.mistakes.front().ties.emplace_back(row->id);
                }
            }
            for (std::size_t k = 1; k < two.size(); ++k) {
                report.mistakes.back().ties.emplace_back(two[k].rows.back()->id);
            }
            return;
        }
        if (2 * fewest > search.all()) {
            return;  // it explains too little to be named
        }
    }
    NamedMistake best = named_mistake(*alone.front().rows.front());
    const std::optional<double> factor = one_factor(report);
    best.sure = fewest == 0 && as_good == 1 && !factor && is_unmistakable(report);
    if (factor && fewest == 0) {
        report.remarks.push_back("all that is wrong is " + rounded_text(*factor) +
                                 " times what it must be: whatever else multiplies by that would "
                                 "give the same numbers");
    }
    best.rays = explained(search, alone.front());
    for (std::ptrdiff_t k = 1; k < as_good; ++k) {
        best.ties.emplace_back(alone[static_cast<std::size_t>(k)].rows.front()->id);
    }
    report.mistakes.push_back(std::move(best));
    if (fewest == 0) {
        join_causes(report);
    }
}

}  // namespace raytree::check
