#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/scenes.h"
#include "formats/tree_json.h"
#include "state/commands.h"
#include "state/contrast_lines.h"
#include "state/counts.h"
#include "state/diagram_looks.h"
#include "state/marked_texts.h"
#include "state/ray_filter.h"
#include "state/recent.h"
#include "state/table.h"
#include "state/thing_details.h"
#include "tree/explain.h"
#include "tree/record.h"

namespace raytree::inspector {
namespace {

namespace fs = std::filesystem;

/// A tree's file that is gone when the test is over.
struct TreeFile {
    fs::path path = test::own_path("raytree-compare-test.json");
    TreeFile(const RayTree<double>& tree, const Scene* scene) {
        std::ofstream(path, std::ios::binary) << write_tree_json(tree, scene);
    }
    explicit TreeFile(const std::string& text) { std::ofstream(path, std::ios::binary) << text; }
    ~TreeFile() { fs::remove(path); }
};

RayTree<double> true_tree(const Scene& scene) { return record_tree(World<double>(scene), 40, 30); }

/// One that ends at another depth than the scene it says it is of.
RayTree<double> tree_of_depth(int depth, const Scene& scene) {
    Scene other = scene;
    other.settings.max_depth = depth;
    RayTree<double> tree = true_tree(other);
    tree.settings = scene.settings;
    return tree;
}

std::size_t count(const State& state, RayMark mark) {
    return static_cast<std::size_t>(std::ranges::count(state.tree()->contrast->marks, mark));
}

std::size_t first_of(const RayTree<double>& tree, RayKind kind) {
    return std::ranges::find(tree.rays, kind, &TreeRay<double>::kind)->id;
}

TEST_CASE("app: a tree that is opened is shown as it is recorded, beside the true one") {
    const Scene scene = test::glass_ball_scene();
    RayTree<double> theirs = true_tree(scene);
    const std::size_t ray = first_of(theirs, RayKind::refracted);
    theirs.rays[ray].hit->t *= 1.5;
    theirs.generator = "Ada's tracer";
    const TreeFile file(theirs, &scene);
    State state;
    test::run_and_wait(state, "file.open", file.path.string());
    CHECK(state.tree()->recorded);
    CHECK(state.tree()->tree.rays[ray].hit->t == theirs.rays[ray].hit->t);
    CHECK(state.message().find("Ada's tracer") != std::string::npos);
    CHECK(state.message().find("as recorded") != std::string::npos);
    CHECK(state.side_pane() == SidePane::compare);
    CHECK(state.tree()->mark(ray) == RayMark::different);
    CHECK(count(state, RayMark::different) == 1);
    const auto& lines = state.tree()->contrast->lines;
    REQUIRE_FALSE(lines.empty());
    CHECK(lines.front().ray == ray);
    test::run_and_wait(state, "compare.next");
    CHECK(state.selected()->id == ray);
    // The other of the two is the true one; the same ray stays selected.
    test::run_and_wait(state, "compare.swap");
    CHECK_FALSE(state.tree()->recorded);
    CHECK(state.tree()->tree.rays[ray].hit->t == true_tree(scene).rays[ray].hit->t);
    CHECK(state.selected()->id == ray);
    CHECK(state.tree()->mark(ray) == RayMark::different);
    CHECK(state.message().find("raytree has traced") != std::string::npos);
}

TEST_CASE("app: a right tree has nothing marked") {
    const Scene scene = test::glass_ball_scene();
    const TreeFile file(true_tree(scene), &scene);
    State state;
    test::run_and_wait(state, "file.open", file.path.string());
    CHECK(count(state, RayMark::same) == state.tree()->tree.rays.size());
    CHECK(state.tree()->contrast->lines.empty());
    CHECK(state.message().find("same in both") != std::string::npos);
}

TEST_CASE("app: a ray that is missing in a recorded tree stands where it should be") {
    const Scene scene = test::glass_ball_scene();
    RayTree<double> theirs = true_tree(scene);
    // The last ray of all was sent by no other.
    const TreeRay<double> gone = theirs.rays.back();
    theirs.rays.pop_back();
    const TreeFile file(theirs, &scene);
    State state;
    state.show(test::opened(scene));
    test::run_and_wait(state, "compare.file", file.path.string());
    const PixelTree& tree = *state.tree();
    REQUIRE(tree.grafted == 1);
    const std::size_t graft = tree.own();
    CHECK(tree.mark(graft) == RayMark::missing);
    CHECK(tree.tree.rays[graft].parent == gone.parent);
    CHECK(tree.tree.rays[graft].kind == gone.kind);
    CHECK(std::ranges::find(tree.children[*gone.parent], graft) !=
          tree.children[*gone.parent].end());
    const auto& lines = tree.contrast->lines;
    CHECK(std::ranges::find(lines, graft, &ContrastLine::ray) != lines.end());
    CHECK(marked_title_of(tree, graft).find("missing") != std::string::npos);
    // Seen from the other side it is a ray like others, and still the one that is missing.
    test::run_and_wait(state, "compare.swap");
    CHECK(state.tree()->grafted == 0);
    CHECK(state.tree()->mark(gone.id) == RayMark::missing);
}

TEST_CASE("app: what a file does not say is not known as zero, while stepping neither") {
    const Scene scene = test::glass_ball_scene();
    auto json = nlohmann::json::parse(write_tree_json(true_tree(scene), nullptr));
    for (auto& ray : json["rays"]) {
        for (const char* const field : {"ambient", "diffuse", "specular", "weight"}) {
            ray.erase(field);
        }
    }
    json["rays"][0].erase("intensity");
    json.erase("intensity");
    const TreeFile file(json.dump());
    State state;
    state.show(test::opened(scene));
    test::run_and_wait(state, "compare.file", file.path.string());
    const PixelTree& tree = *state.tree();
    REQUIRE(tree.recorded);
    std::size_t shadow = 0;
    for (const TreeRay<double>& ray : tree.tree.rays) {
        const OutlineRow row{ray.id, std::nullopt, 0, 0};
        const bool given = !ray.shadow && ray.id != 0;
        CHECK(text_of(tree, ray.id, Column::weight).empty());
        CHECK((text_of(tree, ray.id, Column::intensity) == "not given") == !given);
        CHECK(swatch_of(tree, row).has_value() == given);
        shadow = ray.shadow ? ray.id : shadow;
    }
    REQUIRE(shadow > 0);
    const auto looks = box_looks(diagram_of(tree.tree), tree, std::nullopt);
    CHECK_FALSE(looks.front().given);
    run_command(state, "step.mode");
    while (state.playback()->event().kind != TreeEvent::Kind::evaluated ||
           !tree.tree.rays[state.playback()->event().ray].shadow) {
        run_command(state, "step.forward");
    }
    CHECK(event_text(*state.playback()).find("the file does not say what") != std::string::npos);
    for (const CallText& call : call_texts(*state.playback())) {
        CHECK(call.sum.empty());
    }
}

TEST_CASE("app: a recorded tree that does not say where its rays are is drawn where they are") {
    const Scene scene = test::glass_ball_scene();
    const RayTree<double> truth = true_tree(scene);
    auto json = nlohmann::json::parse(write_tree_json(truth, nullptr));
    for (auto& ray : json["rays"]) {
        for (const char* const field : {"origin", "distance"}) {
            ray.erase(field);
        }
        if (ray.contains("hit") && ray["hit"].is_object()) {
            ray["hit"].erase("point");
            ray["hit"].erase("normal");
        }
    }
    const TreeFile file(json.dump());
    State state;
    state.show(test::opened(scene));
    test::run_and_wait(state, "compare.file", file.path.string());
    const PixelTree& tree = *state.tree();
    REQUIRE(tree.recorded);
    REQUIRE(tree.grafted == 0);
    for (const TreeRay<double>& ray : tree.tree.rays) {
        const TreeRay<double>& due = truth.rays[ray.id];
        CHECK(length(ray.origin - due.origin) < 1e-9);
        if (due.hit) {
            CHECK(length(ray.hit->point - due.hit->point) < 1e-9);
        }
        if (due.shadow) {
            CHECK(ray.shadow->distance.has_value() == due.shadow->distance.has_value());
        }
        CHECK(text_of(tree, ray.id, Column::origin).empty());  // nor is it told as the file's
    }
}

TEST_CASE("app: the first difference that is gone to is the first cause") {
    Scene scene = test::glass_ball_scene();
    State state;
    state.show(test::opened(scene));
    state.pick({40, 30});
    state.poll(std::chrono::seconds(10));
    test::run_and_wait(state, "change.set", "/materials/" + scene.materials[0].name + "/kr 0.4");
    test::run_and_wait(state, "compare.before");
    const auto& lines = state.tree()->contrast->lines;
    REQUIRE(lines.size() > 2);
    CHECK(lines.front().mark == RayMark::different);
    CHECK(summary_of(*state.tree()->contrast).find("(0 where it begins") == std::string::npos);
    REQUIRE(state.selected()->id == 0);  // which is itself in the list: it follows
    REQUIRE(std::ranges::find(lines, std::size_t{0}, &ContrastLine::ray) != lines.begin());
    std::vector<std::size_t> gone;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        run_command(state, "compare.next");
        gone.push_back(state.selected()->id);
    }
    std::vector<std::size_t> listed;
    for (const ContrastLine& line : lines) {
        listed.push_back(line.ray);
    }
    CHECK(gone == listed);
}

TEST_CASE("app: rays of the tree compared with add nothing, and are not counted") {
    const Scene scene = test::glass_ball_scene();
    State state;
    state.show(test::opened(scene));
    state.pick({40, 30});
    state.poll(std::chrono::seconds(10));
    test::run_and_wait(state, "change.set", "/settings/max_depth 1");
    const PixelTree& tree = *state.tree();
    REQUIRE(tree.grafted > 0);
    const auto sections = details_of(tree, 0);
    const auto intensity = std::ranges::find(sections, "Intensity", &DetailSection::title);
    REQUIRE(intensity != sections.end());
    for (const DetailRow& row : intensity->rows) {
        CHECK(row.label.find("kr") == std::string::npos);
        CHECK(row.label.find("kt") == std::string::npos);
    }
    std::size_t kinds = 0;
    for (const CountedGroup& group : groups_of(tree, {})) {
        kinds += group.group.by == RayGroup::By::kind ? group.rays : 0;
    }
    CHECK(kinds == tree.own());
    for (std::size_t k = 0; k < scene.objects.size(); ++k) {
        const auto of_thing = details_of(scene, &tree, {Thing::Kind::object, k});
        for (const DetailRow& row : of_thing.front().rows) {
            for (const std::size_t ray : row.rays) {
                CHECK(tree.is_own(ray));
            }
        }
    }
}

TEST_CASE("app: a recorded tree that does not say all is not exported as if it did") {
    const Scene scene = test::glass_ball_scene();
    auto json = nlohmann::json::parse(write_tree_json(true_tree(scene), nullptr));
    const fs::path target = test::own_path("raytree-export-test.json");
    for (const bool whole : {true, false}) {
        if (!whole) {
            for (auto& ray : json["rays"]) {
                ray.erase("origin");
            }
        }
        const TreeFile file(json.dump());
        State state;
        state.show(test::opened(scene));
        test::run_and_wait(state, "compare.file", file.path.string());
        REQUIRE(state.tree()->recorded);
        fs::remove(target);
        if (whole) {
            run_command(state, "export.tree_json", target.string());
        } else {
            CHECK_THROWS_WITH_AS(run_command(state, "export.tree_json", target.string()),
                                 doctest::Contains("does not say all"), InputError);
        }
        CHECK(fs::exists(target) == whole);
    }
    fs::remove(target);
}

TEST_CASE("app: of a recorded tree no count is given that its file does not hold") {
    Scene scene = test::glass_ball_scene();
    scene.settings.max_depth = 2;
    RayTree<double> theirs = true_tree(scene);
    theirs.rays.pop_back();
    theirs.counts.intersection_tests = 0;
    std::size_t skipped = 0;
    for (const TreeRay<double>& ray : theirs.rays) {
        skipped += ray.skipped.size();
    }
    const TreeFile file(theirs, &scene);
    State state;
    state.show(test::opened(scene));
    test::run_and_wait(state, "compare.file", file.path.string());
    REQUIRE(state.tree()->grafted == 1);
    const TreeStatistics all = statistics_of(*state.document(), *state.tree());
    CHECK(all.to_depth.branches > 0);
    CHECK_FALSE(all.to_depth.weight);  // a file does not hold kr and kt
    CHECK_FALSE(all.tests);
    std::size_t told = 0;  // its own, and not those of the ray that it lacks
    for (const TreeStatistics::NotSent& row : all.not_sent) {
        told += row.count;
    }
    CHECK(told == skipped);
    test::run_and_wait(state, "compare.swap");
    const TreeStatistics ours = statistics_of(*state.document(), *state.tree());
    CHECK(ours.to_depth.weight);
    CHECK(ours.tests.value_or(0) > 0);
}

TEST_CASE("app: a folded branch counts the rays that are missing in it, and says so") {
    const Scene scene = test::glass_ball_scene();
    const RayTree<double> theirs = tree_of_depth(3, scene);
    const TreeFile file(theirs, nullptr);
    State state;
    state.show(test::opened(scene));
    test::run_and_wait(state, "compare.file", file.path.string());
    const PixelTree& tree = *state.tree();
    REQUIRE(tree.grafted > 0);
    const Diagram diagram = diagram_of(tree.tree, 0.99);
    const auto looks = box_looks(diagram, tree, std::nullopt);
    std::size_t rays = 0, hides_some = 0;
    for (std::size_t k = 0; k < diagram.boxes.size(); ++k) {
        const DiagramBox& box = diagram.boxes[k];
        if (box.folded == 0) {
            rays +=
                box.absent ? 0 : 1 + std::ranges::count_if(box.lights, [](const LightRow& light) {
                                     return light.ray.has_value();
                                 });
            CHECK(looks[k].inside == RayMark::none);
        } else {
            rays += box.folded;
            hides_some += looks[k].mark != RayMark::missing && looks[k].inside == RayMark::missing;
        }
    }
    CHECK(rays == tree.tree.rays.size());
    CHECK(hides_some > 0);
}

TEST_CASE("app: a ray too many is extra") {
    const Scene scene = test::glass_ball_scene();
    const RayTree<double> theirs = tree_of_depth(5, scene);
    const std::size_t more = theirs.rays.size() - true_tree(scene).rays.size();
    REQUIRE(more > 0);
    const TreeFile file(theirs, nullptr);
    State state;
    state.show(test::opened(scene));
    test::run_and_wait(state, "compare.file", file.path.string());
    CHECK(state.tree()->grafted == 0);
    CHECK(count(state, RayMark::extra) == more);
}

TEST_CASE(
    "app: a ray that the true tree has is not called extra, one that it has not is no other") {
    PixelTree shown;
    shown.tree = true_tree(test::glass_ball_scene());
    shown.children = children_of(shown.tree);
    const std::size_t ray = first_of(shown.tree, RayKind::refracted);
    Contrast contrast;
    contrast.what = Contrast::What::file;
    contrast.other = shown.tree;
    for (const TreeRay<double>& one : shown.tree.rays) {
        contrast.counterparts.emplace_back(one.id);
    }
    check::Report report;
    report.ids.resize(shown.tree.rays.size(), "a");
    check::Finding differs, extra;
    differs.ray = extra.ray = ray;
    differs.kind = extra.kind = RayKind::refracted;
    extra.problem = check::Problem::extra;
    extra.reason = "total internal reflection";  // by the numbers of the file
    for (const auto& findings : {std::vector{differs, extra}, std::vector{extra, differs}}) {
        report.findings = findings;
        Contrast both = contrast;
        mark_by_findings(shown, both, report, true);
        CHECK(both.marks[ray] == RayMark::different);
        Contrast alone = contrast;
        alone.counterparts[ray].reset();
        mark_by_findings(shown, alone, report, true);
        CHECK(alone.marks[ray] == RayMark::extra);
        REQUIRE(alone.lines.size() == 2);
        for (const ContrastLine& line : alone.lines) {  // the sign is that of the views
            CHECK(line.mark == RayMark::extra);
            // And so is the number, with the file's own beside it.
            CHECK(line.text.starts_with("ray #" + std::to_string(ray) + " (the file's a)"));
        }
    }
}

TEST_CASE("app: rays from a hit that the file names wrongly are not told to start from nothing") {
    const Scene scene = test::glass_ball_scene();
    RayTree<double> theirs = true_tree(scene);
    REQUIRE(theirs.rays[0].hit);
    theirs.rays[0].hit->object = "no such object";
    const TreeFile file(theirs, &scene);
    State state;
    test::run_and_wait(state, "file.open", file.path.string());
    int told = 0;
    for (const ContrastLine& line : state.tree()->contrast->lines) {
        CHECK(line.text.find("hits nothing") == std::string::npos);
        told += line.text.find("is not known") != std::string::npos ? 1 : 0;
    }
    CHECK(told > 0);
}

TEST_CASE("app: a file without shadow rays is not told to lack them, on either side") {
    const Scene scene = test::glass_ball_scene();
    std::string text = write_tree_json(true_tree(scene), &scene);
    nlohmann::json tree = nlohmann::json::parse(text);
    auto& rays = tree["rays"];
    for (std::size_t k = rays.size(); k-- > 0;) {
        if (rays[k]["kind"] == "shadow") {
            rays.erase(k);
        }
    }
    tree.erase("counts");
    const TreeFile file(tree.dump());
    State state;
    test::run_and_wait(state, "file.open", file.path.string());
    for (int side = 0; side < 2; ++side) {
        REQUIRE(state.tree()->contrast);
        CHECK(count(state, RayMark::missing) + count(state, RayMark::extra) == 0);
        const auto& remarks = state.tree()->contrast->remarks;
        CHECK(std::ranges::any_of(remarks, [](const std::string& remark) {
            return remark.find("no shadow rays") != std::string::npos;
        }));
        test::run_and_wait(state, "compare.swap");
    }
}

TEST_CASE("app: a tree of bare numbers is shown with what it gives and no more") {
    const Scene scene = test::glass_ball_scene();
    const TreeFile file(std::string(R"({"format": "raytree/1.0", "pixel": [40, 30],
        "rays": [{"id": 0, "kind": "primary", "intensity": [0.5, 0.5, 0.5]}]})"));
    State state;
    state.show(test::opened(scene));
    test::run_and_wait(state, "compare.file", file.path.string());
    REQUIRE(state.tree()->recorded);
    const OutlineTexts texts =
        marked_texts_of(*state.tree(), {0, std::nullopt, 0, 0}, std::nullopt);
    CHECK(texts.met == "not given");
    CHECK(texts.intensity.starts_with("0.500"));
    const DetailSection section = recorded_details(*state.tree(), 0);
    CHECK(section.sentences.front().find("Not in the file") != std::string::npos);
    const auto intensity = std::ranges::find(section.rows, "intensity", &DetailRow::label);
    REQUIRE(intensity != section.rows.end());
    CHECK(intensity->values == std::vector{0.5, 0.5, 0.5});  // in columns, to be copied
    // Nothing is made up in the table, either, nor copied.
    CHECK(text_of(*state.tree(), 0, Column::weight).empty());
    CHECK(text_of(*state.tree(), 0, Column::direction).empty());
    CHECK(exact_text_of(*state.tree(), 0, Column::attenuation).empty());
    CHECK(text_of(*state.tree(), 0, Column::intensity).starts_with("0.500"));
    CHECK_FALSE(statistics_of(*state.document(), *state.tree()).tells_skipped);
    // The largest tree is that of the scene where the file does not say.
    const double levels = scene.settings.max_depth, lights = double(scene.lights.size());
    CHECK(state.tree()->tree.counts.full_tree == (lights + 1) * (std::pow(2, levels) - 1));
}

TEST_CASE("app: of a shadow ray that a file calls dark, no more is said than the file says") {
    const Scene scene = test::glass_ball_scene();
    const TreeFile file(std::string(R"({"format": "raytree/1.0", "pixel": [40, 30], "rays": [
        {"id": 0, "kind": "primary", "intensity": [0.5, 0.5, 0.5]},
        {"id": 1, "kind": "shadow", "parent": 0, "light": "key", "transmittance": [0, 0, 0]}]})"));
    State state;
    state.show(test::opened(scene));
    test::run_and_wait(state, "compare.file", file.path.string());
    REQUIRE(state.tree()->recorded);
    const OutlineTexts texts = texts_of(*state.tree(), {1, std::nullopt, 0, 0});
    CHECK(texts.met == "not given");
    CHECK(texts.ended == "blocked");
}

