#include "check/tree_overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "check/align.h"
#include "check/describe.h"
#include "formats/svg.h"
#include "tree/explain.h"
#include "tree/layout.h"

namespace raytree::check {
namespace {

constexpr std::size_t most_cards = 200;
constexpr std::size_t most_lines = 8;  // of a card
constexpr double font = 11, line_height = 15, margin = 8, mark_size = 16, head = 22;
constexpr double page = 24, header = 84, widest_text = 330;
constexpr const char* ink = "#2B3440";
constexpr const char* faint = "#6B7683";

/// What a card says of its ray, from the best to the worst.
enum class State { right, follows, missing, extra, differs };

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

struct Line {
    std::string text;
    State state = State::right;
};

/// A ray of the submission, of the truth, or of both, and its shadow rays.
struct Card {
    static constexpr std::size_t none = ~std::size_t{0};
    std::size_t found = none, due = none;
    std::optional<std::size_t> parent;
    State state = State::right;
    std::string title;
    std::vector<Line> lines;
    double width = 0, height = 0;
};

std::string short_value(const Value& value) {
    if (value.none() || !value.word.empty()) {
        return value.none() ? "nothing" : fitted_text(harmless(value.word), font, 150);
    }
    std::string text;
    for (int k = 0; k < value.numbers.size; ++k) {
        char number[32];
        std::snprintf(number, sizeof number, "%.4g", value.numbers.x[static_cast<std::size_t>(k)]);
        text += (k == 0 ? "" : ", ") + std::string(number);
    }
    return value.numbers.size == 1 ? text : '(' + text + ')';
}

std::string what_it_hits(const TreeRay<double>& ray) {
    return ray.hit && !ray.hit->object.empty() ? fitted_text(harmless(ray.hit->object), font, 140)
           : ray.hit                           ? "something"
                                               : "nothing";
}

std::string fate_of(const TreeRay<double>& shadow) {
    const auto& blocker = shadow.shadow->blocked_by;
    return blocker ? "blocked by " + fitted_text(harmless(blocker->object), font, 120)
                   : "reaches it";
}

/// The union of both trees, depth first.
class Cards {
  public:
    Cards(const Submission& submission, const RayTree<double>& truth, const Report& report)
        : tree_(submission.tree),
          truth_(truth),
          report_(report),
          children_(submission.children),
          true_children_(children_of(truth)) {
        findings_.resize(tree_.rays.size());
        for (const Finding& finding : report.findings) {
            if (finding.problem != Problem::whole && finding.ray < findings_.size()) {
                findings_[finding.ray].push_back(&finding);
            }
        }
        add(std::nullopt, 0, 0);
        for (std::size_t k = 0; k < cards.size(); ++k) {
            add_branches(k);
        }
    }

    std::vector<Card> cards;
    std::size_t left_out = 0;

  private:
    static constexpr std::size_t none = Card::none;

    void add(std::optional<std::size_t> parent, std::size_t found, std::size_t due) {
        if (cards.size() >= most_cards) {
            ++left_out;
            return;
        }
        Card card;
        card.found = found;
        card.due = due;
        card.parent = parent;
        card.state = found == none ? State::missing : state_of(found);
        const TreeRay<double>& ray = found != none ? tree_.rays[found] : truth_.rays[due];
        const std::string id =
            found != none ? " #" + fitted_text(harmless(report_.ids[found]), font, 60) : "";
        card.title = std::string(word_of(ray.kind)) + id + ": " + what_it_hits(ray);
        if (found != none) {
            describe(card, found);
        }
        add_shadow_rays(card);
        if (card.lines.size() > most_lines) {
            const std::size_t more = card.lines.size() - most_lines;
            card.lines.resize(most_lines);
            card.lines.push_back({"and " + std::to_string(more) + " more", State::follows});
        }
        measure(card);
        cards.push_back(std::move(card));
    }

    State state_of(std::size_t ray) const {
        State worst = State::right;
        for (const Finding* finding : findings_[ray]) {
            const State state = finding->problem == Problem::extra ? State::extra
                                : finding->follows_from            ? State::follows
                                                                   : State::differs;
            worst = std::max(worst, state);
        }
        return worst;
    }

    void describe(Card& card, std::size_t ray) const {
        for (const Finding* finding : findings_[ray]) {
            if (finding->problem == Problem::extra) {
                card.lines.push_back(
                    {fitted_text(harmless(finding->reason), font, widest_text), State::extra});
                continue;
            }
            const State state = finding->follows_from ? State::follows : State::differs;
            if (finding->problem == Problem::missing) {
                const std::string to =
                    finding->light.empty()
                        ? ""
                        : " to " + fitted_text(harmless(finding->light), font, 100);
                card.lines.push_back(
                    {"lacks its " + std::string(word_of(finding->kind)) + " ray" + to, state});
                continue;
            }
            card.lines.push_back(
                {std::string(text_of(finding->field).name) + " is " + short_value(finding->found),
                 state});
            card.lines.push_back({"    must be " + short_value(finding->expected), state});
        }
    }

    /// A line for each, and for what is wrong with it.
    void add_shadow_rays(Card& card) const {
        for (const std::size_t ray :
             card.found == none ? std::vector<std::size_t>() : children_[card.found]) {
            const TreeRay<double>& of = tree_.rays[ray];
            if (!of.shadow) {
                continue;
            }
            const State state = state_of(ray);
            card.state = std::max(card.state, state);
            card.lines.push_back(
                {"to " + fitted_text(harmless(of.shadow->light), font, 100) + ": " + fate_of(of),
                 state});
            describe(card, ray);
        }
    }

    void add_branches(std::size_t at) {
        for (const RayKind kind : {RayKind::reflected, RayKind::refracted}) {
            const Card card = cards[at];
            std::size_t due = none;
            if (card.due != none) {
                due = corresponding(truth_, true_children_[card.due], kind, "").value_or(none);
            }
            bool any = false;
            for (const std::size_t ray :
                 card.found == none ? std::vector<std::size_t>() : children_[card.found]) {
                if (tree_.rays[ray].kind == kind) {
                    add(at, ray, any ? none : due);
                    any = true;
                }
            }
            if (!any && due != none) {
                add(at, none, due);
            }
        }
    }

    static void measure(Card& card) {
        card.width = text_width(card.title, font) * 1.1 + mark_size + 3 * margin +
                     text_width(look_of(card.state).word, font) + margin;
        for (const Line& line : card.lines) {
            card.width = std::max(card.width, text_width(line.text, font) + 4 * margin);
        }
        card.height = head + line_height * static_cast<double>(card.lines.size()) +
                      (card.lines.empty() ? 0 : margin);
    }

    const RayTree<double>& tree_;
    const RayTree<double>& truth_;
    const Report& report_;
    const std::vector<std::vector<std::size_t>>& children_;
    std::vector<std::vector<std::size_t>> true_children_;
    std::vector<std::vector<const Finding*>> findings_;
};

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
        : cards_(cards.cards), left_out_(cards.left_out), report_(report), truth_(truth) {}

    std::string draw() {
        std::vector<LayoutNode> nodes;
        for (const Card& card : cards_) {
            nodes.push_back({card.parent, card.width, card.height});
        }
        layout_ = lay_out(nodes, {24, 34});
        const std::string title = "Pixel (" + std::to_string(truth_.pixel_i) + ", " +
                                  std::to_string(truth_.pixel_j) + ") of " + truth_.scene_name +
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

    const std::vector<Card>& cards_;
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
