#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "app/scenes.h"
#include "lesson/lesson_folder.h"
#include "state/commands.h"
#include "state/explained_text.h"
#include "state/formula_details.h"

namespace raytree::inspector {
namespace {

namespace fs = std::filesystem;

constexpr const char* scene_text = R"({
  "format": "raytree-scene/1.0",
  "camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0], "horizontal_fov_degrees": 60,
             "width": 9, "height": 9},
  "settings": {"max_depth": 3},
  "materials": {"red": {"color": [1, 0, 0], "ka": 0.1, "kd": 0.9, "kr": 0.2}},
  "lights": [{"name": "lamp", "type": "point", "position": [0, 4, 4], "intensity": 1}],
  "objects": [
    {"name": "ball", "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": "red"},
    {"name": "wall", "type": "polygon", "material": "red",
     "vertices": [[-5, -5, -2], [5, -5, -2], [5, 5, -2], [-5, 5, -2]]}]
})";

constexpr const char* lesson_text = R"({
  "format": "raytree-lesson/1.0", "title": "A ball", "topic": "Balls", "minutes": 1,
  "before": ["what a ray is"],
  "steps": [
    {"title": "How far", "text": ["It is {primary.hit.t; 2} away."],
     "show": {"scene": "ball.json", "pixel": [4, 4], "panel": "diagram", "formula": "sphere"},
     "ask": {"kind": "number", "question": "How far?", "truth": "primary.hit.t",
             "tolerance": 0.01, "after": "Well.",
             "hints": [{"when": "answer == 5", "text": "That is the middle."}]}},
    {"title": "Beside it", "text": ["A pixel."],
     "show": {"pixel": [4, 4], "shapes": "wire", "hide": ["shadow"], "view": "side"},
     "ask": {"kind": "pixel", "question": "Which one misses the ball?", "example": [0, 4],
             "truth": "picked.primary.hit.object == 'wall'"}},
    {"title": "The shadow", "text": ["A ray."],
     "show": {"pixel": [4, 4], "ray": "primary.shadow.lamp.id"},
     "ask": {"kind": "ray", "question": "Which one is the primary ray?",
             "truth": "picked.kind == 'primary'"}},
    {"title": "The size", "text": ["A value."],
     "show": {"pixel": [4, 4], "view": {"eye": [9, 1, 1], "target": [0, 0, 0]}},
     "ask": {"kind": "value", "question": "Make it larger.", "set": "/objects/0/radius",
             "from": 0.5, "to": 3, "example": 2, "truth": "primary.hit.t < 3.5"}},
    {"title": "A choice", "text": ["A letter."],
     "show": {"pixel": [4, 4], "change": {"objects": {"wall": null}}, "z_buffer": true},
     "ask": {"kind": "choice", "question": "How many are left?",
             "truth": "scene.objects.count", "options": [
               {"text": "two", "value": 2, "hint": "The wall is gone."},
               {"text": "one", "value": 1}]}}
  ]
})";

/// A folder of two lessons, gone when the test is over.
struct Lessons {
    fs::path folder = fs::temp_directory_path() / "raytree-app-test-lessons";
    Lessons() {
        for (const char* name : {"01-ball", "02-again"}) {
            fs::create_directories(folder / name);
            std::ofstream(folder / name / "ball.json") << scene_text;
            std::ofstream(folder / name / "lesson.json") << lesson_text;
        }
    }
    ~Lessons() { fs::remove_all(folder); }
};

/// At a step of the first lesson, from 1.
struct AtStep {
    Lessons lessons;
    State state;
    explicit AtStep(const char* step) {
        state.set_lesson_folder(lessons.folder);
        run_command(state, "lesson.open", "ball");
        run_command(state, "lesson.step", step);
    }
};

