// The ray table: its columns, its order, and what is copied from it.

#include "state/table.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>

#include "app/scenes.h"
#include "state/commands.h"
#include "state/natural_order.h"
#include "state/numbers.h"

namespace raytree::inspector {
namespace {

State shown() {
    State state;
    state.show(test::opened(test::glass_ball_scene()));
    state.pick({40, 30});
    state.poll(std::chrono::seconds(10));
    REQUIRE(state.tree());
    return state;
}

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, at);) {
        parts.push_back(part);
    }
    return parts;
}

TEST_CASE("app: columns come and go in their order; the first stays") {
    State state = shown();
    run_command(state, "table.column", "point");
    run_command(state, "table.column", "level");
    run_command(state, "table.column", "met");
    run_command(state, "table.column", "ray");
    CHECK(state.table().columns == std::vector<Column>{Column::ray, Column::t, Column::intensity,
                                                       Column::ended, Column::level,
                                                       Column::point});
    run_command(state, "table.first_columns");
    CHECK(state.table().columns == Table().columns);
    CHECK_THROWS_AS(run_command(state, "table.column", "colour"), InputError);
}

TEST_CASE("app: sorting goes up, down, and back to the tree") {
    State state = shown();
    run_command(state, "table.sort", "t");
    CHECK(state.table().sorted_by == Column::t);
    CHECK_FALSE(state.table().descending);
    run_command(state, "table.sort", "t");
    CHECK(state.table().descending);
    run_command(state, "table.sort", "t");
    CHECK_FALSE(state.table().sorted_by);
    run_command(state, "table.sort", "weight");  // a column that was not there
    CHECK(state.table().has(Column::weight));
    run_command(state, "table.as_tree");
    CHECK_FALSE(state.table().sorted_by);
    run_command(state, "table.sort", "weight");
    run_command(state, "table.column", "weight");  // what is not shown does not sort
    CHECK_FALSE(state.table().sorted_by);
}

TEST_CASE("app: sorted by t, rays without one come last, whichever way") {
    const State state = shown();
    const PixelTree& tree = *state.tree();
    for (const bool descending : {false, true}) {
        const auto rays = sorted_rays(tree, Column::t, descending);
        REQUIRE(rays.size() == tree.tree.rays.size());
        double last = descending ? 1e300 : -1e300;
        bool over = false;
        for (const std::size_t ray : rays) {
            const std::string text = exact_text_of(tree, ray, Column::t);
            if (text.empty()) {
                over = true;
                continue;
            }
            CHECK_FALSE(over);
            const double t = std::stod(text);
            CHECK((descending ? t <= last : t >= last));
            last = t;
        }
    }
}

TEST_CASE("app: every column has a word, a title, and a text of every ray") {
    const State state = shown();
    for (std::size_t k = 0; k < column_count; ++k) {
        const auto column = static_cast<Column>(k);
        CHECK(column_from(text_of(column).word) == column);
        CHECK_FALSE(text_of(column).title.empty());
        const auto rays = sorted_rays(*state.tree(), column, false);
        CHECK(rays.size() == state.tree()->tree.rays.size());
        std::size_t filled = 0;
        for (const std::size_t ray : rays) {
            filled += text_of(*state.tree(), ray, column).empty() ? 0 : 1;
            CHECK(text_of(*state.tree(), ray, column).find('\t') == std::string::npos);
        }
        CHECK(filled > 0);
    }
    CHECK_FALSE(column_from("colour"));
}

TEST_CASE("app: what is copied gives every number back to the last bit") {
    const State state = shown();
    const PixelTree& tree = *state.tree();
    const auto lines = split(
        copied(tree, {0, 2}, {Column::ray, Column::t, Column::point, Column::intensity}), '\n');
    REQUIRE(lines.size() == 3);
    // A spreadsheet takes one number a cell.
    CHECK(split(lines[0], '\t') == std::vector<std::string>{"Ray", "t", "Point x", "Point y",
                                                            "Point z", "Intensity r", "Intensity g",
                                                            "Intensity b"});
    const auto cells = split(lines[1], '\t');
    REQUIRE(cells.size() == 8);
    const TreeRay<double>& ray = tree.tree.rays[0];
    CHECK(cells[0] == "#0 primary");
    CHECK(std::stod(cells[1]) == ray.hit->t);
    CHECK(std::stod(cells[2]) == ray.hit->point.x);
    CHECK(std::stod(cells[4]) == ray.hit->point.z);
    CHECK(std::stod(cells[6]) == ray.intensity.g);
    CHECK(exact(0.1) == "0.1");
    CHECK(std::stod(exact(1.0 / 3)) == 1.0 / 3);
}

TEST_CASE("app: every copied row has as many cells as there are titles") {
    const State state = shown();
    std::vector<Column> all;
    for (std::size_t k = 0; k < column_count; ++k) {
        all.push_back(static_cast<Column>(k));
    }
    const std::size_t rays = state.tree()->tree.rays.size();
    std::vector<std::size_t> every(rays);
    std::iota(every.begin(), every.end(), std::size_t{0});
    const std::string text = copied(*state.tree(), every, all);
    CHECK(std::ranges::count(text, '\n') == static_cast<std::ptrdiff_t>(rays + 1));
    const std::size_t tabs = column_count - 1 + 6 * 2 + 1;  // six triples and a pair of indices
    CHECK(std::ranges::count(text, '\t') == static_cast<std::ptrdiff_t>((rays + 1) * tabs));
}

TEST_CASE("app: names are sorted as a reader does, by the numbers in them") {
    const NaturalOrder before;
    CHECK(before("sphere2", "sphere10"));
    CHECK_FALSE(before("sphere10", "sphere2"));
    CHECK(before("a 2, back", "a 10, back"));
    CHECK(before("a2b10", "a2b11"));
    CHECK(before("ball", "ball 1"));
    CHECK(before("12345678901234567890123", "22345678901234567890123"));
    CHECK(before("007", "8"));
    CHECK(before("07", "7") != before("7", "07"));  // one of the two, so that none is lost
    CHECK_FALSE(before("same 3", "same 3"));
}

TEST_CASE("app: the selected ray is copied as text and as JSON, every digit of it") {
    State state = shown();
    std::string text;
    state.observe([&](const Changes& changes) {
        if (changes.request == Request::copy_text) {
            text = changes.text;
        }
    });
    run_command(state, "copy.ray_json");
    const auto json = nlohmann::json::parse(text);
    CHECK(json["kind"] == "primary");
    CHECK(json["hit"]["t"].get<double>() == state.selected()->hit->t);
    CHECK(json["intensity"][2].get<double>() == state.selected()->intensity.b);
    run_command(state, "copy.ray_text");
    CHECK(text.find("#0 primary ray of pixel 40,30") == 0);
    CHECK(text.find("\t" + exact(state.selected()->hit->t) + "\n") != std::string::npos);
    CHECK(text.find("\t" + exact(state.selected()->hit->point.y)) != std::string::npos);
}

}  // namespace
}  // namespace raytree::inspector