TEST_CASE("app: a tree that lies outside of the picture is refused, and nothing changes") {
    const Scene scene = test::glass_ball_scene();
    RayTree<double> theirs = true_tree(scene);
    theirs.pixel_i = 500;
    const TreeFile file(theirs, nullptr);
    State state;
    state.show(test::opened(scene));
    const auto before = state.tree();
    CHECK_THROWS_AS(run_command(state, "compare.file", file.path.string()), InputError);
    CHECK(state.tree() == before);
    CHECK_FALSE(state.comparing());
}

TEST_CASE("app: numbers that look alike stand below each other, as far as they differ") {
    State state;
    state.show(test::opened(test::glass_ball_scene()));
    state.pick({40, 30});
    test::run_and_wait(state, "change.set", "/lights/0/intensity 1.00000003, 1, 1");
    test::run_and_wait(state, "compare.before");
    REQUIRE(state.tree()->contrast);
    const auto rows = contrast_details(*state.tree(), 0).front().rows;
    const auto at = std::ranges::find(rows, "≠ intensity", &DetailRow::label);
    REQUIRE(rows.end() - at >= 3);
    CHECK((at + 1)->label == "   here, red");  // the other channels are the same
    CHECK((at + 2)->label == "   there, red");
    REQUIRE((at + 1)->cells.size() == 1);
    CHECK((at + 1)->is_text);
    CHECK((at + 1)->cells != (at + 2)->cells);
    CHECK((at + 1)->cells.front().size() < 14);
    CHECK((at + 1)->values.front() > (at + 2)->values.front());
    CHECK((rows.end() - at == 3 || (at + 3)->label.starts_with("≠")));
}

