#include <algorithm>
#include <array>
#include <cmath>

#include "check/catalogue.h"
#include "formats/output_file.h"
#include "lesson/lesson.h"
#include "lesson/show_read.h"

namespace raytree::lesson {
namespace {

const ObjectReader::Words ask_kinds = {"number", "choice", "pixel", "ray", "value"};

/// Calls `read(value, place, index)` for the elements of a list of objects.
template <class Read>
void read_list(const ObjectReader& reader, std::string_view key, JsonReport& report, Read read) {
    const Json* const list = reader.find(key);
    if (list == nullptr) {
        return;
    }
    const JsonPlace place = reader.place_of(key);
    if (!list->is_array()) {
        report.add(place, "found " + shown(*list) + ", must be a list");
        return;
    }
    for (std::size_t k = 0; k < list->size(); ++k) {
        read((*list)[k], place.element(k));
    }
}

class LessonReader {
  public:
    explicit LessonReader(JsonReport& report) : report_(report) {}

    void read(const Json& document, Lesson& lesson) {
        const JsonPlace top;
        const ObjectReader reader(document, top, report_);
        reader.text("title", lesson.title, Need::required);
        reader.text("topic", lesson.topic, Need::required);
        read_list(reader, "before", report_, [&](const Json& value, const JsonPlace& place) {
            if (value.is_string()) {
                lesson.before.push_back(value.get<std::string>());
            } else {
                report_.add(place, "found " + shown(value) + ", must be a string");
            }
        });
        std::int64_t minutes = 0;
        reader.whole_number("minutes", minutes, Need::required, 1, 60);
        lesson.minutes = static_cast<int>(minutes);
        reader.need("steps", "a list of steps");
        read_list(reader, "steps", report_, [&](const Json& value, const JsonPlace& place) {
            if (ObjectReader::is_object(value, place, report_)) {
                Step step = read_step(value, place, lesson);
                lesson.steps.push_back(std::move(step));
            }
        });
        if (lesson.steps.empty()) {
            report_.add(reader.place_of("steps"), "a lesson has at least one step");
        }
        reader.nothing_but({"format", "title", "topic", "before", "minutes", "steps"});
    }

  private:
    Step read_step(const Json& value, const JsonPlace& place, const Lesson& lesson) {
        const ObjectReader reader(value, place, report_);
        Step step;
        step.place = place.pointer();
        step.title = step_title(reader);
        step.text = text(reader, "text", Need::required);
        if (!lesson.steps.empty()) {
            step.show = carried_over(lesson.steps.back().show);
        }
        const Json* const show =
            lesson.steps.empty() ? reader.need("show", "an object") : reader.find("show");
        if (show != nullptr) {
            read_show(*show, reader.place_of("show"), report_, step.show);
        }
        if (const Json* const ask = reader.find("ask")) {
            step.ask = read_ask(*ask, reader.place_of("ask"));
        }
        read_list(reader, "claims", report_, [&](const Json& claim, const JsonPlace& at) {
            step.claims.push_back({expression(claim, at), at.pointer()});
        });
        reader.nothing_but({"title", "text", "show", "ask", "claims"});
        return step;
    }

    /// It is shown as it stands, so that no number in it could be looked up.
    std::string step_title(const ObjectReader& reader) {
        std::string title;
        reader.text("title", title, Need::required);
        const JsonPlace place = reader.place_of("title");
        for (const Block& block : read_text(title, place, report_).blocks) {
            const auto is_plain = [](const Piece& piece) {
                return piece.emphasis == Emphasis::plain && !piece.reference;
            };
            if (!std::ranges::all_of(block.pieces, is_plain)) {
                report_.add(place, "found '" + title + "', must be without marks and references");
            }
        }
        return title;
    }

    /// One string, or a list of them, one for each paragraph.
    Text text(const ObjectReader& reader, std::string_view key, Need need) {
        const Json* const value =
            need == Need::required ? reader.need(key, "a text") : reader.find(key);
        if (value == nullptr) {
            return {};
        }
        const JsonPlace place = reader.place_of(key);
        if (value->is_string()) {
            return read_text(value->get_ref<const std::string&>(), place, report_);
        }
        Text whole;
        whole.place = place.pointer();
        if (!value->is_array()) {
            report_.add(place, "found " + shown(*value) + ", must be a string or a list of them");
            return whole;
        }
        for (std::size_t k = 0; k < value->size(); ++k) {
            const JsonPlace at = place.element(k);
            if (!(*value)[k].is_string()) {
                report_.add(at, "found " + shown((*value)[k]) + ", must be a string");
                continue;
            }
            Text part = read_text((*value)[k].get_ref<const std::string&>(), at, report_);
            std::ranges::move(part.blocks, std::back_inserter(whole.blocks));
        }
        return whole;
    }

    Expression expression(const Json& value, const JsonPlace& place) {
        return read_expression(value, place, report_);
    }
    Expression expression(const ObjectReader& reader, std::string_view key, Need need) {
        const Json* const value =
            need == Need::required ? reader.need(key, "an expression") : reader.find(key);
        return value == nullptr ? Expression() : expression(*value, reader.place_of(key));
    }

