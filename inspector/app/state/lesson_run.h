#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lesson/play.h"
#include "state/document.h"
#include "trace/time_share.h"
#include "trace/work_precision.h"

namespace raytree::inspector {

/// What a student has answered to a question, and what was said to it.
struct LessonAnswer {
    Json given;          ///< in the form that lesson::Play::judge takes; null: asked to be shown
    std::string words;   ///< the answer for people
    std::string truth;   ///< the right answer for people
    bool right = false;  ///< false where nothing was given
    lesson::FilledText hint, after;
};

/// The texts of a step with the numbers put in.
struct LessonPage {
    lesson::FilledText text, question;
    std::vector<lesson::FilledText> options;
    std::string failure;  ///< why the step cannot be shown as it should be; else empty
};

/// A lesson that is open: the step one is at, and what has been answered. Steps count from 0.
class LessonRun {
  public:
    explicit LessonRun(std::shared_ptr<const lesson::Lesson> lesson);

    const lesson::Lesson& lesson() const { return play_.lesson(); }
    std::size_t count() const { return lesson().steps.size(); }
    std::size_t step() const { return step_; }
    const lesson::Step& here() const { return lesson().steps[step_]; }
    const LessonPage& page() const { return page_; }
    /// Null until the step's question has been answered.
    const LessonAnswer* answer() const;
    /// Whether a step's question has been answered rightly.
    bool is_solved(std::size_t step) const;

    /// What of a step takes long: its texts, and what they tell measured. May be done in another
    /// thread while nothing else is asked of the lesson.
    LessonPage prepared(std::size_t step) const;
    /// To a step that there is.
    void go_to(std::size_t step, LessonPage page);
    /// The scene of the step; the same document for steps that show the same.
    std::shared_ptr<const Document> document();
    /// Measured once for each scene: what the texts say of it.
    TimeShare time_share() const;
    WorkPrecision work_precision() const;
    /// The ray that the step selects. Throws InputError.
    std::size_t ray() const;

    /// Judges an answer to the step's question. Throws InputError for one that cannot be judged.
    void give(const Json& answer);
    /// Reads an answer: a number; an option's letter; a pixel I,J; a ray's number. Throws
    /// InputError.
    Json answer_from(std::string_view text) const;
    /// An answer that is right, in the form that `give` takes. Throws InputError.
    Json right_answer() const;
    /// The right answer instead of one's own.
    void tell();
    void forget_answer() { answers_.erase(step_); }
    /// The step's scene with the member that its question is about set to `value`. Throws
    /// InputError.
    std::shared_ptr<const Document> document_with(double value) const;
    /// The value that this member has in the step's scene.
    double value_shown() const;

  private:
    const lesson::Ask& ask() const;
    std::string words_of(const Json& answer) const;

    lesson::Play play_;
    std::size_t step_ = 0;
    LessonPage page_;
    std::map<std::size_t, LessonAnswer> answers_;
    std::map<const lesson::StageWorld*, std::shared_ptr<const Document>> documents_;
};

/// What a list of lessons says of one.
struct LessonEntry {
    std::string name;  ///< of its folder
    std::string title, topic;
    std::vector<std::string> before;
    int minutes = 0;
    std::size_t steps = 0;
    std::string failure;  ///< why it cannot be read; else empty
};

/// The lessons of a folder in their order. Throws InputError where there are none.
std::vector<LessonEntry> lessons_in(const std::filesystem::path& folder);

}  // namespace raytree::inspector
