#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>

#include "check/check.h"
#include "check/support.h"
#include "folders.h"
#include "formats/scene_file.h"
#include "formats/tree_json.h"
#include "scene/input_error.h"
#include "tree/record.h"

namespace raytree::test {
namespace {

constexpr const char* slow = "sphereflake";

int pixels_of_a_scene() {
    const char* const wanted = std::getenv("RAYTREE_TEST_PIXELS");
    return wanted ? std::atoi(wanted) : 12;
}

template <class T> std::string written(const Scene& scene, int i, int j) {
    const World<T> world(scene);
    return write_tree_json(record_tree(world, i, j));
}

void expect_pass(const check::Checker& checker, const std::string& text, const char* how) {
    const check::Report report = checker.check_text(text, "submission.json");
    CAPTURE(how);
    CAPTURE(in_words(report));
    CHECK(report.verdict == check::Verdict::pass);
    CHECK(report.profile == "lecture");
}

TEST_CASE("a correct tree passes: in double, in float, rounded to six digits") {
    for (const auto& entry : std::filesystem::directory_iterator(RAYTREE_DATA_DIR "/scenes")) {
        if (entry.path().extension() != ".json" || entry.path().stem() == slow) {
            continue;
        }
        const Scene scene = load_scene(entry.path()).scene;
        check::CheckOptions options;
        options.profile = "lecture";
        options.name_mistakes = false;
        const check::Checker checker(scene, options);
        CAPTURE(entry.path().filename().string());
        for (int n = 0; n < pixels_of_a_scene(); ++n) {
            const int i = (n * 7919 + 101) % scene.camera.width;
            const int j = (n * 104729 + 211) % scene.camera.height;
            CAPTURE(i);
            CAPTURE(j);
            const std::string exact = written<double>(scene, i, j);
            expect_pass(checker, exact, "double");
            expect_pass(checker, with_digits(exact, 6), "six digits");
            std::string single;
            try {
                single = written<float>(scene, i, j);
            } catch (const InputError&) {
                continue;  // beyond float's range
            }
            expect_pass(checker, single, "float");
            expect_pass(checker, with_digits(single, 6), "float, six digits");
        }
    }
}

}  // namespace
}  // namespace raytree::test