TEST_CASE("app: two pixels: another object that is met is a difference, other numbers are none") {
    State state;
    state.show(test::opened(test::glass_ball_scene()));
    state.pick({40, 30});
    test::run_and_wait(state, "compare.this_pixel");
    CHECK(count(state, RayMark::different) == 0);
    test::run_and_wait(state, "pixel.right");  // still on the ball
    REQUIRE(state.tree()->contrast);
    CHECK(state.tree()->mark(0) == RayMark::same);
    CHECK_FALSE(contrast_details(*state.tree(), 0).front().rows.empty());  // numbers are told
    state.pick({2, 2});                                                    // beside it
    CHECK(state.tree()->tree.rays[0].hit.has_value() == false);
    CHECK(state.tree()->mark(0) == RayMark::different);
    CHECK(state.tree()->grafted > 0);
    CHECK(state.tree()->contrast->lines.front().ray == 0);
    test::run_and_wait(state, "compare.end");
    CHECK_FALSE(state.tree()->contrast);
    CHECK(state.tree()->grafted == 0);
}

TEST_CASE("app: before and after a change: it begins where the change acts") {
    State state;
    state.show(test::opened(test::glass_ball_scene()));
    state.pick({40, 30});
    CHECK_FALSE(find_command("compare.before")->possible(state));
    test::run_and_wait(state, "change.set", "/materials/glass/kd 0.3");
    test::run_and_wait(state, "compare.before");
    const PixelTree& tree = *state.tree();
    CHECK(tree.contrast->what == Contrast::What::change);
    bool follows = false;
    for (const ContrastLine& line : tree.contrast->lines) {
        CHECK_FALSE((follows && line.mark != RayMark::follows));  // causes come first
        follows |= line.mark == RayMark::follows;
        if (line.mark == RayMark::different) {
            const TreeRay<double>& ray = tree.tree.rays[line.ray];
            CHECK((ray.shadow || ray.hit->material == "glass"));
        }
    }
    CHECK(count(state, RayMark::different) > 0);
}

