#include <doctest/doctest.h>

#include <fstream>

#include "app/sample_lessons.h"
#include "app/scenes.h"
#include "lesson/lesson_folder.h"
#include "state/commands.h"
#include "state/explained_text.h"
#include "state/formula_details.h"

namespace raytree::inspector {
namespace {

/// At a step of the first lesson, from 1.
struct AtStep {
    test::Lessons lessons;
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

TEST_CASE("app lessons: views are told of a step once, of all that it has changed") {
    AtStep at("1");
    std::vector<Changes> told;
    at.state.observe([&](const Changes& changes) { told.push_back(changes); });
    run_command(at.state, "lesson.step", "2");
    REQUIRE(told.size() == 1);
    CHECK(told.front().look);
    CHECK(told.front().lesson);
    CHECK(told.front().message);
    CHECK((told.front().request || told.front().view_from));
    run_command(at.state, "shapes.solid");  // and of the next thing at once
    CHECK(told.size() == 2);
}

TEST_CASE("app lessons: a changed scene is not saved over that of the lesson") {
    AtStep at("1");
    std::vector<Changes> told;
    at.state.observe([&](const Changes& changes) { told.push_back(changes); });
    const auto size = std::filesystem::file_size(at.state.document()->file());
    test::run_and_wait(at.state, "change.set", "/lights/0/intensity 0.123456");
    run_command(at.state, "file.save");
    CHECK(told.back().request == Request::save_scene_as);
    CHECK(std::filesystem::file_size(at.state.document()->file()) == size);
    CHECK(at.state.edits().unsaved());
}

TEST_CASE("app lessons: next and back go on to the neighbouring lessons") {
    AtStep at("7");
    run_command(at.state, "lesson.next");
    CHECK(at.state.lesson()->lesson().name == "02-again");
    CHECK(at.state.lesson()->step() == 0);
    run_command(at.state, "lesson.back");
    CHECK(at.state.lesson()->lesson().name == "01-ball");
    CHECK(at.state.lesson()->step() == 6);
    run_command(at.state, "lesson.first");
    CHECK(at.state.lesson()->step() == 0);
    run_command(at.state, "lesson.last");
    CHECK(at.state.lesson()->step() == 6);
    CHECK_THROWS_AS(run_command(at.state, "lesson.step", "8"), InputError);
    CHECK_THROWS_AS(run_command(at.state, "lesson.step", "0"), InputError);
    CHECK_THROWS_AS(run_command(at.state, "lesson.open", "cube"), InputError);
    CHECK(at.state.lesson()->step() == 6);
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

TEST_CASE("app lessons: the ray that is looked at stays selected while a value is tried") {
    AtStep at("4");
    at.state.select(1);
    REQUIRE(at.state.selected()->kind == RayKind::shadow);
    at.state.try_value(1.5);
    CHECK(at.state.selected()->kind == RayKind::shadow);
    run_command(at.state, "lesson.answer", "2");
    CHECK(at.state.selected()->kind == RayKind::shadow);
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
    test::Lessons lessons;
    std::ofstream(lessons.folder / "02-again" / "lesson.json") << "{";
    const auto entries = lessons_in(lessons.folder);
    REQUIRE(entries.size() == 2);
    CHECK(entries[0].title == "A ball");
    CHECK(entries[0].steps == 7);
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
    test::run_and_wait(state, "explain.crossings", "wall");
    REQUIRE(state.explanation().crossings);
    CHECK(state.explanation().crossings->test.t == doctest::Approx(7));  // from z = 5 to z = -2
    CHECK(state.explanation().crossings->crossed.size() == 1);
    CHECK_THROWS_WITH(run_command(state, "explain.crossings", "ball"),
                      doctest::Contains("no polygon 'ball'"));
    test::run_and_wait(state, "explain.time");
    CHECK(state.explained().time->rays > 81);
    test::run_and_wait(state, "explain.accuracy");
    CHECK(state.explained().accuracy->arithmetics.size() == 3);
    CHECK(explained_text(state).size() == 8);
    state.change("/materials/red/kd", "0.5");
    state.poll(std::chrono::seconds(20));  // what was measured is no longer so
    CHECK_FALSE(state.explained().time);
    CHECK_FALSE(state.explained().accuracy);
    test::run_and_wait(state, "explain.nothing");
    CHECK(explained_text(state).empty());
}

}  // namespace
}  // namespace raytree::inspector
