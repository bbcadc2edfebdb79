#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>

#include "check/forge.h"
#include "check/planting.h"
#include "check/support.h"
#include "formats/tree_json.h"
#include "scene/input_error.h"

namespace raytree::test {
namespace {

/// Two mistakes at once; whether both change something alone, and how many are named.
struct Pair {
    int tried = 0, both = 0, one = 0, neither = 0;
};

bool names(const check::Report& report, std::string_view id) {
    return std::ranges::any_of(report.mistakes, [&](const check::NamedMistake& named) {
        return named.id == id || std::ranges::find(named.ties, id) != named.ties.end();
    });
}

/// Whether it is seen at all. `judge` names no mistakes.
bool changes(const check::Checker& judge, const check::MistakeRow& row, const Spot& spot) {
    const std::string text = planted(judge, row, spot);
    return !text.empty() && judge.check_text(text, "alone").verdict == check::Verdict::fail;
}

void plant_pair(const check::Checker& checker, const check::MistakeRow& a,
                const check::MistakeRow& b, const Spot& spot, Pair& pair) {
    check::Laws laws = check::model_laws();
    a.apply(laws);
    b.apply(laws);
    check::Laws only = check::model_laws();
    b.apply(only);
    RayTree<double> tree, second;
    try {
        tree = check::forge_tree(checker.place(), laws, spot.i, spot.j);
        second = check::forge_tree(checker.place(), only, spot.i, spot.j);
    } catch (const InputError&) {
        return;
    }
    if (!finite(tree) || !finite(second) || tree.rays.size() > 3000) {
        return;
    }
    // Where the second undoes the first there are not two.
    const std::string text = write_tree_json(tree);
    if (text == write_tree_json(second)) {
        return;
    }
    const check::Report report = checker.check_text(text, "pair");
    const int named = (names(report, a.id) ? 1 : 0) + (names(report, b.id) ? 1 : 0);
    ++pair.tried;
    (named == 2 ? pair.both : named == 1 ? pair.one : pair.neither) += 1;
}

TEST_CASE("of planted pairs of mistakes both are named in at least half") {
    check::CheckOptions options;
    options.profile = "lecture";
    Pair pair;
    const bool thorough = std::getenv("RAYTREE_PLANTED_TABLE") != nullptr;
    const int wanted = thorough ? 120 : is_slow ? 3 : 12;
    unsigned seed = 12345;
    const auto next = [&](std::size_t n) {
        seed = seed * 1664525U + 1013904223U;
        return static_cast<std::size_t>(seed >> 8U) % n;
    };
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}, std::size_t{13}}) {
        const Scene scene = data_scene(spots[k].scene);
        const check::Checker checker(scene, options);
        check::CheckOptions unnamed = options;
        unnamed.name_mistakes = false;
        const check::Checker judge(scene, unnamed);
        const int until = pair.tried + wanted / 3;
        for (int n = 0; n < 2000 && pair.tried < until; ++n) {
            const check::MistakeRow& a = check::catalogue()[next(check::catalogue().size())];
            const check::MistakeRow& b = check::catalogue()[next(check::catalogue().size())];
            if (&a != &b && changes(judge, a, spots[k]) && changes(judge, b, spots[k])) {
                plant_pair(checker, a, b, spots[k], pair);
            }
        }
    }
    MESSAGE(pair.tried << " pairs: both named in " << pair.both << ", one in " << pair.one
                       << ", none in " << pair.neither);
    CHECK(2 * pair.both >= pair.tried);
}

}  // namespace
}  // namespace raytree::test
