#include "state/command_groups.h"
#include "state/diagram.h"
#include "state/folding.h"

namespace raytree::inspector {
namespace {

template <TreePane::Tab tab> void show_tab(State& state, std::string_view) {
    TreePane pane = state.tree_pane();
    pane.tab = tab;
    state.change_tree_pane(pane);
}
template <TreePane::Tab tab> bool tab_is_shown(const State& state) {
    return state.tree_pane().tab == tab;
}
template <TreePane::Tab tab> bool tab_is_shown_of_tree(const State& state) {
    return state.tree() && state.tree_pane().tab == tab;
}

void make_tall(State& state, std::string_view) {
    TreePane pane = state.tree_pane();
    pane.tall = !pane.tall;
    state.change_tree_pane(pane);
}
bool is_tall(const State& state) { return state.tree_pane().tall; }

using Fold = std::optional<double> (*)(const PixelTree&, double);
template <Fold fold> void change_fold(State& state, std::string_view) {
    TreePane pane = state.tree_pane();
    pane.fold_below = fold(*state.tree(), fold_of(*state.tree(), pane));
    state.change_tree_pane(pane);
}
template <Fold fold> bool can_fold(const State& state) {
    return tab_is_shown_of_tree<TreePane::Tab::diagram>(state) &&
           fold(*state.tree(), fold_of(*state.tree(), state.tree_pane()));
}

constexpr Command table[] = {
    {"tab.outline", "Tree", "Outline", "Alt+1", "Shows the ray tree as an outline with columns.",
     none, show_tab<TreePane::Tab::outline>, nullptr, tab_is_shown<TreePane::Tab::outline>},
    {"tab.diagram", "Tree", "Diagram", "Alt+2",
     "Shows the ray tree as a drawing: each ray a box with its intensity.", none,
     show_tab<TreePane::Tab::diagram>, nullptr, tab_is_shown<TreePane::Tab::diagram>},
    {"tab.counts", "Tree", "Counts", "Alt+3",
     "Shows how many rays there are, were not sent and why, and what that saved.", none,
     show_tab<TreePane::Tab::counts>, nullptr, tab_is_shown<TreePane::Tab::counts>},
    {"tab.explained", "Tree", "Explained", "Alt+5",
     "Shows what the features of the menu Explain say in words and numbers.", none,
     show_tab<TreePane::Tab::explained>, nullptr, tab_is_shown<TreePane::Tab::explained>},
    {"tab.tall",
     "Tree",
     "More room for the tree",
     "Alt+0",
     "Gives most of the window's height to the tree, or takes it back.",
     none,
     make_tall,
     nullptr,
     is_tall,
     {},
     true},
    {"diagram.fit",
     "Tree",
     "Whole diagram",
     "Shift+F",
     "Shows all of the diagram.",
     none,
     ask<Request::fit_diagram>,
     tab_is_shown_of_tree<TreePane::Tab::diagram>,
     nullptr,
     {},
     true},
    {"diagram.closer", "Tree", "Diagram larger", "+ =", "Shows the diagram larger.", none,
     ask<Request::diagram_closer>, tab_is_shown_of_tree<TreePane::Tab::diagram>},
    {"diagram.further", "Tree", "Diagram smaller", "-", "Shows the diagram smaller.", none,
     ask<Request::diagram_further>, tab_is_shown_of_tree<TreePane::Tab::diagram>},
    {"diagram.fold_more", "Tree", "Fold more", "K",
     "Folds more of the diagram's branches that add little to the pixel.", none,
     change_fold<fold_more>, can_fold<fold_more>},
    {"diagram.fold_less", "Tree", "Fold less", "Shift+K",
     "Unfolds the diagram's branches that add more to the pixel than others.", none,
     change_fold<fold_less>, can_fold<fold_less>},
};

}  // namespace

std::span<const Command> tree_commands() { return table; }

}  // namespace raytree::inspector
