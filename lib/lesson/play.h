#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "lesson/lesson.h"
#include "lesson/stage.h"

/// A lesson on the stage: the scenes that its steps show, the numbers in its texts, and what is
/// said to an answer.
namespace raytree::lesson {

/// What an answer gets. Asking never blocks: the truth is told in any case.
struct Judgement {
    bool right = false;
    std::string truth;  ///< for people, with its unit
    FilledText hint;    ///< to a wrong answer that is known, else empty
    FilledText after;
};

/// Prepares the steps of one lesson, each scene once. Not for several threads at once. Steps count
/// from 0 here, from 1 in texts.
class Play {
  public:
    explicit Play(std::shared_ptr<const Lesson> lesson, TreeSource trace = the_tracer());
    Play(const Play&) = delete;
    Play& operator=(const Play&) = delete;

    const Lesson& lesson() const { return *lesson_; }
    const Step& step(std::size_t step) const { return lesson_->steps[step]; }

    /// The scene that a step shows. Throws InputError where it cannot be read.
    std::shared_ptr<const StageWorld> world(std::size_t step) const;
    /// The number of the ray that a step selects. Throws ExpressionError.
    std::size_t ray(std::size_t step) const;
    /// What the expressions of a step see. Throws InputError.
    std::shared_ptr<const Scope> scope(std::size_t step) const;

    /// Throw ExpressionError or InputError.
    FilledText text(std::size_t step) const;
    FilledText question(std::size_t step) const;
    FilledText option(std::size_t step, std::size_t option) const;

    /// `answer` to the step's question: a number; an option's place, from 0; [i, j] of a pixel; the
    /// number of a ray; a value. Throws ExpressionError or InputError for what cannot be judged.
    Judgement judge(std::size_t step, const Json& answer) const;
    /// An answer that is right, in the same form.
    Json right_answer(std::size_t step) const;
    /// The right answer for people.
    std::string truth_text(std::size_t step) const;

    /// Whether an answer is right, and the value that it stands for.
    bool is_right(std::size_t step, const Json& answer) const;
    /// The hint that an answer deserves; null for none.
    const Text* hint_for(std::size_t step, const Json& answer) const;

  private:
    bool is_answer_of_mistake(std::size_t step, const std::string& mistake,
                              const Json& answer) const;
    std::shared_ptr<const Scope> scope_of(std::size_t step, const Json& answer) const;

    std::shared_ptr<const Lesson> lesson_;
    TreeSource trace_;
    mutable std::map<std::pair<std::string, std::string>, std::shared_ptr<const StageWorld>>
        worlds_;
};

}  // namespace raytree::lesson
