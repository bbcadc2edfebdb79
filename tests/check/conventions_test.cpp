#include "check/conventions.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

#include "check/catalogue.h"
#include "check/forge.h"
#include "check/picture_mistakes.h"
#include "check/planting.h"
#include "check/rulebook.h"
#include "check/support.h"
#include "formats/tree_json.h"
#include "scene/input_error.h"

namespace raytree::test {

TEST_CASE("every axis has a default first, and every choice of a profile exists") {
    std::set<std::string> names;
    for (const check::Convention* each : check::default_choices()) {
        CHECK(!each->on_scene);
        CHECK(!each->on_laws);
        CHECK(names.insert(std::string(each->axis)).second);
    }
    for (const check::Convention& each : check::conventions()) {
        CAPTURE(each.value);
        const bool of_pictures = std::ranges::any_of(
            check::picture_mistakes(),
            [&](const check::PictureMistakeRow& row) { return row.id == each.mistake; });
        CHECK((each.mistake.empty() || of_pictures || check::find_mistake(each.mistake)));
    }
    for (const check::Profile& profile : check::profiles()) {
        for (const std::string_view choice : profile.named) {
            CAPTURE(choice);
            const auto named = check::with_choice(check::default_choices(), choice);
            const bool is_default = named == check::default_choices();
            CHECK((!is_default || choice == "near=primary"));
        }
    }
    CHECK(check::profiles().front().name == "lecture");
    CHECK_THROWS_AS(check::profile_named("uclaa"), InputError);
}

TEST_CASE("each convention judges by itself: a tree grown by it passes under it alone") {
    const Scene scene = data_scene("glass-ball");
    const check::Rulebooks books(scene, false);
    for (const check::Convention& convention : check::conventions()) {
        CAPTURE(convention.axis);
        CAPTURE(convention.value);
        const auto choices =
            check::with_choice(check::default_choices(),
                               std::string(convention.axis) + "=" + std::string(convention.value));
        const check::Rulebook& book = books.of(choices);
        const RayTree<double> tree = check::forge_tree(book.place, book.laws, 210, 286);
        check::CheckOptions options;
        options.profile = "lecture";
        options.name_mistakes = false;
        const check::Checker checker(scene, options);
        RayTree<double> handed_in = tree;
        handed_in.camera = scene.camera;
        handed_in.settings = scene.settings;
        const check::Report report = check_tree(checker, handed_in);
        if (report.verdict == check::Verdict::pass) {
            continue;  // it changes nothing here
        }
        REQUIRE(report.conventions.size() == 1);
        CHECK(report.conventions.front()->axis == convention.axis);
    }
}

namespace {

RayTree<double> grown_by(const Scene& scene, const check::Rulebook& book, int i, int j) {
    RayTree<double> tree = check::forge_tree(book.place, book.laws, i, j);
    tree.camera = scene.camera;
    tree.settings = scene.settings;
    return tree;
}

}  // namespace

TEST_CASE("a tree by any course's conventions is right where none is asked for") {
    std::map<std::string, std::vector<Spot>> by_scene;
    for (const Spot& spot : spots) {
        by_scene[spot.scene].push_back(spot);
    }
    for (const auto& [name, pixels] : by_scene) {
        const Scene scene = data_scene(name);
        const check::Rulebooks books(scene, false);
        const check::Checker checker(scene, {});
        for (const Spot& spot : pixels) {
            for (const check::Profile& profile : check::profiles()) {
                CAPTURE(name);
                CAPTURE(profile.name);
                const auto tree = grown_by(scene, books.of(profile), spot.i, spot.j);
                for (const int digits : {17, 6}) {
                    const check::Report report =
                        checker.check_text(with_digits(write_tree_json(tree), digits), "a.json");
                    CAPTURE(in_words(report));
                    CHECK(report.verdict == check::Verdict::pass);
                    CHECK(report.mistakes.empty());
                    CHECK(report.conventions.empty() == (report.profile == "lecture"));
                }
            }
        }
        if (is_slow) {
            break;
        }
    }
}

TEST_CASE("of a course that fits, what the tree shows is said, and what it is elsewhere") {
    Scene scene = data_scene("glass-ball");
    scene.camera.window = ImagePlane{-0.5, 0.5, -0.375, 0.375};
    const check::Rulebooks books(scene, false);
    const check::Checker checker(scene, {});
    const auto by = [&](std::string_view choice) {
        const check::Rulebook& book =
            books.of(check::with_choice(check::default_choices(), choice));
        return check_tree(checker, grown_by(scene, book, 210, 286));
    };
    // The course that has it has a vertical angle of view too, which nothing here shows.
    const check::Report edges = by("sample=edges");
    CHECK(edges.verdict == check::Verdict::pass);
    CHECK(edges.profile == "weekend");
    REQUIRE(edges.conventions.size() == 1);
    CHECK(edges.conventions.front()->mistake == "cam.wminus1");
    // No course has it alone: a mistake, and its convention is said.
    const check::Report lone = by("ambient=per-light");
    CHECK(lone.verdict == check::Verdict::fail);
    CHECK(lone.profile == "lecture");
    REQUIRE(lone.mistakes.size() == 1);
    CHECK(lone.mistakes.front().id == "lit.ambient_per_light");
    CHECK(std::ranges::any_of(lone.remarks, [](const std::string& remark) {
        return remark.find("ambient=per-light") != std::string::npos;
    }));
    CHECK(by("sample=corner").profile == "corner");
}

}  // namespace raytree::test