    std::optional<Ask> read_ask(const Json& value, const JsonPlace& place) {
        if (!ObjectReader::is_object(value, place, report_)) {
            return std::nullopt;
        }
        const ObjectReader reader(value, place, report_);
        Ask ask;
        ask.place = place.pointer();
        std::size_t kind = 0;
        if (!reader.choice("kind", ask_kinds, kind, Need::required)) {
            return ask;  // which other keys it may have is not known
        }
        ask.kind = static_cast<AskKind>(kind);
        ask.question = text(reader, "question", Need::required);
        ask.truth = expression(reader, "truth", Need::required);
        ask.after = text(reader, "after", Need::optional);
        ObjectReader::Words keys = {"kind", "question", "truth", "after", "hints"};
        read_of_kind(reader, ask, keys);
        read_list(reader, "hints", report_, [&](const Json& hint, const JsonPlace& at) {
            if (ObjectReader::is_object(hint, at, report_)) {
                ask.hints.push_back(read_hint(hint, at));
                expect_an_answer(ask, at);
            }
        });
        reader.nothing_but(keys);
        return ask;
    }

    void read_of_kind(const ObjectReader& reader, Ask& ask, ObjectReader::Words& keys) {
        const auto also = [&keys](std::initializer_list<std::string_view> more) {
            keys.insert(keys.end(), more);
        };
        switch (ask.kind) {
            case AskKind::number:
                reader.number("tolerance", ask.tolerance, Need::required);
                reader.text("unit", ask.unit, Need::optional);
                if (!(ask.tolerance >= 0)) {
                    report_.add(reader.place_of("tolerance"), "must be 0 or more");
                }
                also({"tolerance", "unit"});
                return;
            case AskKind::choice:
                reader.need("options", "a list of options");
                read_list(reader, "options", report_, [&](const Json& option, const JsonPlace& at) {
                    if (ObjectReader::is_object(option, at, report_)) {
                        ask.options.push_back(read_option(option, at));
                    }
                });
                if (ask.options.size() < 2) {
                    report_.add(reader.place_of("options"), "must be two options or more");
                }
                also({"options"});
                return;
            case AskKind::pixel:
                read_example_pixel(reader, ask);
                also({"example"});
                return;
            case AskKind::value:
                read_value(reader, ask);
                also({"set", "from", "to", "whole", "unit", "example"});
                return;
            default:
                return;
        }
    }

    void read_example_pixel(const ObjectReader& reader, Ask& ask) {
        std::array<double, 2> pixel{};
        if (reader.numbers("example", 2, pixel.data(), Need::required)) {
            const auto whole = [](double x) {
                return x >= 0 && x <= 65535 && x == std::floor(x) ? Json(static_cast<int>(x))
                                                                  : Json(x);
            };
            ask.example = Json::array({whole(pixel[0]), whole(pixel[1])});
        }
    }

    void read_value(const ObjectReader& reader, Ask& ask) {
        std::string set;
        if (reader.text("set", set, Need::required)) {
            try {
                ask.set = Json::json_pointer(set);
            } catch (const Json::parse_error&) {
                report_.add(reader.place_of("set"), "found '" + set +
                                                        "', must be a JSON pointer such as "
                                                        "/settings/max_depth");
            }
        }
        reader.number("from", ask.from, Need::required);
        reader.number("to", ask.to, Need::required);
        if (!(ask.from < ask.to)) {
            report_.add(reader.place_of("to"), "must be more than from");
        }
        reader.truth("whole", ask.whole, Need::optional);
        reader.text("unit", ask.unit, Need::optional);
        double example = 0;
        if (reader.number("example", example, Need::required)) {
            ask.example = example;
            if (!(example >= ask.from && example <= ask.to)) {
                report_.add(reader.place_of("example"), "must be between from and to");
            }
        }
    }

    Option read_option(const Json& value, const JsonPlace& place) {
        const ObjectReader reader(value, place, report_);
        Option option;
        option.text = text(reader, "text", Need::required);
        const Json* const is = reader.need("value", "a number, a word, true or false");
        option.value = is == nullptr ? Json() : *is;
        option.hint = text(reader, "hint", Need::optional);
        reader.nothing_but({"text", "value", "hint"});
        return option;
    }

    /// A program with a mistake gives a number or makes a choice; it does not click.
    void expect_an_answer(const Ask& ask, const JsonPlace& place) {
        const bool answers = ask.kind == AskKind::number || ask.kind == AskKind::choice;
        if (!answers && !ask.hints.back().mistake.empty()) {
            report_.add(place.member("mistake"),
                        "is for questions of the kinds number and choice; use when here");
        }
    }

    Hint read_hint(const Json& value, const JsonPlace& place) {
        const ObjectReader reader(value, place, report_);
        Hint hint;
        reader.text("mistake", hint.mistake, Need::optional);
        hint.when = expression(reader, "when", Need::optional);
        hint.text = text(reader, "text", Need::required);
        if (hint.mistake.empty() == hint.when.empty()) {
            report_.add(place, "must have exactly one of mistake and when");
        }
        if (!hint.mistake.empty() && check::find_mistake(hint.mistake) == nullptr) {
            report_.add(reader.place_of("mistake"), unknown_mistake(hint.mistake));
        }
        reader.nothing_but({"mistake", "when", "text"});
        return hint;
    }

    JsonReport& report_;
};

}  // namespace

Lesson read_lesson(const std::filesystem::path& file) {
    JsonReport report;
    report.file = file.string();
    const Json document = parse_json(read_input(file), report.file);
    check_json_format(document, "raytree-lesson", 1, 0, report);
    Lesson lesson;
    lesson.file = file;
    lesson.name = std::filesystem::absolute(file).parent_path().filename().string();
    LessonReader(report).read(document, lesson);
    if (!report.mistakes.empty()) {
        throw InputError(std::move(report.mistakes));
    }
    lesson.warnings = std::move(report.warnings);
    return lesson;
}

}  // namespace raytree::lesson
