#include "check/assignment.h"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <set>

#include "check/catalogue.h"
#include "check/forge.h"
#include "check/support.h"
#include "check/telling_pixels.h"
#include "folders.h"
#include "formats/output_file.h"
#include "formats/scene_json.h"
#include "scene/input_error.h"

namespace raytree::test {
namespace {

check::Assignment assignment_with(const std::string& members) {
    return check::read_assignment(
        R"({"format": "raytree-assignment/1.0", "scene": {"format": "raytree-scene/1.0",
            "camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0], "horizontal_fov_degrees": 40, "width": 40, "height": 30},
            "objects": [{"type": "sphere", "center": [0, 0, 0], "radius": 1, "material": {}}])" +
            members + "}}",
        "template.json");
}

double red_of_background(const std::string& value, std::uint64_t seed, std::size_t number) {
    const auto assignment = assignment_with(R"(, "background": )" + value);
    return check::variant_of(assignment, seed, number).scene.background.r;
}

std::vector<const check::MistakeRow*> rows_of(const std::vector<const char*>& ids) {
    std::vector<const check::MistakeRow*> rows;
    for (const char* id : ids) {
        rows.push_back(check::find_mistake(id));
    }
    return rows;
}

RayTree<double> tree_with(const check::Place& place, const check::MistakeRow& row,
                          check::PixelPlace at) {
    check::Laws laws = check::model_laws();
    row.apply(laws);
    return check::forge_tree(place, laws, at.i, at.j);
}

}  // namespace

// The published first numbers of SplitMix64 from the seed 1234567.
TEST_CASE("the generator of assignments is SplitMix64") {
    check::SplitMix64 random(1234567);
    CHECK(random.next() == 6457827717110365317U);
    CHECK(random.next() == 3203168211198807973U);
    CHECK(random.next() == 9817491932198370423U);
}

TEST_CASE("values are drawn from their range, in its steps, both ends among them") {
    std::set<double> seen;
    for (std::size_t number = 1; number <= 200; ++number) {
        const double x = red_of_background(R"({"from": 0.2, "to": 0.6, "step": 0.1})", 5, number);
        CHECK(std::abs(x * 10 - std::round(x * 10)) < 1e-12);
        seen.insert(x);
    }
    CHECK(seen == std::set<double>{0.2, 0.3, 0.4, 0.5, 0.6});
    std::set<double> chosen;
    for (std::size_t number = 1; number <= 60; ++number) {
        chosen.insert(
            red_of_background(R"({"one_of": [0, 0.25, {"from": 1, "to": 1}]})", 5, number));
    }
    CHECK(chosen == std::set<double>{0, 0.25, 1});
}

TEST_CASE("seed and number alone decide a variant") {
    const std::string range = R"({"from": 0, "to": 100000, "step": 1})";
    CHECK(red_of_background(range, 5, 3) == red_of_background(range, 5, 3));
    CHECK(red_of_background(range, 5, 3) != red_of_background(range, 5, 4));
    CHECK(red_of_background(range, 5, 3) != red_of_background(range, 6, 3));
}

TEST_CASE("what hides mistakes is warned of, and the ready assignments hide nothing") {
    const check::Variant plain = check::variant_of(assignment_with(R"(, "background": 0)"), 1, 1);
    CHECK(plain.warnings.size() == 1);  // the window is symmetric; nothing shines
    for (const char* name : {"ray-casting", "shadows", "mirrors", "glass"}) {
        CAPTURE(name);
        const std::string file = std::string(RAYTREE_DATA_DIR "/assignments/") + name + ".json";
        const auto assignment = check::read_assignment(read_input(file), file);
        for (std::size_t number = 1; number <= 3; ++number) {
            CHECK(check::variant_of(assignment, 17, number).warnings.empty());
        }
    }
}

TEST_CASE("a template that is none is refused with its place") {
    CHECK_THROWS_AS(assignment_with(R"(, "background": {"from": 2, "to": 1})"), InputError);
    CHECK_THROWS_AS(assignment_with(R"(, "background": {"from": 0, "to": 1, "step": 0})"),
                    InputError);
    CHECK_THROWS_AS(assignment_with(R"(, "background": {"one_of": []})"), InputError);
    CHECK_THROWS_AS(assignment_with(R"(, "background": {"one_of": ["red"]})"), InputError);
}

TEST_CASE("pixels expose what they are said to expose") {
    const Scene scene = data_scene("glass-ball");
    const check::Place place(scene);
    const auto rows = rows_of({"refr.eta_inverted", "shd.missing", "lit.ambient_missing",
                               "refl.plus", "cam.y_flipped", "refl.geometric_normal"});
    const auto known = rows_of(
        {"refr.eta_inverted", "shd.missing", "lit.ambient_missing", "refl.plus", "cam.y_flipped"});
    CHECK(rows.back() == nullptr);  // it leaves no trace, and is no row
    const auto pixels = check::exposing_pixels(place, known, {2, 60, 60});
    REQUIRE(pixels.size() == 2);
    std::set<const check::MistakeRow*> exposed;
    for (const check::TellingPixel& pixel : pixels) {
        const RayTree<double> right =
            check::forge_tree(place, check::model_laws(), pixel.at.i, pixel.at.j);
        CHECK(right.rays.size() == pixel.rays);
        CHECK(pixel.rays <= 60);
        for (const check::MistakeRow* row : known) {
            const bool said = std::ranges::find(pixel.exposes, row) != pixel.exposes.end();
            CHECK(said == check::differ(right, tree_with(place, *row, pixel.at)));
        }
        exposed.insert(pixel.exposes.begin(), pixel.exposes.end());
    }
    CHECK(exposed.size() == known.size());
}

TEST_CASE("pixels that tell mistakes apart give them different trees") {
    const Scene scene = data_scene("glass-ball");
    const check::Place place(scene);
    const auto rows = rows_of({"lit.R_sign", "lit.spec_missing"});
    const auto apart =
        check::pixels_that_tell_apart(place, check::model_laws(), rows, {2, 240, 60});
    CHECK(apart.pairs == 1);
    CHECK(apart.told == 1);
    REQUIRE_FALSE(apart.at.empty());
    CHECK(check::differ(tree_with(place, *rows[0], apart.at[0]),
                        tree_with(place, *rows[1], apart.at[0])));
    const auto same = rows_of({"hit.primary_without_near", "isect.bool_precedence"});
    CHECK(check::pixels_that_tell_apart(place, check::model_laws(), same, {2, 60, 60}).told == 0);
}

}  // namespace raytree::test
