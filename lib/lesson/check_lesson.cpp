#include "lesson/check_lesson.h"

#include <algorithm>

#include "lesson/features.h"
#include "lesson/reading_time.h"
#include "lesson/sample_answers.h"

namespace raytree::lesson {
namespace {

class LessonChecker {
  public:
    explicit LessonChecker(const Play& play) : play_(play) {}

    LessonCheck check() {
        for (std::size_t k = 0; k < play_.lesson().steps.size(); ++k) {
            ++result_.steps;
            check_step(k);
        }
        if (result_.failures.empty()) {
            result_.minutes = reading_minutes(play_);
        }
        return std::move(result_);
    }

  private:
    void fail(const std::string& place, const std::string& text) {
        result_.failures.push_back({play_.lesson().file.string(), place, text});
    }

    /// Runs `work`, which may say that something cannot be worked out.
    template <class Work> void guarded(const std::string& place, Work work) {
        try {
            work();
        } catch (const ExpressionError& error) {
            fail(place, error.what());
        } catch (const InputError& error) {
            for (const Mistake& mistake : error.mistakes()) {
                fail(place, mistake.message());
            }
        }
    }

    void check_step(std::size_t k) {
        const Step& step = play_.step(k);
        const std::size_t before = result_.failures.size();
        guarded(step.place + "/show", [&] { check_show(k); });
        if (result_.failures.size() > before) {
            return;  // nothing else can hold
        }
        check_text(step.text, k);
        for (const Claim& claim : step.claims) {
            ++result_.claims;
            guarded(claim.place, [&] {
                const auto scope = play_.scope(k);
                if (!claim.that.truth(*scope)) {
                    const std::string found = claim.that.found(*scope);
                    fail(claim.place, "does not hold: " + claim.that.text() +
                                          (found.empty() ? "" : "; " + found));
                }
            });
        }
        if (step.ask) {
            ++result_.questions;
            guarded(step.ask->place, [&] { check_ask(*step.ask, k); });
        }
    }

    void check_show(std::size_t k) {
        const Show& show = play_.step(k).show;
        const auto world = play_.world(k);
        const auto tree = world->tree_at(show.pixel.i, show.pixel.j);
        play_.ray(k);
        if (show.stepped && static_cast<std::size_t>(*show.stepped) >= tree->rays.size()) {
            throw ExpressionError("stepped is " + std::to_string(*show.stepped) +
                                  ", but the tree has " + std::to_string(tree->rays.size()) +
                                  " rays, from 0");
        }
        check_features(*world, show, play_.ray(k));
    }

    void check_text(const Text& text, std::size_t k) {
        for (const Block& block : text.blocks) {
            result_.references += static_cast<std::size_t>(std::ranges::count_if(
                block.pieces, [](const Piece& piece) { return piece.reference.has_value(); }));
        }
        guarded(text.place, [&] { fill(text, *play_.scope(k)); });
    }

    void check_ask(const Ask& ask, std::size_t k) {
        check_text(ask.question, k);
        check_text(ask.after, k);
        for (const Option& option : ask.options) {
            check_text(option.text, k);
            check_text(option.hint, k);
        }
        for (const Hint& hint : ask.hints) {
            check_text(hint.text, k);
        }
        if (ask.kind == AskKind::choice) {
            check_options(ask, k);
        }
        const Json right = play_.right_answer(k);
        if (!play_.is_right(k, right)) {
            fail(ask.place, "the answer " + right.dump() + " is not right: " + ask.truth.text());
        }
        if (ask.kind == AskKind::number || ask.kind == AskKind::choice) {
            check_hints(ask, k);
        }
        check_answers(ask, k);
    }

    /// Whatever is answered can be judged, and what is said to it can be found.
    void check_answers(const Ask& ask, std::size_t k) {
        for (const Json& answer : sample_answers(play_, k)) {
            try {
                if (!play_.is_right(k, answer)) {
                    play_.hint_for(k, answer);
                }
            } catch (const ExpressionError& error) {
                fail(ask.place,
                     "the answer " + answer.dump() + " cannot be judged: " + error.what());
                return;
            }
        }
    }

    void check_options(const Ask& ask, std::size_t k) {
        std::size_t right = 0;
        for (std::size_t option = 0; option < ask.options.size(); ++option) {
            right += play_.is_right(k, option) ? 1 : 0;
        }
        if (right != 1) {
            fail(ask.place + "/options", std::to_string(right) +
                                             " options are right, must be exactly one; the truth "
                                             "is " +
                                             ask.truth.data(*play_.scope(k)).dump());
        }
    }

    /// A hint for a mistake is one to a wrong answer: the mistake changes the truth.
    void check_hints(const Ask& ask, std::size_t k) {
        const auto scope = play_.scope(k);
        const Json truth = ask.truth.data(*scope);
        for (std::size_t h = 0; h < ask.hints.size(); ++h) {
            const Hint& hint = ask.hints[h];
            if (hint.mistake.empty()) {
                continue;
            }
            const std::string place = ask.place + "/hints/" + std::to_string(h) + "/mistake";
            guarded(place, [&] {
                const Value word = Value::of(hint.mistake);
                const auto wrong = scope->call("mistake", std::span(&word, 1));
                if (same(ask.truth.data(*wrong->scope), truth, ask.tolerance)) {
                    fail(place, hint.mistake + " gives the right answer here");
                }
            });
        }
    }

    const Play& play_;
    LessonCheck result_;
};

}  // namespace

LessonCheck check_lesson(const Play& play) { return LessonChecker(play).check(); }

}  // namespace raytree::lesson
