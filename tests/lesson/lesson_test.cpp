#include "lesson/lesson.h"

#include <doctest/doctest.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "check/catalogue.h"
#include "check/lessons.h"
#include "folders.h"
#include "formats/output_file.h"
#include "lesson/check_lesson.h"
#include "lesson/features.h"
#include "lesson/lesson_folder.h"
#include "lesson/lesson_text.h"
#include "lesson/reading_time.h"
#include "lesson/sample_answers.h"

using namespace raytree;
using namespace raytree::lesson;

namespace {

namespace fs = std::filesystem;

const fs::path lessons = RAYTREE_LESSONS_DIR;

/// A folder with one lesson that is gone afterwards.
class OneLesson {
  public:
    explicit OneLesson(const std::string& text) {
        static int count = 0;
        folder_ = fs::temp_directory_path() /
                  ("raytree-lesson-" + std::to_string(getpid()) + "-" + std::to_string(count++));
        fs::create_directories(folder_ / "01-one");
        write("lesson.json", text);
        write("scene.json", R"({"format": "raytree-scene/1.0",
            "camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0], "horizontal_fov_degrees": 50,
                       "width": 9, "height": 9},
            "materials": {"glass": {"kd": 0.1, "kr": 0.2, "kt": 0.8}},
            "lights": [{"name": "key", "type": "point", "position": [3, 4, 5]}],
            "objects": [{"name": "ball", "type": "sphere", "center": [0, 0, 0], "radius": 1,
                         "material": "glass"}]})");
    }
    ~OneLesson() { fs::remove_all(folder_); }
    OneLesson(const OneLesson&) = delete;
    OneLesson& operator=(const OneLesson&) = delete;

    const fs::path& folder() const { return folder_; }
    Play play(TreeSource trace = the_tracer()) const {
        return Play(load_lesson(folder_, "one"), std::move(trace));
    }
    std::vector<Mistake> failures() const { return check_lesson(play()).failures; }

  private:
    void write(const char* name, const std::string& text) const {
        std::ofstream(folder_ / "01-one" / name) << text;
    }
    fs::path folder_;
};