TEST_CASE("app lessons: a step shows its scene, pixel, ray, look and pane") {
    AtStep at("1");
    CHECK(at.state.lesson_side() == LessonSide::lesson);
    CHECK(at.state.pixel() == Pixel{4, 4});
    CHECK(at.state.tree_pane().tab == TreePane::Tab::diagram);
    CHECK(plain_text(at.state.lesson()->page().text) == "It is 4.00 away.");
    run_command(at.state, "lesson.step", "2");
    CHECK(at.state.look().shapes == ShapeStyle::wire);
    run_command(at.state, "lesson.step", "3");
    CHECK(at.state.selected()->kind == RayKind::shadow);
    CHECK(at.state.look().shapes == ShapeStyle::see_through);
}

TEST_CASE("app lessons: next and back go on to the neighbouring lessons") {
    AtStep at("5");
    run_command(at.state, "lesson.next");
    CHECK(at.state.lesson()->lesson().name == "02-again");
    CHECK(at.state.lesson()->step() == 0);
    run_command(at.state, "lesson.back");
    CHECK(at.state.lesson()->lesson().name == "01-ball");
    CHECK(at.state.lesson()->step() == 4);
    run_command(at.state, "lesson.first");
    CHECK(at.state.lesson()->step() == 0);
    run_command(at.state, "lesson.last");
    CHECK(at.state.lesson()->step() == 4);
    CHECK_THROWS_AS(run_command(at.state, "lesson.step", "6"), InputError);
    CHECK_THROWS_AS(run_command(at.state, "lesson.step", "0"), InputError);
    CHECK_THROWS_AS(run_command(at.state, "lesson.open", "cube"), InputError);
    CHECK(at.state.lesson()->step() == 4);
}

TEST_CASE("app lessons: an answer gets right or wrong, the truth, the hint and what comes after") {
    AtStep at("1");
    run_command(at.state, "lesson.answer", "5");
    const LessonAnswer* answer = at.state.lesson()->answer();
    REQUIRE(answer);
    CHECK_FALSE(answer->right);
    CHECK(answer->truth == "4");
    CHECK(plain_text(answer->hint) == "That is the middle.");
    CHECK(plain_text(answer->after) == "Well.");
    run_command(at.state, "lesson.answer", "4.005");
    CHECK(at.state.lesson()->answer()->right);
    CHECK(at.state.lesson()->is_solved(0));
    CHECK_THROWS_AS(run_command(at.state, "lesson.answer", "far"), InputError);
    run_command(at.state, "lesson.again");
    CHECK(at.state.lesson()->answer() == nullptr);
    run_command(at.state, "lesson.tell");
    CHECK(at.state.lesson()->answer()->given.is_null());
    CHECK(at.state.lesson()->answer()->truth == "4");
}

TEST_CASE("app lessons: a pixel that is picked answers, and the lesson's view can be had again") {
    AtStep at("2");
    CHECK(at.state.lesson()->answer() == nullptr);
    at.state.pick({0, 4});
    REQUIRE(at.state.lesson()->answer());
    CHECK(at.state.lesson()->answer()->right);
    at.state.pick({4, 3});
    CHECK_FALSE(at.state.lesson()->answer()->right);
    run_command(at.state, "lesson.view");
    CHECK(at.state.pixel() == Pixel{4, 4});
    CHECK_FALSE(at.state.lesson()->answer()->right);
}

TEST_CASE("app lessons: a ray that is selected answers, but only in the question's pixel") {
    AtStep at("3");
    at.state.select(0);
    REQUIRE(at.state.lesson()->answer());
    CHECK(at.state.lesson()->answer()->right);
    run_command(at.state, "lesson.again");
    at.state.pick({0, 0});
    at.state.select(1);
    CHECK(at.state.lesson()->answer() == nullptr);
}

