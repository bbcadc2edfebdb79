#include "check/overlay_cards.h"

#include <algorithm>
#include <cstdio>

#include "check/align.h"
#include "check/describe.h"
#include "formats/svg.h"
#include "tree/explain.h"

namespace raytree::check {
namespace {

constexpr std::size_t most_cards = 200;
constexpr std::size_t most_lines = 8;  // of a card
constexpr double font = overlay_font, widest_text = 330;

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

}  // namespace

Cards::Cards(const Submission& submission, const RayTree<double>& truth, const Report& report)
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

void Cards::add(std::optional<std::size_t> parent, std::size_t found, std::size_t due) {
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
    cards.push_back(std::move(card));
}

State Cards::state_of(std::size_t ray) const {
    State worst = State::right;
    for (const Finding* finding : findings_[ray]) {
        const State state = finding->problem == Problem::extra ? State::extra
                            : finding->follows_from            ? State::follows
                                                               : State::differs;
        worst = std::max(worst, state);
    }
    return worst;
}

void Cards::describe(Card& card, std::size_t ray) const {
    for (const Finding* finding : findings_[ray]) {
        if (finding->problem == Problem::extra) {
            card.lines.push_back(
                {fitted_text("too many: " + harmless(finding->reason), font, widest_text),
                 State::extra});
            continue;
        }
        const State state = finding->follows_from ? State::follows : State::differs;
        if (finding->problem == Problem::missing) {
            const std::string to = finding->light.empty()
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
void Cards::add_shadow_rays(Card& card) const {
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

void Cards::add_branches(std::size_t at) {
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

}  // namespace raytree::check
