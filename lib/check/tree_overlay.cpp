#include "check/tree_overlay.h"

#include <algorithm>
#include <array>

#include "check/describe.h"
#include "check/overlay_cards.h"
#include "formats/svg.h"
#include "tree/layout.h"

namespace raytree::check {
namespace {

constexpr double font = overlay_font, line_height = 15, margin = 8, mark_size = 16, head = 22;
constexpr double page = 24, header = 84;
constexpr const char* ink = "#2B3440";
constexpr const char* faint = "#6B7683";

struct Look {
    const char* line;
    const char* fill;
    const char* dashes;
    double width;
    const char* word;
};
constexpr std::array<Look, 5> looks = {{{"#2E7D5B", "#F1F8F4", "", 1.3, "right"},
                                        {"#B26A00", "#FFF8EC", "", 1.3, "follows"},
                                        {"#6B7683", "#FFFFFF", "5 4", 1.6, "missing"},
                                        {"#7B3FA0", "#F8F1FC", "1.5 3", 2.4, "too many"},
                                        {"#B3261E", "#FDF0EF", "", 2.6, "different"}}};
const Look& look_of(State state) { return looks[static_cast<std::size_t>(state)]; }

void measure(Card& card) {
    card.width = text_width(card.title, font) * 1.1 + mark_size + 3 * margin +
                 text_width(look_of(card.state).word, font) + margin;
    for (const Line& line : card.lines) {
        card.width = std::max(card.width, text_width(line.text, font) + 4 * margin);
    }
    card.height = head + line_height * static_cast<double>(card.lines.size()) +
                  (card.lines.empty() ? 0 : margin);
}

std::string at(double x, double y) { return svg_number(x) + " " + svg_number(y); }

/// A tick, a hook, an empty ring, a plus and an unequal sign.
void draw_mark(Svg& svg, double x, double y, State state) {
    const Look& look = look_of(state);
    const std::string colour = look.line;
    svg.circle(x, y, 7, "#FFFFFF", {colour, 1.5, state == State::missing ? "2.5 2" : ""});
    switch (state) {
        case State::right:
            svg.path("M " + at(x - 3.5, y) + " l 2.5 3 l 4.5 -5.5", {colour, 1.8, ""});
            break;
        case State::follows:
            svg.path("M " + at(x - 2.5, y - 4) + " v 5 h 5 m -2 -2 l 2 2 l -2 2",
                     {colour, 1.5, ""});
            break;
        case State::missing:
            break;
        case State::extra:
            svg.path("M " + at(x - 4, y) + " h 8 M " + at(x, y - 4) + " v 8", {colour, 1.8, ""});
            break;
        case State::differs:
            svg.path("M " + at(x - 3.5, y - 1.7) + " h 7 M " + at(x - 3.5, y + 1.7) + " h 7 M " +
                         at(x + 2.2, y - 4.5) + " l -4.4 9",
                     {colour, 1.5, ""});
            break;
    }
}

class Overlay {
  public:
    Overlay(const Cards& cards, const Report& report, const RayTree<double>& truth)
        : cards_(cards.cards), left_out_(cards.left_out), report_(report), truth_(truth) {
        std::ranges::for_each(cards_, measure);
    }

    std::string draw() {
        std::vector<LayoutNode> nodes;
        for (const Card& card : cards_) {
            nodes.push_back({card.parent, card.width, card.height});
        }
        layout_ = lay_out(nodes, {24, 34});
        const std::string title = "Pixel " + std::to_string(truth_.pixel_i) + "," +
                                  std::to_string(truth_.pixel_j) + " of " + truth_.scene_name +
                                  ": " + fitted_text(harmless(report_.file), 15, 320);
        const double width = std::max({layout_.breadth, text_width(verdict_text(), font),
                                       1.2 * text_width(title, 15), 620.0}) +
                             2 * page;
        left_ = (width - layout_.breadth) / 2;
        svg_.text(page, 28, title, {15, ink, true});
        svg_.text(page, 48, verdict_text(), {font, faint});
        draw_legend();
        for (std::size_t k = 0; k < cards_.size(); ++k) {
            draw_edge(k);
        }
        for (std::size_t k = 0; k < cards_.size(); ++k) {
            draw_card(k);
        }
        return svg_.finish(width, header + layout_.depth + page, title);
    }

  private:
    std::string verdict_text() const {
        std::string text(word_of(report_.verdict));
        text += ", by the profile " + report_.profile;
        for (const NamedMistake& mistake : report_.mistakes) {
            text += "; " + mistake.id + (mistake.sure ? " (sure)" : "");
        }
        return left_out_ == 0
                   ? text
                   : text + "; the first " + std::to_string(cards_.size()) + " rays are drawn";
    }

    double middle(std::size_t k) const { return left_ + layout_.places[k].middle; }
    double top(std::size_t k) const { return header + layout_.places[k].start; }

    void draw_edge(std::size_t k) {
        const Card& card = cards_[k];
        if (!card.parent) {
            return;
        }
        const double from = top(*card.parent) + cards_[*card.parent].height;
        const double to = top(k);
        const Look& look = look_of(card.state);
        svg_.path("M " + at(middle(*card.parent), from) + " C " + at(middle(*card.parent), to - 4) +
                      " " + at(middle(k), to - 30) + " " + at(middle(k), to),
                  {look.line, look.width, look.dashes});
    }

    void draw_card(std::size_t k) {
        const Card& card = cards_[k];
        const Look& look = look_of(card.state);
        const double x = middle(k) - card.width / 2, y = top(k);
        svg_.begin_group(card.title);
        svg_.rectangle(x, y, card.width, card.height, look.fill,
                       {look.line, look.width, look.dashes}, 4);
        draw_mark(svg_, x + margin + mark_size / 2, y + head / 2, card.state);
        const bool absent = card.state == State::missing && card.found == Card::none;
        svg_.text(x + 2 * margin + mark_size, y + head / 2 + 4, card.title,
                  {font, absent ? faint : ink, !absent, absent});
        svg_.text(x + card.width - margin, y + head / 2 + 4, look.word,
                  {font, look.line, false, true, "end"});
        double baseline = y + head + 10;
        for (const Line& line : card.lines) {
            const bool right = line.state == State::right;
            svg_.text(x + 2 * margin, baseline, line.text,
                      {font, right ? faint : look_of(line.state).line, line.state == State::differs,
                       line.state == State::missing});
            baseline += line_height;
        }
        svg_.end_group();
    }

    void draw_legend() {
        double x = page + 8;
        for (const State state :
             {State::right, State::differs, State::follows, State::missing, State::extra}) {
            const char* const words[] = {"right", "follows from an earlier difference", "missing",
                                         "too many", "different"};
            const char* const word = words[static_cast<std::size_t>(state)];
            draw_mark(svg_, x, 66, state);
            svg_.text(x + 12, 70, word, {font, look_of(state).line});
            x += text_width(word, font) + 36;
        }
    }

    std::vector<Card> cards_;
    std::size_t left_out_;
    const Report& report_;
    const RayTree<double>& truth_;
    TreeLayout layout_;
    Svg svg_;
    double left_ = 0;
};

}  // namespace

std::string write_tree_overlay(const Submission& submission, const RayTree<double>& truth,
                               const Report& report) {
    const Cards cards(submission, truth, report);
    return Overlay(cards, report, truth).draw();
}

}  // namespace raytree::check