/// A lesson of one step with these members besides its title and scene.
std::string lesson_with(const std::string& members,
                        const std::string& text = R"("See {primary.hit.t}.")",
                        const std::string& show = "") {
    return R"({"format": "raytree-lesson/1.0", "title": "T", "topic": "X", "minutes": 5, "steps": [
        {"title": "S", "show": {"scene": "scene.json", "pixel": [4, 4])" +
           show + R"(}, "text": )" + text + (members.empty() ? "" : ", " + members) + "}]}";
}

std::string refusal(const std::string& text) {
    try {
        OneLesson one(text);
        load_lesson(one.folder(), "one");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("lesson: its mistakes are told with their places, several together") {
    const std::string text = refusal(
        R"({"format": "raytree-lesson/1.0", "title": "T", "topic": "X", "minutes": 99, "steps": [
            {"title": "S", "text": "It is 4.2 long.", "show": {"scene": "s.json", "overley": "rays"},
             "claims": ["1 +"], "ask": {"kind": "nummer"}}]})");
    CHECK(has(text, "/minutes: found 99"));
    CHECK(has(text, "/steps/0/text: the number 4.2"));
    CHECK(has(text, "/steps/0/show/overley: is an unknown key; did you mean \"overlay\""));
    CHECK(has(text, "/steps/0/claims/0: '1 +': ends too early"));
    CHECK(has(text, "/steps/0/ask/kind: found \"nummer\""));
    CHECK(has(text, "did you mean \"number\""));
}

TEST_CASE("lesson: a hint for a mistake belongs to an answer that a program can give") {
    CHECK(has(refusal(lesson_with(R"("ask": {"kind": "ray", "question": "?",
        "truth": "picked.id == 0", "hints": [{"mistake": "shd.missing", "text": "x"}]})")),
              "/steps/0/ask/hints/0/mistake: is for questions of the kinds number and choice"));
}

TEST_CASE("lesson: numbers typed by hand are refused, those of formulas and names are not") {
    CHECK(has(refusal(lesson_with("", R"("About 75 %.")")), "75"));
    CHECK(has(refusal(lesson_with("", R"("About {75} %.")")), "refers to nothing"));
    CHECK(has(refusal(lesson_with("", R"("`t = 7.5`")")), "7.5"));
    CHECK(has(refusal(lesson_with("", R"("An *open mark.")")), "no end"));
    CHECK(has(refusal(lesson_with("", R"("A {primary.hit.t reference.")")), "lacks its }"));
    CHECK(has(refusal(lesson_with("", R"("{primary.hit.t; x}")")), "decimals"));
    const std::string untitled = lesson_with("");
    const auto titled = [&](const std::string& title) {
        return std::string(untitled).replace(untitled.find("\"S\""), 3, "\"" + title + "\"");
    };
    CHECK(has(refusal(titled("It takes 7 rays")), "/steps/0/title: the number 7 "));
    CHECK(has(refusal(titled("{counts.all} rays")), "without marks and references"));
    CHECK(refusal(titled("Seven rays")).empty());
    CHECK(refusal(lesson_with("", R"("`B² − 4 A C`, `i + 0.5`, `θ1` and 3D, `η1 = 1`.")")).empty());
}

TEST_CASE("lesson: a claim that does not hold is told with what was found") {
    CHECK(OneLesson(lesson_with(R"("claims": ["primary.hit.t == 4"])")).failures().empty());
    const auto failures =
        OneLesson(lesson_with(R"("claims": ["primary.hit.t == 4", "primary.hit.t == 5"])"))
            .failures();
    REQUIRE(failures.size() == 1);
    CHECK(failures[0].place == "/steps/0/claims/1");
    CHECK(has(failures[0].text, "the left side is 4"));
    CHECK(has(failures[0].file, "lesson.json"));
}

TEST_CASE("lesson: a change is applied by the names of lights and objects") {
    CHECK(
        OneLesson(
            lesson_with(
                R"("claims": ["primary.hit.t == 3", "counts.shadow == 0", "scene.lights.count == 0"])",
                R"("x")",
                R"(, "change": {"objects": {"ball": {"radius": 2}}, "lights": {"key": null}})"))
            .failures()
            .empty());
    const auto unknown =
        OneLesson(lesson_with("", R"("x")", R"(, "change": {"objects": {"bal": {"radius": 2}}})"))
            .failures();
    REQUIRE(unknown.size() == 1);
    CHECK(has(unknown[0].text, "did you mean \"ball\""));
    const auto wrong =
        OneLesson(lesson_with("", R"("x")", R"(, "change": {"settings": {"max_depth": 0}})"))
            .failures();
    REQUIRE(wrong.size() == 1);
    CHECK(has(wrong[0].text, "/settings/max_depth"));
}

TEST_CASE("lesson: shadow rays go by their lights, null where none was sent") {
    CHECK(OneLesson(lesson_with(R"("claims": ["primary.shadow.key.light == 'key'",
        "primary.shadow.count == 1", "primary.reflected.shadow.key == null",
        "primary.reflected.shadow.count == 0"])"))
              .failures()
              .empty());
    const auto unknown =
        OneLesson(lesson_with(R"("claims": ["primary.shadow.kea == null"])")).failures();
    REQUIRE(unknown.size() == 1);
    CHECK(has(unknown[0].text, "did you mean \"key\""));
}

TEST_CASE("lesson: answers are judged by the tree, and known mistakes get their hints") {
    const OneLesson one(lesson_with(R"("ask": {"kind": "number", "question": "t?",
        "truth": "primary.refracted.hit.t", "tolerance": 0.01, "unit": " units",
        "after": "It is {primary.refracted.hit.t}.",
        "hints": [{"when": "answer < 0", "text": "Forward only."},
                  {"mistake": "isect.far_root", "text": "The far one."}]})"));
    const Play play = one.play();
    CHECK(play.judge(0, 2).right);
    CHECK(play.judge(0, 2).truth == "2 units");
    CHECK(plain_text(play.judge(0, 2).after) == "It is 2.");
    CHECK(!play.judge(0, 2.1).right);
    CHECK(play.judge(0, 2.1).hint.empty());
    CHECK(plain_text(play.judge(0, -1).hint) == "Forward only.");
    CHECK_THROWS_AS(play.judge(0, "two"), ExpressionError);
}

TEST_CASE("lesson: a choice, a pixel, a ray and a value are judged") {
    const OneLesson choice(lesson_with(R"("ask": {"kind": "choice", "question": "?",
        "truth": "primary.hit.object", "options": [{"text": "a", "value": "cube", "hint": "No."},
                                                   {"text": "b", "value": "ball"}]})"));
    CHECK(choice.failures().empty());
    CHECK(choice.play().judge(0, 1).right);
    CHECK(plain_text(choice.play().judge(0, 0).hint) == "No.");
    CHECK_THROWS_AS(choice.play().judge(0, 2), ExpressionError);

    const OneLesson pixel(lesson_with(R"("ask": {"kind": "pixel", "question": "?",
        "truth": "picked.primary.hit == null", "example": [0, 0]})"));
    CHECK(pixel.failures().empty());
    CHECK(pixel.play().judge(0, Json::array({0, 8})).right);
    CHECK(!pixel.play().judge(0, Json::array({4, 4})).right);
    CHECK_THROWS_AS(pixel.play().judge(0, Json::array({9, 0})), ExpressionError);

    const OneLesson ray(lesson_with(R"("ask": {"kind": "ray", "question": "?",
        "truth": "picked.kind == 'refracted' and picked.level == 2"})"));
    CHECK(ray.failures().empty());
    const Play ray_play = ray.play();
    CHECK(ray_play.right_answer(0) == ray_play.scope(0)
                                          ->member("primary")
                                          ->scope->member("refracted")
                                          ->scope->member("id")
                                          ->json->get<int>());

    const OneLesson value(lesson_with(R"("ask": {"kind": "value", "question": "?",
        "set": "/settings/max_depth", "from": 1, "to": 9, "whole": true, "example": 1,
        "truth": "primary.refracted == null"})"));
    CHECK(value.failures().empty());
    CHECK(value.play().judge(0, 1).right);
    CHECK(!value.play().judge(0, 3).right);
}

TEST_CASE("lesson: a question that cannot judge an answer is found") {
    const auto failure = [](const std::string& ask) {
        const auto failures = OneLesson(lesson_with("\"ask\": {" + ask + "}")).failures();
        return failures.size() == 1 ? failures[0].place + ": " + failures[0].text : "";
    };
    // In the corners there is no ball.
    const std::string corner = failure(R"("kind": "pixel", "question": "?", "example": [4, 4],
        "truth": "picked.primary.hit.object == 'ball'")");
    CHECK(has(corner, "/steps/0/ask: the answer [0,0] cannot be judged"));
    CHECK(has(corner, "x != null and"));
    CHECK(
        has(failure(R"("kind": "number", "question": "?", "tolerance": 0, "truth": "primary.hit.t",
        "hints": [{"when": "anser > 0", "text": "x"}])"),
            "there is no name 'anser'"));
}

TEST_CASE("lesson: questions without exactly one right answer are found") {
    const auto two = OneLesson(lesson_with(R"("ask": {"kind": "choice", "question": "?",
        "truth": "1", "options": [{"text": "a", "value": 1}, {"text": "b", "value": 1}]})"))
                         .failures();
    REQUIRE(two.size() == 1);
    CHECK(has(two[0].text, "2 options are right"));
    CHECK(OneLesson(lesson_with(R"("ask": {"kind": "pixel", "question": "?",
        "truth": "picked.primary.hit == null", "example": [4, 4]})"))
              .failures()
              .size() == 1);
    // A mistake that changes nothing here is no wrong answer.
    const auto idle = OneLesson(lesson_with(R"("ask": {"kind": "number", "question": "?",
        "truth": "primary.hit.t", "tolerance": 0.01,
        "hints": [{"mistake": "refr.eta_inverted", "text": "x"}]})"))
                          .failures();
    REQUIRE(idle.size() == 1);
    CHECK(has(idle[0].text, "gives the right answer here"));
}

TEST_CASE("the lessons hold, each with its questions, claims and steps") {
    const auto names = lesson_names(lessons);
    CHECK(names.size() == 21);
    for (const std::string& name : names) {
        CAPTURE(name);
        const Play play(load_lesson(lessons, name));
        const LessonCheck checked = check_lesson(play);
        for (const Mistake& failure : checked.failures) {
            FAIL_CHECK(failure.message());
        }
        CHECK(checked.steps >= 5);
        CHECK(checked.steps <= 12);
        CHECK(checked.questions >= 2);
        CHECK(checked.claims >= 4);
        // By a slow reader's time, with room for a look at the picture.
        CHECK(checked.minutes >= 5);
        CHECK(checked.minutes <= 9.8);
        CHECK(play.lesson().minutes == std::lround(checked.minutes));
    }
}

TEST_CASE("lesson: the time that it takes is that of all words and questions") {
    // The title and two words; a number is a word.
    CHECK(reading_minutes(OneLesson(lesson_with("")).play()) == doctest::Approx(3.0 / 130));
    // And four of the question, two and one of the options, three of the longer hint, five after.
    const OneLesson one(lesson_with(R"("ask": {"kind": "choice", "question": "How far is it?",
        "truth": "primary.hit.t", "after": "After {primary.hit.t} units, not before.",
        "options": [{"text": "{primary.hit.t} units", "value": 4},
                    {"text": "Farther", "value": 5, "hint": "That is behind."}],
        "hints": [{"when": "answer == 5", "text": "No."}]})"));
    CHECK(reading_minutes(one.play()) == doctest::Approx(0.5 + (3 + 4 + 2 + 1 + 3 + 5) / 130.0));
    CHECK(check_lesson(one.play()).minutes == doctest::Approx(reading_minutes(one.play())));
}

TEST_CASE("a wrong choice, pixel, ray or value is told in every lesson what is wrong with it") {
    for (const std::string& name : lesson_names(lessons)) {
        const Play play(load_lesson(lessons, name));
        for (std::size_t k = 0; k < play.lesson().steps.size(); ++k) {
            // A number may be wrong in ways that nobody can foresee.
            const auto& ask = play.step(k).ask;
            if (!ask || ask->kind == AskKind::number) {
                continue;
            }
            for (const Json& answer : sample_answers(play, k, 20)) {
                CAPTURE(name);
                CAPTURE(k + 1);
                CAPTURE(answer.dump());
                CHECK((play.is_right(k, answer) || play.hint_for(k, answer) != nullptr));
            }
        }
    }
}

TEST_CASE("a tracer with a mistake does not pass the lessons") {
    const auto broken = [](const std::string& name, const std::string& mistake) {
        const Play play(load_lesson(lessons, name), with_mistake(mistake));
        return !check_lesson(play).failures.empty();
    };
    CHECK(broken("ray-through-a-pixel", "cam.no_half"));
    CHECK(broken("spheres", "isect.far_root"));
    CHECK(broken("polygons", "nrm.flat_for_smooth"));
    CHECK(broken("world-and-eye-space", "cam.right_not_normalised"));
    CHECK(broken("hidden-surfaces", "isect.farthest"));
    CHECK(broken("first-tree", "rec.depth_minus_one"));
    CHECK(broken("reflected-direction", "refl.no_factor2"));
    CHECK(broken("refracted-direction", "refr.eta_inverted"));
    CHECK(broken("shadows", "shd.unlimited"));
    CHECK(broken("illumination", "refl.kr_missing"));
    CHECK(broken("attenuation", "rec.fade_missing"));
    CHECK(broken("where-a-tree-ends", "rec.min_weight_ignored"));
    CHECK(broken("counting-rays", "refl.missing_child"));
    CHECK(broken("nothing-can-be-culled", "isect.backface_culled"));
    for (const char* const mistake : {"lit.ambient_no_scene", "lit.directional_sign",
                                      "lit.spec_unclamped", "lit.spec_abs", "lit.clamped_early"}) {
        CAPTURE(mistake);
        CHECK(broken("illumination", mistake));
    }
    CHECK(broken("nothing-can-be-culled", "hit.near_rule_on_secondary"));
    CHECK(broken("when-numbers-fail", "refr.no_offset"));
    // What only a stretched ball, a cut one, a slanted mirror or a ball of glass tells.
    for (const char* const mistake : {"isect.local_dir_normalised", "nrm.inverse_not_transposed",
                                      "nrm.object_space", "nrm.homogeneous_point"}) {
        CAPTURE(mistake);
        CHECK(broken("spheres", mistake));
    }
    CHECK(broken("ray-through-a-pixel", "cam.window_symmetric"));
    CHECK(broken("ray-through-a-pixel", "hit.primary_without_near"));
    CHECK(broken("reflected-direction", "refl.componentwise"));
    CHECK(broken("reflected-direction", "hit.point_from_eye"));
    CHECK(broken("shadows", "shd.spec_not_shadowed"));
    CHECK(broken("illumination", "shd.only_first_light"));
    CHECK(broken("nothing-can-be-culled", "shd.directional_none"));
    CHECK(broken("when-numbers-fail", "shd.skip_self"));
    // Its directions are no numbers: told, and no error of the format.
    CHECK(broken("refracted-direction", "refr.tir_nan"));
}

TEST_CASE("the lesson that shows a mistake is there, by that title") {
    for (const check::MistakeRow& row : check::catalogue()) {
        CAPTURE(row.id);
        const check::Lesson& shown = check::lesson_of(row.id);
        const std::string name = find_lesson(lessons, std::to_string(shown.number));
        CHECK(load_lesson(lessons, name)->title == shown.title);
    }
    // Where the lesson works with the mistake itself.
    CHECK(check::lesson_of("isect.negative_t").number == 4);
    CHECK(check::lesson_of("nrm.inverted").number == 9);
    CHECK(check::lesson_of("shd.no_offset").number == 21);
    CHECK(check::lesson_of("shd.unlimited").number == 11);
    CHECK(check::lesson_of("isect.backface_culled").number == 16);
}

/// Takes minutes, so that it runs on request: raytree_tests -ns -tc="every mistake*".
TEST_CASE("every mistake of the catalogue breaks the lesson to which it points" * doctest::skip()) {
    for (const check::MistakeRow& row : check::catalogue()) {
        // A number that is none has many causes; the model takes nothing away from local light.
        if (row.id == "num.nan" || row.id == "rec.complement_missing") {
            continue;
        }
        CAPTURE(row.id);
        const std::string name =
            find_lesson(lessons, std::to_string(check::lesson_of(row.id).number));
        const Play play(load_lesson(lessons, name), with_mistake(std::string(row.id)));
        CHECK_FALSE(check_lesson(play).failures.empty());
    }
}

TEST_CASE("lesson: it is found by name, number, or name without number") {
    CHECK(find_lesson(lessons, "04-spheres") == "04-spheres");
    CHECK(find_lesson(lessons, "spheres") == "04-spheres");
    CHECK(find_lesson(lessons, "4") == "04-spheres");
    CHECK(find_lesson(lessons, "04") == "04-spheres");
    CHECK_THROWS_WITH(find_lesson(lessons, "sphere"),
                      doctest::Contains("did you mean \"spheres\""));
    CHECK_THROWS_AS(lesson_names(lessons / "04-spheres"), InputError);
    CHECK(lessons_beside(lessons / "../build/bin/raytree").filename() == "lessons");
}

TEST_CASE("lesson: as text it has every number put in") {
    const Play play(load_lesson(lessons, "spheres"));
    const std::string text = write_lesson_text(play);
    const std::string of_all = " of " + std::to_string(play.lesson().steps.size());
    CHECK(has(text, "1" + of_all));
    CHECK(has(text, "Answer: "));
    CHECK(!has(text, "{primary"));
    LessonTextOptions third;
    third.step = 2;
    CHECK(has(write_lesson_text(play, third), "3" + of_all));
    CHECK(!has(write_lesson_text(play, third), "1" + of_all));
}

TEST_CASE("lesson: numbers are written as the reference asks") {
    const auto form = [](const Json& value, std::optional<int> decimals, bool percent = false) {
        return written(value, {Expression("1"), decimals, percent});
    };
    CHECK(form(1234567.891, 2) == "1,234,567.89");
    CHECK(form(1234, 0) == "1234");
    CHECK(form(-1234567, 0) == "-1,234,567");
    CHECK(form(0.756, 0, true) == "76 %");
    CHECK(form(-0.0001, 2) == "0.00");
    CHECK(form(Json::array({1.0, 2.5}), 1) == "(1.0, 2.5)");
    CHECK(form("no_intersection", std::nullopt) == "no intersection");
    CHECK(form(nullptr, std::nullopt) == "nothing");
}
