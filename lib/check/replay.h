#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <unordered_map>
#include <vector>

#include "check/finding.h"
#include "check/laws.h"
#include "check/met_before.h"
#include "check/names.h"

namespace raytree::check {

/// How far a quantity may be off, and what else it may be, because the submission's own rounding
/// could have made it so. Found by working through it again with every number moved a little.
struct Slack {
    double spread = 0;                ///< of numbers
    std::vector<std::int64_t> words;  ///< of decisions: what came out
};
using Slacks = std::unordered_map<std::uint64_t, Slack>;

/// How many quantities were compared and how many of them are wrong in themselves, by what they are
/// and where.
struct Tally {
    struct Key {
        Field field;
        RayKind kind;
        int level;
        auto operator<=>(const Key&) const = default;
    };
    struct Count {
        std::size_t compared = 0, wrong = 0;
    };
    std::map<Key, Count> counts;
    std::map<Key, std::size_t> missing, extra;  ///< rays; the field says nothing
};

struct ReplayOptions {
    double rtol = 1e-5;
    const Slacks* slacks = nullptr;
    const RayTree<double>* truth = nullptr;            ///< tells what follows from what
    std::size_t enough = 1000;                         ///< causes after which to stop
    std::optional<std::uint64_t> give_up_at{};         ///< the cause (its key) at which to stop
    const std::set<std::uint64_t>* excused = nullptr;  ///< causes (their keys) that do not count
    std::size_t most_rays = ~std::size_t{0};
    MetBefore* met_before = nullptr;  ///< where to look up what rays meet
    double noise = 0;  ///< how far to move every number, in units of the submission's precision
    unsigned seed = 0;
    Tally* tally = nullptr;  ///< where to count what is compared
    bool logs = false;       ///< whether to remember what the laws gave
};

/// Works through a submission ray by ray: each quantity is computed by the laws from the
/// submission's own values of what it depends on (from what the laws gave where it has none), and
/// compared.
class Replay {
  public:
    Replay(const Place& place, const Names& names, const Laws& laws, const Submission& submission,
           const ReplayOptions& options);

    void run();

    /// In the order of computation. Those without `follows_from` are causes.
    const std::vector<Finding>& findings() const { return findings_; }
    std::size_t causes() const { return causes_; }
    /// What the laws gave, by quantity: numbers, or a decision.
    struct Logged {
        Numbers numbers;
        std::int64_t word = 0;
    };
    const std::unordered_map<std::uint64_t, Logged>& log() const { return log_; }
    std::size_t compared() const { return compared_; }  ///< quantities

  private:
    using Taint = std::ptrdiff_t;  ///< place of the finding that a value stems from; -1: none
    static constexpr Taint clean = -1;
    static constexpr std::size_t none = ~std::size_t{0};

    /// Where the walk stands: the submission's ray and the true one that corresponds to it.
    struct At {
        std::size_t ray;
        std::size_t truth;
    };
    struct Outcome {
        Spectrum intensity;
        double attenuation = 1;
        Taint taint = clean;
    };
    struct Word {
        std::int64_t code = 0;
        std::string_view text;
    };

    Outcome follow(At at, Step& step, Taint taint);
    Outcome end(At at, const Step& step, Taint taint);
    bool meet(At at, Step& step, Taint& taint);
    bool meet_given(At at, Step& step, const std::optional<Hit<double>>& hit,
                    const Interval<double>& interval, Taint& taint);
    std::optional<Hit<double>> along_the_ray(const Step& step, const Interval<double>& interval,
                                             const TreeHit<double>& given) const;
    bool meets_start(const Step& from, RayKind kind, const std::string& object, double t) const;
    void surface(At at, Step& step, Taint& taint);
    Taint lights(At at, const Step& step, Terms& terms, Taint taint);
    Taint light(At at, const Step& step, std::size_t light, Terms& terms, Taint taint);
    double rounding(double size) const;
    bool set_off(At at, const Step& from, RayKind kind, const Vec& direction, Vec& origin);
    bool aims_from(At at, const Vec& origin, const Shine& shine);
    bool is_in_between(const Blocker<double>& given, const Step& step, const Shine& shine) const;
    void see_blocker(At at, const Step& step, Shine& shine, const Passage& passage, Taint& taint);
    Passage passage_to(std::size_t from, const Step& step, const Shine& shine) const;
    Taint shadow_ray(At at, std::size_t from, const Step& step, Shine& shine, Taint taint);
    struct Grown {
        Terms::Branch branch;
        Terms::Branch alternative;  ///< of a missing ray: what the true one adds
        std::optional<Reason> reason;
        Taint taint = clean;
    };
    Grown grow(At at, const Step& step, RayKind kind, Taint taint);
    void sum(At at, const Step& step, Terms& terms, const Grown& reflected, const Grown& refracted,
             Taint& taint);

    template <class V> void see(At at, Field field, V& value, double scale, Taint& taint);
    void see_numbers(At at, Field field, Numbers& value, double scale, Taint& taint);
    bool agree(const Numbers& a, const Numbers& b, double tolerance, double& error) const;
    double tolerance(std::size_t ray, Field field, double scale) const;
    void decide(At at, Field field, const Word& expected, const Word& found, Taint& taint);
    bool may_be(std::uint64_t key, std::int64_t word) const;
    Taint report(Finding finding);
    void start_finding(Finding& finding, std::size_t ray) const;
    void count(std::size_t ray, Field field);

    std::size_t child(std::size_t parent, RayKind kind) const;
    std::size_t shadow_child(std::size_t parent, std::size_t light) const;
    std::size_t true_child(std::size_t parent, RayKind kind, const std::string& light) const;
    void report_second_children(At at, Taint taint);
    bool full() const {
        return causes_ >= options_.enough || rays_ >= options_.most_rays ||
               findings_.size() >= most_findings_;
    }
    static constexpr std::size_t most_findings_ = 20'000;
    void note(std::uint64_t key, std::int64_t word) {
        if (options_.logs) {
            log_[key].word = word;
        }
    }
    double moved(double x, double scale);

    const Place& place_;
    const Names& names_;
    const Laws& laws_;
    const Submission& submission_;
    ReplayOptions options_;
    std::vector<Finding> findings_;
    std::size_t causes_ = 0;
    std::size_t compared_ = 0;
    std::size_t rays_ = 0;
    double darkest_;  ///< colours are compared to at least this
    std::vector<std::vector<std::size_t>> true_children_;
    std::unordered_map<std::uint64_t, Logged> log_;
    std::optional<std::mt19937> random_;  ///< where numbers are to be moved
};

/// How far every quantity of the submission may be off by its own rounding.
Slacks slacks_of(const Place& place, const Names& names, const Laws& laws,
                 const Submission& submission, const ReplayOptions& options);

}  // namespace raytree::check
