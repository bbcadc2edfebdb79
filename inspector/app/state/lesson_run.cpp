#include "state/lesson_run.h"

#include <charconv>

#include "lesson/features.h"
#include "lesson/lesson_folder.h"
#include "tree/explain.h"

namespace raytree::inspector {
namespace {

using lesson::AskKind;

/// What goes wrong while a lesson looks something up, as a mistake of its file.
template <class Work>
auto in_step(const lesson::Lesson& lesson, const lesson::Step& step, Work work) {
    try {
        return work();
    } catch (const lesson::ExpressionError& error) {
        throw InputError(lesson.file.string(), step.place, error.what());
    }
}

double number_from(std::string_view text) {
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    if (read.ec != std::errc() || read.ptr != end) {
        throw InputError("", "answer",
                         "found '" + std::string(text) +
                             "', where a number is wanted, such as "
                             "0.25");
    }
    return value;
}

std::size_t option_from(std::string_view text, std::size_t count) {
    const std::size_t option =
        text.size() == 1 ? static_cast<std::size_t>(text.front() - 'a') : count;
    if (option >= count) {
        throw InputError("", "answer",
                         "found '" + std::string(text) + "', must be a letter from a to " +
                             std::string(1, static_cast<char>('a' + count - 1)));
    }
    return option;
}

}  // namespace

LessonRun::LessonRun(std::shared_ptr<const lesson::Lesson> lesson) : play_(std::move(lesson)) {}

const LessonAnswer* LessonRun::answer() const {
    const auto found = answers_.find(step_);
    return found == answers_.end() ? nullptr : &found->second;
}

bool LessonRun::is_solved(std::size_t step) const {
    const auto found = answers_.find(step);
    return found != answers_.end() && found->second.right;
}

LessonPage LessonRun::prepared(std::size_t step) const {
    const lesson::Step& there = lesson().steps[step];
    LessonPage page;
    try {
        page.text = play_.text(step);
        if (there.ask) {
            page.question = play_.question(step);
            for (std::size_t k = 0; k < there.ask->options.size(); ++k) {
                page.options.push_back(play_.option(step, k));
            }
        }
        if (there.show.time) {
            lesson::time_share_of(*play_.world(step));
        }
        if (there.show.accuracy) {
            lesson::work_precision_of(*play_.world(step));
        }
    } catch (const std::exception& error) {
        page.failure = error.what();
    }
    return page;
}

void LessonRun::go_to(std::size_t step, LessonPage page) {
    step_ = step;
    page_ = std::move(page);
}

std::shared_ptr<const Document> LessonRun::document() {
    const auto world = play_.world(step_);
    auto& document = documents_[world.get()];
    if (!document) {
        document = std::make_shared<const Document>(world->staged().file, world->staged().loaded);
    }
    return document;
}

std::size_t LessonRun::ray() const {
    return in_step(lesson(), here(), [&] { return play_.ray(step_); });
}

TimeShare LessonRun::time_share() const { return lesson::time_share_of(*play_.world(step_)); }
WorkPrecision LessonRun::work_precision() const {
    return lesson::work_precision_of(*play_.world(step_));
}

const lesson::Ask& LessonRun::ask() const {
    if (!here().ask) {
        throw InputError("", "answer", "this step asks nothing");
    }
    return *here().ask;
}

std::string LessonRun::words_of(const Json& answer) const {
    switch (ask().kind) {
        case AskKind::choice:
            return plain_text(page_.options.at(answer.get<std::size_t>()));
        case AskKind::pixel:
            return "pixel " + text_of(Pixel{answer[0].get<int>(), answer[1].get<int>()});
        case AskKind::ray:
            return "ray #" + std::to_string(answer.get<std::size_t>());
        default:
            return number_text(answer.get<double>()) + ask().unit;
    }
}

void LessonRun::give(const Json& answer) {
    in_step(lesson(), here(), [&] {
        const lesson::Judgement judged = play_.judge(step_, answer);
        answers_[step_] = {answer,       words_of(answer), judged.truth,
                           judged.right, judged.hint,      judged.after};
        return true;
    });
}

Json LessonRun::right_answer() const {
    return in_step(lesson(), here(), [&] { return play_.right_answer(step_); });
}

void LessonRun::tell() {
    in_step(lesson(), here(), [&] {
        const lesson::Judgement judged = play_.judge(step_, play_.right_answer(step_));
        answers_[step_] = {nullptr, "", judged.truth, false, {}, judged.after};
        return true;
    });
}

Json LessonRun::answer_from(std::string_view text) const {
    switch (ask().kind) {
        case AskKind::choice:
            return option_from(text, ask().options.size());
        case AskKind::pixel: {
            const Pixel pixel = pixel_from(text);
            return Json::array({pixel.i, pixel.j});
        }
        default:
            return number_from(text);
    }
}

std::shared_ptr<const Document> LessonRun::document_with(double value) const {
    return in_step(lesson(), here(), [&] {
        const Json said = ask().whole ? Json(static_cast<std::int64_t>(value)) : Json(value);
        const auto staged =
            lesson::change_scene(play_.world(step_)->staged(), ask().set.to_string(), said);
        return std::make_shared<const Document>(staged->file, staged->loaded);
    });
}

double LessonRun::value_shown() const {
    const Json& document = play_.world(step_)->staged().document;
    const bool there = document.contains(ask().set) && document.at(ask().set).is_number();
    return there ? document.at(ask().set).get<double>() : ask().from;
}

std::vector<LessonEntry> lessons_in(const std::filesystem::path& folder) {
    std::vector<LessonEntry> entries;
    for (const std::string& name : lesson::lesson_names(folder)) {
        LessonEntry entry{name, name, "", {}, 0, 0, ""};
        try {
            const auto read = lesson::load_lesson(folder, name);
            entry = {name,          read->title,        read->topic, read->before,
                     read->minutes, read->steps.size(), ""};
        } catch (const InputError& error) {
            entry.failure = error.what();
        }
        entries.push_back(std::move(entry));
    }
    return entries;
}

}  // namespace raytree::inspector
