#include "readers.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "check/assignment.h"
#include "check/report.h"
#include "check/rubric.h"
#include "check/submission.h"
#include "folders.h"
#include "formats/course_text.h"
#include "formats/nff.h"
#include "formats/obj.h"
#include "formats/output_file.h"
#include "formats/picture_read.h"
#include "formats/scene_json.h"
#include "formats/tree_json.h"
#include "lesson/expression.h"
#include "scene/input_error.h"
#include "scene/validate.h"
#include "trace/render.h"
#include "tree/record.h"

namespace raytree::fuzz {
namespace {

void must(bool holds, const char* what) {
    if (!holds) {
        throw std::logic_error(what);
    }
}

/// What is accepted is the same scene after it has been written and read.
void see(const Scene& scene) {
    const std::string written = write_scene_json(scene);
    std::vector<std::string> warnings;
    const Scene again = read_scene_json(
        written, std::filesystem::path(RAYTREE_DATA_DIR "/scenes/again.json"), warnings);
    must(write_scene_json(again) == written, "a scene is another one after writing and reading");
}

const std::filesystem::path beside_meshes = RAYTREE_DATA_DIR "/scenes/fuzzed.file";

void scene(const std::string& text) {
    std::vector<std::string> warnings;
    see(read_scene_json(text, beside_meshes, warnings));
}
/// These readers leave what makes no sense to whoever loads a file of any format.
void see_foreign(const Scene& scene) {
    std::vector<Mistake> mistakes = validate(scene);
    if (!mistakes.empty()) {
        throw InputError(name_of_file, mistakes[0].place, mistakes[0].text);
    }
    see(scene);
}
void nff(const std::string& text) {
    std::vector<std::string> warnings;
    see_foreign(read_nff(text, name_of_file, std::nullopt, warnings));
}
void course(const std::string& text) { see_foreign(read_course_text(text, name_of_file).scene); }
void obj(const std::string& text) {
    std::vector<std::string> warnings;
    const Mesh mesh = read_obj(text, name_of_file, warnings);
    must(validate(scene_around(mesh, "mesh")).empty(), "an accepted mesh does not make sense");
}
void tree(const std::string& text) {
    const ReadTree read = read_tree_json(text, name_of_file);
    // JSON has no word for what is no number.
    must(nlohmann::json::accept(write_tree_json(read.tree)),
         "an accepted tree is not written as JSON");
}
void submission(const std::string& text) { check::parse_submission(text, name_of_file); }
void report(const std::string& text) { check::read_report(text, name_of_file); }
void rubric(const std::string& text) { check::read_rubric(text, name_of_file); }
void assignment(const std::string& text) { check::read_assignment(text, name_of_file); }
void picture(const std::string& text) { read_picture(text, name_of_file, {4, 3}); }
void expression(const std::string& text) {
    try {
        lesson::Expression read(text);
    } catch (const lesson::ExpressionError& error) {
        throw InputError(name_of_file, "", error.what());
    }
}

/// The texts of the files of a folder with this ending, the smaller ones, in the order of names.
std::vector<std::string> texts_in(const std::filesystem::path& folder, std::string_view ending) {
    std::vector<std::filesystem::path> files;
    if (std::filesystem::is_directory(folder)) {
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            if (entry.path().string().ends_with(ending) && entry.file_size() < 30'000) {
                files.push_back(entry.path());
            }
        }
    }
    std::ranges::sort(files);
    std::vector<std::string> texts;
    for (const auto& file : files) {
        texts.push_back(read_input(file.string()));
    }
    return texts;
}

std::vector<std::string> scenes() { return texts_in(RAYTREE_DATA_DIR "/scenes", ".json"); }

Scene small(const std::string& text) {
    std::vector<std::string> warnings;
    Scene scene = read_scene_json(text, beside_meshes, warnings);
    scene.camera.width = 7;
    scene.camera.height = 5;
    scene.settings.max_depth = std::min(scene.settings.max_depth, 3);
    return scene;
}

/// Trees of the example scenes, as their writer writes them.
std::vector<std::string> trees() {
    std::vector<std::string> texts;
    for (const std::string& text : scenes()) {
        const Scene scene = small(text);
        const World<double> world(scene);
        texts.push_back(write_tree_json(record_tree(world, 3, 2)));
    }
    return texts;
}

std::vector<std::string> in_other_formats(std::string (*write)(const Scene&)) {
    std::vector<std::string> texts;
    for (const std::string& text : scenes()) {
        texts.push_back(write(small(text)));
    }
    return texts;
}

std::vector<std::string> in_nff() {
    return in_other_formats([](const Scene& scene) {
        std::vector<std::string> lost;
        return write_nff(scene, lost);
    });
}
std::vector<std::string> in_course_text() {
    return in_other_formats([](const Scene& scene) {
        std::vector<std::string> lost;
        return write_course_text(scene, "picture.png", lost);
    });
}

std::vector<std::string> pictures() {
    std::string floats = "PF\n4 3\n-1.0\n" + std::string(4 * 3 * 12, '\x3f');
    std::string bytes = "P6\n# a comment\n4 3\n255\n" + std::string(4 * 3 * 3, 'x');
    std::string numbers = "P3\n4 3\n255\n";
    for (int k = 0; k < 4 * 3 * 3; ++k) {
        numbers += std::to_string(k * 7) + "\n";
    }
    return {floats, bytes, numbers};
}

}  // namespace

std::vector<Reader> all_readers() {
    return {
        {"scene", scenes(), scene},
        {"nff", in_nff(), nff},
        {"course", in_course_text(), course},
        {"obj", texts_in(RAYTREE_DATA_DIR "/meshes", ".obj"), obj},
        {"tree", trees(), tree},
        {"submission", trees(), submission},
        {"assignment", texts_in(RAYTREE_DATA_DIR "/assignments", ".json"), assignment},
        {"rubric",
         {R"({"format": "raytree-rubric/1.0", "quantities": {"intensity": 2, "t": 1},
             "levels": {"1": 3}, "kinds": {"shadow": 0.5}})"},
         rubric},
        {"report",
         {R"({"format": "raytree-report/1.0", "submissions": [{"file": "a.json",
             "verdict": "fail", "profile": "lecture", "score": 0.8, "findings": [{"ray": 7,
             "kind": "refracted", "quantity": "direction", "expected": [0, 0, -1],
             "found": [0.1, 0, -0.99], "relative_error": 0.1, "follows_from": null,
             "text": "x"}], "mistakes": [{"id": "refr.eta_inverted", "sure": true,
             "rays_explained": 4, "ties": [], "text": "x"}]}], "groups": []})"},
         report},
        {"picture", pictures(), picture},
        {"expression",
         {"-dot(primary.refracted.direction, primary.hit.normal) == sqrt(1 - x^2) within 1e-9",
          "with('/settings/max_depth', 3).at(3, 4).rays[2].hit['t'] * [1, 2, 3] != null or not a"},
         expression},
    };
}

}  // namespace raytree::fuzz