TEST_CASE("app lessons: a value that is tried shows in the scene, and is judged when answered") {
    AtStep at("4");
    const auto before = at.state.document();
    CHECK(at.state.lesson()->value_shown() == 1);
    at.state.try_value(2);
    CHECK(at.state.selected()->hit->t == doctest::Approx(3));
    CHECK(at.state.lesson()->answer() == nullptr);
    run_command(at.state, "lesson.answer", "1.2");
    CHECK_FALSE(at.state.lesson()->answer()->right);
    run_command(at.state, "lesson.answer", "2");
    CHECK(at.state.lesson()->answer()->right);
    run_command(at.state, "lesson.view");
    CHECK(at.state.document() == before);
}

TEST_CASE("app lessons: choices are letters; a step's change is in its scene") {
    AtStep at("5");
    CHECK(at.state.document()->scene().objects.size() == 1);
    CHECK(at.state.tree_pane().tab == TreePane::Tab::explained);
    CHECK(explained_text(at.state).size() == 1);
    run_command(at.state, "lesson.answer", "a");
    CHECK(plain_text(at.state.lesson()->answer()->hint) == "The wall is gone.");
    run_command(at.state, "lesson.answer", "b");
    CHECK(at.state.lesson()->answer()->right);
    CHECK_THROWS_AS(run_command(at.state, "lesson.answer", "c"), InputError);
    run_command(at.state, "lesson.close");
    CHECK(at.state.lesson() == nullptr);
    CHECK(at.state.explained().nothing());
}

TEST_CASE("app lessons: the list has each lesson, and says which cannot be read") {
    Lessons lessons;
    std::ofstream(lessons.folder / "02-again" / "lesson.json") << "{";
    const auto entries = lessons_in(lessons.folder);
    REQUIRE(entries.size() == 2);
    CHECK(entries[0].title == "A ball");
    CHECK(entries[0].steps == 5);
    CHECK(entries[0].failure.empty());
    CHECK_FALSE(entries[1].failure.empty());
}

TEST_CASE("app lessons: the step's formula marks one section of the details") {
    AtStep at("1");
    REQUIRE(marked_formula(at.state) == lesson::Formula::sphere);
    CHECK(is_about({"How the hit was found: sphere", {}, {}}, lesson::Formula::sphere));
    CHECK_FALSE(is_about({"Intensity", {}, {}}, lesson::Formula::sphere));
    run_command(at.state, "explain.eye_space");
    const auto sections = formula_details(at.state);
    REQUIRE(sections.size() == 1);
    CHECK(sections[0].title == "In eye space");
}

TEST_CASE("app: features explain any scene, step by step, and end") {
    AtStep at("1");
    State& state = at.state;
    test::run_and_wait(state, "explain.boxes");
    REQUIRE(state.explanation().traversal);
    const auto& tests = state.explanation().traversal->tests;
    REQUIRE(tests.size() == 5);
    CHECK(tests[0].shapes == 2);  // without a hierarchy the ray asks both
    const std::size_t all = state.explanation().traversal->steps.size();
    CHECK(steps_shown(*state.explained().traversal, all) == all);
    test::run_and_wait(state, "explain.step_forward");
    CHECK(steps_shown(*state.explained().traversal, all) == 1);
    test::run_and_wait(state, "explain.step_back");
    CHECK(steps_shown(*state.explained().traversal, all) == 0);
    test::run_and_wait(state, "explain.shower", "lamp");
    CHECK(state.explanation().shower->rays == 1000);
    test::run_and_wait(state, "explain.finer");
    CHECK(state.explanation().shower->rays == 10000);
    test::run_and_wait(state, "explain.depth");
    REQUIRE(state.explanation().comparison);
    CHECK(state.explanation().comparison->distance == doctest::Approx(5));  // (0,4,4) to (0,0,1)
    test::run_and_wait(state, "explain.volumes");
    CHECK(state.explanation().volumes->left_out.size() == 1);  // the ball
    CHECK_THROWS_AS(run_command(state, "explain.shower", "sun"), InputError);
    test::run_and_wait(state, "explain.nothing");
    CHECK(explained_text(state).empty());
}

}  // namespace
}  // namespace raytree::inspector
