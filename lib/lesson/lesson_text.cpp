#include "lesson/lesson_text.h"

#include "formats/styled_text.h"

namespace raytree::lesson {
namespace {

Style style_of(const FilledPiece& piece) {
    return piece.emphasis == Emphasis::plain ? Style::plain : Style::label;
}

void add_blocks(StyledText& out, const std::string& indent, const FilledText& text) {
    for (std::size_t k = 0; k < text.size(); ++k) {
        const FilledBlock& block = text[k];
        const bool item = block.kind == Block::Kind::item;
        if (k > 0 && !(item && text[k - 1].kind == Block::Kind::item)) {
            out.line("", {});
        }
        Spans spans;
        for (const FilledPiece& piece : block.pieces) {
            spans.push_back({style_of(piece), piece.text});
        }
        if (block.kind == Block::Kind::formula) {
            out.line(indent + "    ", spans);
        } else {
            out.paragraph(item ? indent + "• " : indent, item ? indent + "  " : indent, spans);
        }
    }
}

/// JSON in one line, with blanks at which it may be broken.
std::string spaced(const std::string& json) {
    std::string text;
    bool quoted = false;
    for (const char c : json) {
        quoted ^= c == '"';  // names and words of scenes have no escaped quotes
        text += c;
        text += !quoted && (c == ',' || c == ':') ? " " : "";
    }
    return text;
}

class LessonWriter {
  public:
    LessonWriter(const Play& play, const LessonTextOptions& options)
        : play_(play), options_(options), out_(options.colour, options.width) {}

    std::string write() {
        const Lesson& lesson = play_.lesson();
        out_.line("", {{Style::heading, lesson.title}});
        out_.paragraph(
            "", "",
            {{Style::plain, lesson.topic + ", " + std::to_string(lesson.minutes) + " minutes"}});
        std::string before;
        for (const std::string& known : lesson.before) {
            before += (before.empty() ? "Before: " : "; ") + known;
        }
        if (!before.empty()) {
            out_.paragraph("", "        ", {{Style::plain, before}});
        }
        for (std::size_t k = 0; k < lesson.steps.size(); ++k) {
            if (!options_.step || *options_.step == k) {
                add_step(k);
            }
        }
        return out_.take();
    }

  private:
    void add_step(std::size_t k) {
        const Step& step = play_.step(k);
        out_.line("", {});
        out_.line("", {{Style::heading, std::to_string(k + 1) + " of " +
                                            std::to_string(play_.lesson().steps.size()) + "  " +
                                            step.title}});
        out_.line("", {});
        add_blocks(out_, "  ", play_.text(k));
        out_.line("", {});
        add_shown(k);
        if (step.ask) {
            add_question(k);
        }
    }

    void add_shown(std::size_t k) {
        const Show& show = play_.step(k).show;
        std::string text = "Shown: " + show.scene + ", pixel " + std::to_string(show.pixel.i) +
                           "," + std::to_string(show.pixel.j) + ", ray #" +
                           std::to_string(play_.ray(k));
        if (!show.change.is_null()) {
            text += ", with " + spaced(show.change.dump());
        }
        out_.paragraph("  ", "         ", {{Style::absent, text}});
    }

    void add_question(std::size_t k) {
        const Ask& ask = *play_.step(k).ask;
        out_.line("", {});
        const FilledText question = play_.question(k);
        out_.line("  ", {{Style::label, "Question"}});
        add_blocks(out_, "  ", question);
        for (std::size_t option = 0; option < ask.options.size(); ++option) {
            const std::string mark(1, static_cast<char>('a' + option));
            out_.paragraph("    " + mark + "  ", "       ",
                           {{Style::plain, plain_text(play_.option(k, option))}});
        }
        const Judgement judgement = play_.judge(k, play_.right_answer(k));
        out_.paragraph("  Answer: ", "          ", {{Style::plain, judgement.truth}});
        if (!judgement.after.empty()) {
            add_blocks(out_, "  ", judgement.after);
        }
    }

    const Play& play_;
    const LessonTextOptions& options_;
    StyledText out_;
};

}  // namespace

std::string write_lesson_text(const Play& play, const LessonTextOptions& options) {
    return LessonWriter(play, options).write();
}

}  // namespace raytree::lesson
