// Which rays are dimmed or hidden.

#include "state/ray_filter.h"

#include <doctest/doctest.h>

#include "app/scenes.h"
#include "drawing/ray_paths.h"
#include "state/commands.h"
#include "state/emphasis.h"
#include "state/steps.h"

namespace raytree::inspector {
namespace {

using By = RayGroup::By;

State shown_scene() {
    State state;
    state.show(test::opened(test::glass_ball_scene()));
    state.pick({40, 30});
    state.poll(std::chrono::seconds(10));
    REQUIRE(state.tree());
    return state;
}

std::size_t count(const State& state, Shown how) {
    std::size_t rays = 0;
    for (const TreeRay<double>& ray : state.tree()->tree.rays) {
        rays += shown(state.look().filter, *state.tree(), ray) == how ? 1 : 0;
    }
    return rays;
}

TEST_CASE("app: what is hidden can be shown again where the tree has no such ray") {
    State state = shown_scene();
    const auto counted = [&](const RayGroup& group) {
        std::optional<std::size_t> rays;
        for (const CountedGroup& one : groups_of(*state.tree(), state.look().filter)) {
            rays = one.group == group ? one.rays : rays;
        }
        return rays;
    };
    const RayGroup object{RayGroup::By::object, "of another pixel"},
        level{RayGroup::By::level, "9"};
    CHECK_FALSE(counted(object));
    run_command(state, "filter.set", "hidden object of another pixel");
    run_command(state, "filter.set", "dimmed level 9");
    CHECK(counted(object) == 0);
    CHECK(counted(level) == 0);
    CHECK(counted(group_of(RayKind::primary)) == 1);
    run_command(state, "filter.clear");
    CHECK_FALSE(counted(object));
}

TEST_CASE("app: the groups of a tree count each of its rays") {
    const State state = shown_scene();
    std::map<By, std::size_t> rays;
    for (const CountedGroup& group : groups_of(*state.tree(), {})) {
        CHECK(group.rays > 0);
        rays[group.group.by] += group.rays;
    }
    const TreeCounts& counts = state.tree()->tree.counts;
    CHECK(rays[By::kind] == counts.all());
    CHECK(rays[By::level] == counts.all());
    CHECK(rays[By::light] == counts.shadow);
    CHECK(rays[By::object] < counts.all());
}

TEST_CASE("app: hiding every group in turn hides just its rays") {
    State state = shown_scene();
    for (const CountedGroup& group : groups_of(*state.tree(), {})) {
        const std::string name = std::string(word_of(group.group.by)) + " " + group.group.name;
        run_command(state, "filter.set", "hidden " + name);
        CHECK(count(state, Shown::hidden) == group.rays);
        CHECK(ray_paths(*state.tree(), Extent(), state.look().filter).size() ==
              state.tree()->tree.rays.size() - group.rays);
        run_command(state, "filter.set", "dimmed " + name);
        CHECK(count(state, Shown::dimmed) == group.rays);
        CHECK(count(state, Shown::hidden) == 0);
        const auto aside = set_aside(state);
        CHECK(static_cast<std::size_t>(std::ranges::count(aside, true)) == group.rays);
        run_command(state, "filter.set", "full " + name);
        CHECK(state.look().filter.empty());
    }
}

TEST_CASE("app: of several groups the least shown counts") {
    State state = shown_scene();
    run_command(state, "filter.set", "dimmed kind shadow");
    run_command(state, "filter.set", "hidden light key");
    for (const TreeRay<double>& ray : state.tree()->tree.rays) {
        const Shown expected = !ray.shadow                  ? Shown::full
                               : ray.shadow->light == "key" ? Shown::hidden
                                                            : Shown::dimmed;
        CHECK(shown(state.look().filter, *state.tree(), ray) == expected);
    }
    CHECK(text_of(state.look().filter) == "hidden: rays to key  ·  dimmed: shadow rays");
    run_command(state, "filter.clear");
    CHECK(text_of(state.look().filter).empty());
    CHECK(count(state, Shown::full) == state.tree()->tree.rays.size());
}

TEST_CASE("app: rays that carry little are hidden or dimmed, shadow rays with their bearer") {
    State state = shown_scene();
    run_command(state, "filter.weight", "0.5");
    const RayTree<double>& tree = state.tree()->tree;
    for (const TreeRay<double>& ray : tree.rays) {
        const TreeRay<double>& bearer = ray.shadow ? tree.rays[*ray.parent] : ray;
        const bool light = largest_component(bearer.weight) < 0.5;
        CHECK(shown(state.look().filter, *state.tree(), ray) ==
              (light ? Shown::hidden : Shown::full));
    }
    const std::size_t hidden = count(state, Shown::hidden);
    CHECK(hidden > 0);
    CHECK(text_of(state.look().filter) == "hidden: less than 0.5 of the pixel");
    run_command(state, "filter.dim_light");
    CHECK(count(state, Shown::dimmed) == hidden);
    run_command(state, "filter.more");
    CHECK(state.look().filter.least_weight == 1);
    run_command(state, "filter.less");
    CHECK(state.look().filter.least_weight == 0.3);
}

TEST_CASE("app: hidden rays are stepped over, and a filter that makes no sense is refused") {
    State state = shown_scene();
    run_command(state, "filter.set", "hidden kind shadow");
    for (auto ray = next_ray(state); ray; ray = next_ray(state)) {
        state.select(*ray);
        CHECK_FALSE(state.selected()->shadow);
    }
    const RayFilter before = state.look().filter;
    for (const char* const bad : {"", "gone kind shadow", "hidden kind", "hidden kind green",
                                  "hidden colour red", "hidden"}) {
        CHECK_THROWS_AS(run_command(state, "filter.set", bad), InputError);
    }
    for (const char* const bad : {"", "2", "-1", "0.1 gone", "much", "nan"}) {
        CHECK_THROWS_AS(run_command(state, "filter.weight", bad), InputError);
    }
    CHECK(state.look().filter == before);
}

}  // namespace
}  // namespace raytree::inspector
