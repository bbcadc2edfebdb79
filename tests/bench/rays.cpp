// Rates of closest-hit and any-hit rays beside Embree, and the error of each answer.

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "support/embree.h"
#include "support/generate.h"
#include "support/report.h"

using namespace raytree;
using namespace raytree::bench;

namespace {

constexpr std::size_t rays_per_run = 1 << 16;
constexpr std::size_t largest_for_errors = 1'500'000;

struct Subject {
    Scene scene;
    std::unique_ptr<Intersector<double>> ours;
    std::unique_ptr<Intersector<Quad>> reference;
    std::unique_ptr<EmbreeScene> fast, robust;
};

/// The largest relative error of t over the rays on whose meeting anything both agree, and the
/// number of those on which they do not.
struct Errors {
    double largest = 0;
    std::size_t wrong = 0;
    void add(bool met, double t, const std::optional<Hit<Quad>>& truth) {
        if (met != truth.has_value()) {
            ++wrong;
        } else if (met) {
            const Quad error = (static_cast<Quad>(t) - truth->t) / truth->t;
            largest = std::max(largest, std::abs(static_cast<double>(error)));
        }
    }
};

using Queries = std::vector<Query<double>>;

/// The same queries, asked in every way there is, all or a part of them.
class Asking {
  public:
    Asking(const Subject& subject, const Queries& queries, RayOrder order, bool any)
        : s_(subject),
          queries_(queries),
          coherent_(order == RayOrder::coherent),
          any_(any),
          hits_(queries.size()),
          met_(queries.size()),
          theirs_(queries.size()) {}

    std::size_t size() const { return queries_.size(); }

    void one_by_one() {
        NoTestCount tests;
        for (std::size_t k = 0; k < queries_.size(); ++k) {
            const auto& [ray, leaving, interval] = queries_[k];
            if (any_) {
                met_[k] = s_.ours->any(ray, leaving, interval, tests) ? 1 : 0;
            } else {
                hits_[k] = s_.ours->closest(ray, leaving, interval, tests).value_or(Hit<double>{});
            }
        }
    }

    void together(std::size_t first, std::size_t count) {
        const auto some = std::span(queries_).subspan(first, count);
        const Together how = coherent_ ? Together::coherent : Together::any_order;
        if (any_) {
            s_.ours->any(some, std::span(met_).subspan(first, count), how);
        } else {
            s_.ours->closest(some, std::span(hits_).subspan(first, count), how);
        }
    }

    void embree(const EmbreeScene& scene, bool packets, std::size_t first, std::size_t count) {
        const auto some = std::span(queries_).subspan(first, count);
        const auto hits = std::span(theirs_).subspan(first, count);
        if (packets) {
            any_ ? scene.any_packets(some, hits, coherent_)
                 : scene.closest_packets(some, hits, coherent_);
        } else {
            any_ ? scene.any(some, hits) : scene.closest(some, hits);
        }
    }

  private:
    const Subject& s_;
    const Queries& queries_;
    bool coherent_, any_;
    std::vector<Hit<double>> hits_;
    std::vector<std::uint8_t> met_;
    std::vector<EmbreeHit> theirs_;
};

class Race {
  public:
    Race(const Options& options, Report& report) : options_(options), report_(report) {}

    void run(const std::string& name, std::size_t size) {
        Subject s;
        s.scene = generate(name, size);
        s.ours = std::make_unique<Intersector<double>>(s.scene);
        if (s.ours->shapes().size() <= largest_for_errors && !options_.quick) {
            s.reference = std::make_unique<Intersector<Quad>>(s.scene);
        }
        if (EmbreeScene::available()) {
            s.fast = std::make_unique<EmbreeScene>(s.scene, EmbreeMode::fast);
            s.robust = std::make_unique<EmbreeScene>(s.scene, EmbreeMode::robust);
        }
        for (const RayOrder order : ray_orders) {
            for (const bool any : {false, true}) {
                const auto queries = make_rays(s.scene, *s.ours, order, any, rays_per_run);
                if (!queries.empty()) {
                    measure(name, s, order, any, queries);
                }
            }
        }
    }

  private:
    void measure(const std::string& name, const Subject& s, RayOrder order, bool any,
                 const Queries& queries) {
        Asking ask(s, queries, order, any);
        std::vector<Rival> rivals = {{"one", [&] { ask.one_by_one(); }},
                                     {"together", [&] { ask.together(0, ask.size()); }}};
        for (const EmbreeScene* embree : {s.fast.get(), s.robust.get()}) {
            for (const bool packets : {false, true}) {
                if (embree) {
                    rivals.push_back(
                        {packets ? "embree packets" : "embree one",
                         [&ask, embree, packets] { ask.embree(*embree, packets, 0, ask.size()); }});
                }
            }
        }
        const auto times = in_turn(rivals, options_.rounds);
        report(name, s, order, any, queries, times, on_all_cores(ask, s, times));
    }

