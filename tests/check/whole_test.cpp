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
    CHECK(findings(replaced(right, "\"refracted\": ", "\"refracted\": 1")).size() == 1);
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
