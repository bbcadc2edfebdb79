#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "check/check.h"
#include "check/support.h"
#include "folders.h"
#include "formats/scene_file.h"
#include "formats/tree_json.h"
#include "scene/input_error.h"
#include "tree/record.h"

namespace raytree::test {
namespace {

int pixels_of_a_scene() {
    const char* const wanted = std::getenv("RAYTREE_TEST_PIXELS");
    return wanted ? std::atoi(wanted) : 4;
}

/// The scenes below a folder, by name; none where there is no such folder.
std::vector<std::filesystem::path> scenes_below(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (std::filesystem::recursive_directory_iterator file(folder, error), end; file != end;
         ++file) {
        const std::string name = file->path().filename().string();
        const std::string extension = file->path().extension().string();
        const bool tree = name == "lesson.json" || name.find(".tree.") != std::string::npos;
        if ((extension == ".json" && !tree) || extension == ".txt" || extension == ".nff") {
            files.push_back(file->path());
        }
    }
    std::ranges::sort(files);
    return files;
}

template <class T> std::string written(const Scene& scene, int i, int j) {
    const World<T> world(scene);
    return write_tree_json(record_tree(world, i, j));
}

void expect_pass(const check::Checker& checker, const std::string& text, const char* how,
                 bool is_far) {
    for (const int digits : {0, 6, 5, 4}) {
        if (is_far && digits == 4) {
            continue;  // too few to say which side of a ball is hit that is so far away
        }
        const check::Report report =
            checker.check_text(digits == 0 ? text : with_digits(text, digits), "submission.json");
        CAPTURE(how);
        CAPTURE(digits);
        CAPTURE(in_words(report));
        CHECK(report.verdict == check::Verdict::pass);
        CHECK(report.profile == "lecture");
    }
}

/// Trees handed in, at pixels spread over the scene's picture.
int hand_in_trees_of(const std::filesystem::path& file) {
    CAPTURE(file.string());
    const Scene scene = load_scene(file).scene;
    check::CheckOptions options;
    options.profile = "lecture";
    options.name_mistakes = false;
    const check::Checker checker(scene, options);
    const bool is_large = scene.objects.size() > 1000;
    const int pixels = is_large ? (pixels_of_a_scene() + 49) / 50 : pixels_of_a_scene();
    const bool is_far = file.stem() == "far";
    int trees = 0;
    for (int n = 0; n < pixels; ++n) {
        const int i = (n * 7919 + 101) % scene.camera.width;
        const int j = (n * 104729 + 211) % scene.camera.height;
        CAPTURE(i);
        CAPTURE(j);
        expect_pass(checker, written<double>(scene, i, j), "double", is_far);
        trees += 4;
        std::string single;
        try {
            single = written<float>(scene, i, j);
        } catch (const InputError&) {
            continue;  // beyond float's range
        }
        expect_pass(checker, single, "float", is_far);
        trees += 4;
    }
    return trees;
}

TEST_CASE("a correct tree passes: in double, in float, each rounded to six, five and four digits") {
    int trees = 0;
    std::size_t scenes = 0;
    for (const char* const folder :
         {RAYTREE_DATA_DIR "/scenes", RAYTREE_LESSONS_DIR, RAYTREE_SHARED_DATA_DIR}) {
        for (const auto& file : scenes_below(folder)) {
            trees += hand_in_trees_of(file);
            ++scenes;
        }
    }
    MESSAGE(trees << " trees of " << scenes << " scenes");
    CHECK(scenes > 40);
}

}  // namespace
}  // namespace raytree::test
