#include "check/conventions.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "check/catalogue.h"
#include "check/forge.h"
#include "check/picture_mistakes.h"
#include "check/rulebook.h"
#include "check/support.h"
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

TEST_CASE("without a profile the best whole one is taken, and what differs is said") {
    const Scene scene = data_scene("glass-ball");
    const check::Rulebooks books(scene, false);
    const check::Checker checker(scene, {});
    for (const check::Profile& profile : check::profiles()) {
        CAPTURE(profile.name);
        const check::Rulebook& book = books.of(profile);
        RayTree<double> tree = check::forge_tree(book.place, book.laws, 210, 286);
        tree.camera = scene.camera;
        tree.settings = scene.settings;
        const check::Report report = check_tree(checker, tree);
        CHECK(report.verdict == check::Verdict::pass);
        CHECK(report.conventions.empty() == (report.profile == "lecture"));
    }
}

TEST_CASE("one convention of several that a course has does not tell the course") {
    Scene scene = data_scene("glass-ball");
    scene.camera.window = ImagePlane{-0.5, 0.5, -0.375, 0.375};
    const check::Rulebooks books(scene, false);
    const check::Checker checker(scene, {});
    const auto by = [&](std::string_view choice) {
        const check::Rulebook& book =
            books.of(check::with_choice(check::default_choices(), choice));
        RayTree<double> tree = check::forge_tree(book.place, book.laws, 210, 286);
        tree.camera = scene.camera;
        tree.settings = scene.settings;
        return check_tree(checker, tree);
    };
    // The course that has it has a vertical angle of view too, which nothing here shows.
    const check::Report edges = by("sample=edges");
    CHECK(edges.verdict == check::Verdict::fail);
    CHECK(edges.profile == "lecture");
    REQUIRE(edges.mistakes.size() == 1);
    CHECK(edges.mistakes.front().id == "cam.wminus1");
    REQUIRE(edges.conventions.size() == 1);
    CHECK(edges.conventions.front()->value == "edges");
    REQUIRE_FALSE(edges.remarks.empty());
    CHECK(edges.remarks.back().find("--profile weekend") != std::string::npos);
    // All that the profile of corners has.
    CHECK(by("sample=corner").profile == "corner");
    CHECK(by("sample=corner").verdict == check::Verdict::pass);
}

}  // namespace raytree::test
