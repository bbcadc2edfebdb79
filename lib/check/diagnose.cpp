#include "check/diagnose.h"

#include <algorithm>
#include <set>

#include "check/catalogue.h"
#include "check/lessons.h"

namespace raytree::check {
namespace {

constexpr std::size_t rays_looked_at = 400;    // enough to tell mistakes apart
constexpr std::size_t tried_with_others = 3;   // the best, in search of pairs
constexpr std::size_t most_causes_left = 500;  // by a mistake that is to be named
constexpr std::size_t most_causes_of_a_pair = 200;
constexpr std::size_t left_of_a_pair = 2;  // by rounding, at most

using Key = std::uint64_t;  // of a finding

struct Candidate {
    std::vector<const MistakeRow*> rows;
    LawChange way = nullptr;  ///< of a single one: how it is made
    std::size_t left = 0;     ///< causes that it does not explain
    bool explains_first = false;
    std::set<std::size_t> rays;  ///< that are wrong still
};

class Search {
  public:
    Search(const Place& place, const Names& names, const Laws& laws, const Submission& submission,
           ReplayOptions options, const Report& report)
        : place_(place), names_(names), laws_(laws), submission_(submission), options_(options) {
        for (const Finding& finding : report.findings) {
            if (!finding.follows_from && finding.problem != Problem::whole) {
                held_.insert(key_of(finding));
                rays_.insert(finding.ray);
                first_ = first_ ? first_ : std::optional(key_of(finding));
            }
        }
        // By the truth alone some differences are not held against it: nor are they here.
        options_.truth = nullptr;
        options_.most_rays = rays_looked_at;
        for (const Key key : keys_under(laws_, options_.enough)) {
            if (!held_.contains(key)) {
                excused_.insert(key);
            }
        }
        all_ = std::max<std::size_t>(held_.size(), 1);
        if (!is_rounded()) {
            options_.give_up_at = first_;
        }
    }

    bool any() const { return first_.has_value(); }
    std::size_t all() const { return all_; }
    const std::set<std::size_t>& rays() const { return rays_; }

    Candidate attempt(const std::vector<LawChange>& changes, std::size_t enough) const {
        Laws changed = laws_;
        for (const LawChange change : changes) {
            change(changed);
        }
        Candidate candidate = left_by(keys_under(changed, enough + excused_.size() + 1));
        const bool close = changes.size() == 1 ? 4 * candidate.left <= all_ + few_
                                               : candidate.left <= left_of_a_pair;
        if (candidate.left > 0 && close && is_rounded()) {
            // What the student's rounding does to a wrong formula is another thing than what it
            // does to the right one.
            ReplayOptions options = options_;
            options.enough = 1000;
            const Slacks own = slacks_of(place_, names_, changed, submission_, options);
            candidate = left_by(keys_under(changed, options.enough, &own));
        }
        return candidate;
    }

  private:
    bool is_rounded() const {
        return submission_.precision.relative > 1e-12 || submission_.precision.absolute > 0;
    }

    Candidate left_by(const std::vector<Key>& keys) const {
        Candidate candidate;
        candidate.explains_first = true;
        for (const Key key : keys) {
            if (!excused_.contains(key)) {
                ++candidate.left;
                candidate.rays.insert(key / 256);
                candidate.explains_first = candidate.explains_first && key != *first_;
            }
        }
        return candidate;
    }

    std::vector<Key> keys_under(const Laws& laws, std::size_t enough,
                                const Slacks* slacks = nullptr) const {
        ReplayOptions options = options_;
        options.enough = enough;
        options.slacks = slacks ? slacks : options.slacks;
        Replay replay(place_, names_, laws, submission_, options);
        replay.run();
        std::vector<Key> keys;
        for (const Finding& finding : replay.findings()) {
            if (!finding.follows_from) {
                keys.push_back(key_of(finding));
            }
        }
        return keys;
    }

    static constexpr std::size_t few_ = 12;
    const Place& place_;
    const Names& names_;
    const Laws& laws_;
    const Submission& submission_;
    ReplayOptions options_;
    std::set<Key> held_, excused_;
    std::set<std::size_t> rays_;
    std::optional<Key> first_;
    std::size_t all_ = 1;
};

/// The fewest left first; of equals in the order of the catalogue.
std::vector<Candidate> singles(const Search& search) {
    std::vector<Candidate> found;
    const std::size_t enough = std::min(search.all(), most_causes_left);
    for (const MistakeRow& row : catalogue()) {
        std::optional<Candidate> best;
        for (const LawChange way : row.ways()) {
            Candidate candidate = search.attempt({way}, enough);
            candidate.rows = {&row};
            candidate.way = way;
            if (candidate.explains_first && candidate.left < enough &&
                (!best || candidate.left < best->left)) {
                best = std::move(candidate);
            }
        }
        if (best) {
            found.push_back(*std::move(best));
        }
    }
    std::ranges::stable_sort(found, {}, &Candidate::left);
    return found;
}

/// The two in whichever order leaves nothing.
std::optional<Candidate> pair_of(const Search& search, LawChange one, const MistakeRow& other) {
    for (const LawChange way : other.ways()) {
        for (const auto& changes : {std::vector{one, way}, std::vector{way, one}}) {
            Candidate candidate = search.attempt(changes, left_of_a_pair);
            if (candidate.left == 0) {
                return candidate;
            }
        }
    }
    return std::nullopt;
}

/// Pairs that leave nothing; none where there is none.
std::vector<Candidate> pairs(const Search& search, const std::vector<Candidate>& best) {
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

std::size_t explained(const Search& search, const Candidate& candidate) {
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

}  // namespace

bool tells_enough(const Report& report) {
    std::size_t decisions = 0;
    for (const Finding& finding : report.findings) {
        if (finding.problem == Problem::differs && finding.found.numbers.size > 0) {
            return true;
        }
        decisions += finding.problem != Problem::whole && !finding.follows_from ? 1 : 0;
    }
    return decisions > 2;
}

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
    const Search search(place, names, laws, submission, options, report);
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
    best.sure = fewest == 0 && as_good == 1 && tells_enough(report);
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
