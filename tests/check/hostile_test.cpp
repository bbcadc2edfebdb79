#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "check/check.h"
#include "check/support.h"
#include "formats/tree_json.h"
#include "tree/record.h"

namespace raytree::test {
namespace {

using check::Verdict;

const check::Checker& checker() {
    static const Scene scene = data_scene("glass-ball");
    static const check::Checker one(scene, {});
    return one;
}

Verdict verdict_on(const std::string& text) {
    const check::Report report = checker().check_text(text, "hostile.json");
    CAPTURE(in_words(report));
    CHECK(report.findings.size() <= 2000);  // however many rays there are: what bounds the time
    CHECK(report.verdict != Verdict::pass);
    CHECK_FALSE(report.findings.empty());
    return report.verdict;
}

std::string tree_of(const std::string& rays) {
    return R"({"format": "raytree/1.0", "pixel": [210, 286], "rays": [)" + rays + "]}";
}
const std::string primary = R"({"id": 0, "kind": "primary"})";

TEST_CASE("what is no tree is unreadable") {
    CHECK(verdict_on("") == Verdict::unreadable);
    CHECK(verdict_on("nonsense") == Verdict::unreadable);
    CHECK(verdict_on("[]") == Verdict::unreadable);
    CHECK(verdict_on("{\"format\": \"raytree/2.0\"}") == Verdict::unreadable);
    CHECK(verdict_on(tree_of("")) == Verdict::unreadable);
    CHECK(verdict_on(std::string(200'000, '[')) == Verdict::unreadable);
    CHECK(verdict_on(tree_of(primary + ", " + R"({"id": 1, "kind": "primary"})")) ==
          Verdict::unreadable);
    CHECK(verdict_on(tree_of(primary + R"(, {"id": 1, "parent": 9, "kind": "reflected"})")) ==
          Verdict::unreadable);
    CHECK(verdict_on(tree_of(primary + R"(, {"id": 1, "parent": 2, "kind": "reflected"},
        {"id": 2, "parent": 1, "kind": "reflected"})")) == Verdict::unreadable);
    CHECK(verdict_on(tree_of(R"({"kind": "primary", "hit": {"t": "5.3"}})")) ==
          Verdict::unreadable);
    CHECK(verdict_on(tree_of(R"({"kind": "primary", "intensity": [1e999, 0, 0]})")) ==
          Verdict::unreadable);
}

TEST_CASE("what is a tree but says nothing, or only nonsense, fails") {
    CHECK(verdict_on(tree_of(primary)) == Verdict::fail);
    CHECK(verdict_on(tree_of(R"({"kind": "primary", "direction": [0, 0, 0]})")) == Verdict::fail);
    CHECK(verdict_on(tree_of(R"({"kind": "primary", "direction": [1e308, 1e308, 1e308]})")) ==
          Verdict::fail);
    CHECK(verdict_on(tree_of(R"({"kind": "primary", "origin": [1e308, -1e308, 1e308],
        "hit": {"object": "no such", "t": 1e308, "normal": [0, 0, 0]}})")) == Verdict::fail);
    CHECK(verdict_on(R"({"format": "raytree/1.0", "pixel": [9999, 0], "rays": [)" + primary +
                     "]}") == Verdict::fail);
}

TEST_CASE("a number that is none is pointed at, however it is written") {
    for (const std::string none : {"NaN", "nan", "-nan", "Infinity", "-inf", "null", "\"NaN\"",
                                   "\"-infinity\"", "nan(ind)"}) {
        CAPTURE(none);
        const check::Report report = checker().check_text(
            tree_of("\n  {\"kind\": \"primary\", \"direction\": [0, " + none + ", 1]}"),
            "none.json");
        CHECK(report.verdict == Verdict::fail);
        REQUIRE_FALSE(report.findings.empty());
        CHECK(report.findings.front().subject == "line 2, column 36");
        CHECK(report.findings.front().reason.starts_with("direction is not a number"));
        REQUIRE(report.mistakes.size() == 1);
        CHECK(report.mistakes.front().id == "num.nan");
        CHECK_FALSE(report.mistakes.front().sure);
    }
    // Names may be any words.
    std::string text = tree_of(R"({"id": "nan", "kind": "primary", "t": 1, "direction": null,
        "hit": {"object": "inf", "t": NaN}})");
    CHECK(check::take_out_not_numbers(text).size() == 1);
    CHECK(text == tree_of(R"({"id": "nan", "kind": "primary", "t": 1, "direction": null,
        "hit": {"object": "inf", "t": null}})"));
}

TEST_CASE("the tree of another pixel fails, and that of another scene") {
    const Scene scene = data_scene("glass-ball");
    RayTree<double> tree = record_tree(World<double>(scene), 320, 250);
    tree.pixel_i = 210;
    tree.pixel_j = 286;
    CHECK(verdict_on(write_tree_json(tree)) == Verdict::fail);
    const Scene other = data_scene("air-bubble");
    CHECK(verdict_on(write_tree_json(record_tree(World<double>(other), 332, 240))) ==
          Verdict::fail);
}

TEST_CASE("a great many rays, and a very deep tree, are looked through in time") {
    std::string many = primary;
    for (int k = 1; k < 200'000; ++k) {
        many += ",{\"id\":" + std::to_string(k) + ",\"parent\":0,\"kind\":\"reflected\"}";
    }
    CHECK(verdict_on(tree_of(many)) == Verdict::fail);
    std::string deep = primary;
    for (int k = 1; k < 900; ++k) {
        deep += ",{\"id\":" + std::to_string(k) + ",\"parent\":" + std::to_string(k - 1) +
                ",\"kind\":\"refracted\",\"intensity\":[1,1,1]}";
    }
    CHECK(verdict_on(tree_of(deep)) == Verdict::fail);
    std::string bushy = R"({"id":0,"kind":"primary","intensity":[3,1,4]})";
    for (int k = 1; k < (1 << 15); ++k) {
        bushy += ",{\"id\":" + std::to_string(k) + ",\"parent\":" + std::to_string((k - 1) / 2) +
                 ",\"kind\":\"" + (k % 2 == 1 ? "reflected" : "refracted") +
                 "\",\"intensity\":[1,1,1],\"direction\":[0,1,0.5]}";
    }
    CHECK(verdict_on(tree_of(bushy)) == Verdict::fail);
}

TEST_CASE("the tree's intensity is that of its primary ray") {
    const Scene scene = data_scene("glass-ball");
    RayTree<double> tree = record_tree(World<double>(scene), 210, 286);
    CHECK(check_tree(checker(), tree).verdict == Verdict::pass);
    tree.intensity = Rgb<double>(tree.intensity.b, tree.intensity.g, tree.intensity.r);
    const check::Report report = check_tree(checker(), tree);
    CHECK(report.verdict == Verdict::fail);
    CHECK(report.findings.front().subject == "intensity");
    // Where nothing else is said, it is compared.
    CHECK(verdict_on(R"({"format": "raytree/1.0", "pixel": [210, 286], "intensity": [9, 9, 9],
        "rays": [{"kind": "primary"}]})") == Verdict::fail);
}

TEST_CASE("a file that is too large is refused unread") {
    const auto file = std::filesystem::temp_directory_path() / "raytree-large-submission.json";
    std::ofstream(file) << "{";
    std::filesystem::resize_file(file, std::uintmax_t{1} << 30);
    const auto start = std::chrono::steady_clock::now();
    const check::Report report = checker().check_file(file, file.string());
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    std::filesystem::remove(file);
    CHECK(report.verdict == Verdict::unreadable);
    CHECK(report.findings.front().reason.find("1024 MB") != std::string::npos);
    CHECK(took.count() < 1);
}

}  // namespace
}  // namespace raytree::test