TEST_CASE("app: a ray that a change has cut off has one number everywhere: the one it had before") {
    State state;
    state.show(test::opened(test::glass_ball_scene()));
    test::run_and_wait(state, "pixel.pick", "40,30");
    const RayTree<double> before = state.tree()->tree;
    test::run_and_wait(state, "change.set", "/settings/max_depth 1");
    test::run_and_wait(state, "compare.before");
    std::size_t missing = 0;
    for (const ContrastLine& line : state.tree()->contrast->lines) {
        if (state.tree()->is_own(line.ray)) {
            continue;
        }
        ++missing;
        CHECK(line.text.starts_with(number_of(*state.tree(), line.ray) + " "));
        const std::size_t number = std::stoul(line.text.substr(2));  // "(#5) reflected ray ..."
        CHECK(before.rays[number].kind == state.tree()->tree.rays[line.ray].kind);
        CHECK(before.rays[number].origin == state.tree()->tree.rays[line.ray].origin);
    }
    CHECK(missing == before.rays.size() - state.tree()->own());
    CHECK(missing > 3);
}

TEST_CASE("app: a chosen pixel apart from a recorded tree's is traced; back there it is again") {
    const Scene scene = test::glass_ball_scene();
    const TreeFile file(true_tree(scene), &scene);
    State state;
    test::run_and_wait(state, "file.open", file.path.string());
    state.pick({5, 5});
    CHECK_FALSE(state.tree()->recorded);
    CHECK_FALSE(state.tree()->contrast);
    test::run_and_wait(state, "pixel.back");
    CHECK(state.tree()->recorded);
}

TEST_CASE("app: an exported tree holds the shown one's own rays alone") {
    State state;
    state.show(test::opened(test::glass_ball_scene()));
    state.pick({40, 30});
    test::run_and_wait(state, "change.set", "/settings/max_depth 2");
    const fs::path file = test::own_path("raytree-export-cut-test.json");
    test::run_and_wait(state, "export.tree_json", file.string());
    CHECK(read_recorded(file)->tree.rays.size() == state.tree()->own());
    fs::remove(file);
}

TEST_CASE("app: recent files: the last first, each once, ten at most") {
    RecentFiles recent;
    for (int k = 0; k < 14; ++k) {
        recent.add("file" + std::to_string(k));
    }
    recent.add("file9");
    REQUIRE(recent.files().size() == RecentFiles::most);
    CHECK(recent.files()[0] == "file9");
    CHECK(recent.files()[1] == "file13");
    CHECK(std::ranges::count(recent.files(), "file9") == 1);
    CHECK(RecentFiles(recent.files()).files() == recent.files());
    CHECK_FALSE(is_there("/no/such/file"));
}

}  // namespace
}  // namespace raytree::inspector
