#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/check.h"

/// What a drawing of a submission over the truth says of each ray.
namespace raytree::check {

constexpr double overlay_font = 11;

/// What a card says of its ray, from the best to the worst.
enum class State { right, follows, missing, extra, differs };

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

/// The union of both trees, depth first.
class Cards {
  public:
    Cards(const Submission& submission, const RayTree<double>& truth, const Report& report);

    std::vector<Card> cards;
    std::size_t left_out = 0;

  private:
    static constexpr std::size_t none = Card::none;

    void add(std::optional<std::size_t> parent, std::size_t found, std::size_t due);
    State state_of(std::size_t ray) const;
    void describe(Card& card, std::size_t ray) const;
    void add_shadow_rays(Card& card) const;
    void add_branches(std::size_t at);

    const RayTree<double>& tree_;
    const RayTree<double>& truth_;
    const Report& report_;
    const std::vector<std::vector<std::size_t>>& children_;
    std::vector<std::vector<std::size_t>> true_children_;
    std::vector<std::vector<const Finding*>> findings_;
};

}  // namespace raytree::check
