#include <doctest/doctest.h>

#include "check/support.h"
#include "formats/tree_json.h"
#include "tree/record.h"

namespace raytree::test {
namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to,
                     bool everywhere = false) {
    std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    for (; at != std::string::npos; at = everywhere ? text.find(from, at + to.size()) : text.npos) {
        text.replace(at, from.size(), to);
    }
    return text;
}

TEST_CASE("what a right tree says of levels, counts and materials is held against its rays") {
    const Scene scene = data_scene("glass-ball");
    const check::Checker checker(scene, {});
    const std::string right = write_tree_json(record_tree(World<double>(scene), 210, 286));
    const auto findings = [&](const std::string& text) {
        const check::Report report = checker.check_text(text, "tree.json");
        CHECK((report.verdict == check::Verdict::pass) == report.findings.empty());
        return report.findings;
    };
    CHECK(findings(right).empty());
    const auto level = findings(replaced(right, "\"level\": 2", "\"level\": 7"));
    REQUIRE(level.size() == 1);
    CHECK(level.front().subject.find("/level") != std::string::npos);
    CHECK(level.front().reason.find("must be 2") != std::string::npos);
    const auto material =
        findings(replaced(right, "\"material\": \"glass\"", "\"material\": \"floor\""));
    REQUIRE(material.size() == 1);
    CHECK(material.front().subject == "material");
    for (const std::string count : {"primary", "reflected", "refracted", "shadow", "levels"}) {
        CAPTURE(count);
        const auto wrong = findings(replaced(right, "\"" + count + "\": ", "\"" + count + "\": 1"));
        REQUIRE(wrong.size() == 1);
        CHECK(wrong.front().subject == "/counts/" + count);
    }
    const auto lights = findings(replaced(right, "\"lights\": 2", "\"lights\": 3"));
    REQUIRE(lights.size() == 1);
    CHECK(lights.front().reason == "is 3; the scene has 2");
}

TEST_CASE("a tree of another scene is said to be one") {
    const Scene scene = data_scene("nested-media");
    check::CheckOptions options;
    options.scene_sha256 = std::string(64, 'a');
    const check::Checker checker(scene, options);
    const Scene other = data_scene("glass-ball");
    RayTree<double> tree = record_tree(World<double>(other), 320, 250);
    tree.scene_sha256 = std::string(64, 'b');
    tree.camera = scene.camera;
    tree.settings = scene.settings;
    const check::Report report = check_tree(checker, tree);
    CHECK(report.verdict == check::Verdict::fail);
    REQUIRE_FALSE(report.findings.empty());
    CHECK(report.findings.front().subject == "scene");
    CHECK(report.findings.front().reason.find("\"glass ball\"") != std::string::npos);
    REQUIRE_FALSE(report.remarks.empty());
    CHECK(report.remarks.back().find("scene.sha256") != std::string::npos);
    // A file may be written anew without becoming another scene.
    RayTree<double> right = record_tree(World<double>(scene), 375, 273);
    right.scene_sha256 = tree.scene_sha256;
    CHECK(check_tree(checker, right).verdict == check::Verdict::pass);
}

TEST_CASE("levels may be counted from 0 as well, by all rays alike") {
    const Scene scene = data_scene("glass-ball");
    const check::Checker checker(scene, {});
    std::string text = write_tree_json(record_tree(World<double>(scene), 210, 286));
    for (int level = 1; level < 10; ++level) {
        const std::string from = "\"level\": " + std::to_string(level);
        if (text.find(from) != std::string::npos) {
            text = replaced(text, from, "\"level\": " + std::to_string(level - 1), true);
        }
    }
    CHECK(checker.check_text(text, "tree.json").verdict == check::Verdict::pass);
}

}  // namespace
}  // namespace raytree::test