    /// The waiting for ours and for Embree's better way in ROBUST mode, on all cores.
    std::vector<Timing> on_all_cores(Asking& ask, const Subject& s,
                                     const std::vector<Timing>& times) const {
        std::vector<Rival> rivals = {{"together", [&] {
                                          in_parts(ask.size(),
                                                   [&](std::size_t first, std::size_t count) {
                                                       ask.together(first, count);
                                                   });
                                      }}};
        if (s.robust) {
            const bool packets = times[5].median < times[4].median;
            rivals.push_back({"embree", [&, packets] {
                                  in_parts(ask.size(), [&](std::size_t first, std::size_t count) {
                                      ask.embree(*s.robust, packets, first, count);
                                  });
                              }});
        }
        return in_turn(rivals, options_.rounds, wall_seconds);
    }

    void report(const std::string& name, const Subject& s, RayOrder order, bool any,
                const Queries& queries, const std::vector<Timing>& times,
                const std::vector<Timing>& on_all) {
        const auto rate = [&](const Timing& t) {
            return static_cast<double>(queries.size()) / t.median / 1e6;
        };
        std::vector<Cell> cells = {name,
                                   {static_cast<double>(s.ours->shapes().size()), 0},
                                   name_of(order),
                                   any ? "any" : "closest",
                                   {rate(times[0])},
                                   {rate(times[1])},
                                   {(times[1].high - times[1].low) / times[1].median * 100, 0}};
        for (std::size_t k = 2; k < 6; ++k) {
            cells.push_back({k < times.size() ? rate(times[k]) : NAN});
        }
        if (times.size() > 2) {
            const auto best = [&](std::size_t k) {
                return times[k].median < times[k + 1].median ? times[k] : times[k + 1];
            };
            cells.push_back({speedup(times[1], best(4))});
            cells.push_back({speedup(times[1], best(2))});
            cells.push_back({speedup(times[0], times[4])});
        } else {
            cells.insert(cells.end(), 3, {NAN});
        }
        cells.push_back({rate(on_all[0])});
        cells.push_back({on_all.size() > 1 ? speedup(on_all[0], on_all[1]) : NAN});
        add_errors(cells, s, any, queries);
        report_.row(cells);
    }

    void add_errors(std::vector<Cell>& cells, const Subject& s, bool any,
                    const Queries& queries) const {
        if (any || !s.reference) {
            cells.insert(cells.end(), 4, {NAN});
            return;
        }
        Queries sample;
        for (std::size_t k = 0; k < queries.size(); k += queries.size() / 500 + 1) {
            sample.push_back(queries[k]);
        }
        std::vector<Hit<double>> hits(sample.size());
        std::vector<EmbreeHit> theirs(sample.size());
        s.ours->closest(sample, hits, Together::any_order);
        if (s.robust) {
            s.robust->closest(sample, theirs);
        }
        Errors of_ours, of_theirs;
        NoTestCount tests;
        for (std::size_t k = 0; k < sample.size(); ++k) {
            const Ray<Quad> ray{vector_cast<Quad>(sample[k].ray.origin),
                                vector_cast<Quad>(sample[k].ray.direction), 0};
            const auto truth = s.reference->closest(ray, no_primitive, {}, tests);
            of_ours.add(hits[k].primitive != no_primitive, hits[k].t, truth);
            of_theirs.add(theirs[k].met, static_cast<double>(theirs[k].t), truth);
        }
        cells.push_back({of_ours.largest, -2});
        cells.push_back({static_cast<double>(of_ours.wrong), 0});
        cells.push_back({s.robust ? of_theirs.largest : NAN, -2});
        cells.push_back({s.robust ? static_cast<double>(of_theirs.wrong) : NAN, 0});
    }

    const Options& options_;
    Report& report_;
};

void race(const Options& options) {
    Report report(options, "Rays: closest and any hit, one thread, double beside Embree's float");
    report.table(
        "Million rays a second. `one`: a ray at a time; `many`: handed over together. "
        "F: Embree's fast mode, R: ROBUST; 1: a ray at a time, 16: packets. "
        "many/R, many/F: ours over Embree's best; one/R1: single rays. `all`: handed over "
        "together on all cores, by the clock; all/R: over Embree's best there. "
        "Errors: largest relative error of t, and rays wrongly said to hit or miss.",
        {"scene", "shapes", "rays",  "hit",   "one",     "many",   "± %",
         "F 1",   "F 16",   "R 1",   "R 16",  "many/R",  "many/F", "one/R1",
         "all",   "all/R",  "error", "wrong", "R error", "R wrong"});
    std::vector<std::size_t> sizes = {100, 1'000, 10'000, 100'000, 1'000'000, 10'000'000};
    sizes.resize(options.quick ? 2 : 6);
    if (options.shapes > 0) {
        sizes = {options.shapes};
    }
    Race race(options, report);
    for (const std::string& name : generated_names()) {
        for (const std::size_t size : sizes) {
            if (!options.scene.empty() && options.scene != name) {
                continue;
            }
            race.run(name, size);
        }
    }
    if (!EmbreeScene::available()) {
        report.note("Built without Embree (Debian: libembree-dev): raytree alone was measured.");
    }
    report.finish();
}

}  // namespace

int main(int argc, char** argv) {
    return bench::run("rays", "rates of rays beside Embree, and errors", argc, argv, race);
}
