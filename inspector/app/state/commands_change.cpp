#include <algorithm>

#include "state/command_groups.h"

namespace raytree::inspector {
namespace {

template <SidePane pane> void switch_side(State& state, std::string_view) {
    state.show_side(state.side_pane() == pane ? SidePane::none : pane);
}
template <SidePane pane> bool side_is(const State& state) { return state.side_pane() == pane; }

/// Where the place ends in "/materials/tinted glass/kd 0.5": names may have blanks in them.
std::size_t end_of_place(const Scene& scene, std::string_view argument) {
    for (auto at = argument.find(' '); at != argument.npos; at = argument.find(' ', at + 1)) {
        if (!text_of(scene, std::string(argument.substr(0, at))).empty()) {
            return at;
        }
    }
    return std::min(argument.find(' '), argument.size());
}

/// "/settings/max_depth 3": a place and what is typed there.
template <Pick how> void set(State& state, std::string_view argument) {
    const std::size_t blank = end_of_place(state.document()->scene(), argument);
    const std::size_t value = std::min(argument.find_first_not_of(' ', blank), argument.size());
    if (value == argument.size()) {
        throw InputError("", "change.set",
                         "found '" + std::string(argument) +
                             "', must be a place and a value, such as /settings/max_depth 3");
    }
    state.change(std::string(argument.substr(0, blank)), argument.substr(value), how);
}
void let_go(State& state, std::string_view) { state.let_go(); }

void undo(State& state, std::string_view) { state.undo(); }
void redo(State& state, std::string_view) { state.redo(); }
void reset(State& state, std::string_view) { state.reset_values(); }
void dismiss(State& state, std::string_view) { state.dismiss_cut(); }

bool can_undo(const State& state) { return has_scene(state) && state.edits().can_undo(); }
bool can_redo(const State& state) { return has_scene(state) && state.edits().can_redo(); }
bool can_reset(const State& state) { return has_scene(state) && state.edits().can_reset(); }
bool has_cut(const State& state) { return state.has_cut(); }

constexpr Command table[] = {
    {"pane.change", "Change", "Change the scene", "E",
     "Shows or hides what of the scene can be changed while its tree follows.", none,
     switch_side<SidePane::change>, has_scene, side_is<SidePane::change>, "Change"},
    {"change.set", "", "Change a value", "",
     "Changes a value of the scene: its place in a scene file, then the value.", Argument::words,
     set<Pick::apart>, has_scene},
    {"change.drag", "", "Drag a value", "",
     "Changes a value as a slider does: what follows of the same value is the same change.",
     Argument::words, set<Pick::on_the_way>, has_scene},
    {"change.let_go", "", "Let go", "", "Ends a slider's change.", none, let_go, has_scene},
    {"change.undo",
     "Change",
     "Undo",
     "Ctrl+Z",
     "Takes the last change of the scene back.",
     none,
     undo,
     can_undo,
     nullptr,
     {},
     true},
    {"change.redo", "Change", "Redo", "Ctrl+Shift+Z Ctrl+Y",
     "Makes the change again that was taken back.", none, redo, can_redo},
    {"change.reset", "Change", "Reset", "Ctrl+Alt+Z",
     "Gives all values back that the scene was opened with.", none, reset, can_reset},
    {"change.dismiss",
     "Change",
     "Let go of cut branches",
     "Esc",
     "Hides the branches that the last change has cut off.",
     none,
     dismiss,
     has_cut,
     nullptr,
     {},
     true},
};

}  // namespace

std::span<const Command> change_commands() { return table; }

}  // namespace raytree::inspector
