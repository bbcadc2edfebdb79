#include <algorithm>

#include "state/command_groups.h"

namespace raytree::inspector {
namespace {

void with_file(State& state, std::string_view file) {
    state.compare_with(read_recorded(std::filesystem::path(file)));
}
void with_pixel(State& state, std::string_view argument) {
    state.compare_with_pixel(pixel_from(argument));
}
void with_this_pixel(State& state, std::string_view) { state.compare_with_pixel(state.pixel()); }
void with_before(State& state, std::string_view) { state.compare_with_before(); }
void swap(State& state, std::string_view) { state.swap_compared(); }
void end(State& state, std::string_view) { state.end_comparing(); }

bool compares(const State& state) { return state.comparing(); }
bool can_compare_before(const State& state) { return state.can_compare_with_before(); }
bool can_swap(const State& state) { return compares(state); }

const std::vector<ContrastLine>* lines_of(const State& state) {
    return state.tree() && state.tree()->contrast && compares(state)
               ? &state.tree()->contrast->lines
               : nullptr;
}
bool has_lines(const State& state) { return lines_of(state) && !lines_of(state)->empty(); }

/// To the next ray that the list names, the first cause first: from where one has gone before, else
/// from the selected ray, but from the primary ray, which is selected at first, to the beginning.
template <int by> void go(State& state, std::string_view) {
    const std::vector<ContrastLine>& lines = *lines_of(state);
    const auto count = static_cast<std::ptrdiff_t>(lines.size());
    const std::size_t ray = state.selected()->id;
    std::ptrdiff_t here = std::ranges::find(lines, ray, &ContrastLine::ray) - lines.begin();
    if (const auto before = state.difference(); before < lines.size() && lines[before].ray == ray) {
        here = static_cast<std::ptrdiff_t>(before);
    } else if (ray == 0) {
        here = count;
    }
    std::ptrdiff_t next = here == count ? (by > 0 ? 0 : count - 1) : here;
    while (here != count && next >= 0 && next < count &&
           lines[static_cast<std::size_t>(next)].ray == ray) {
        next += by;
    }
    next = (next + count) % count;
    state.go_to_difference(static_cast<std::size_t>(next));
}

template <SidePane pane> void switch_side(State& state, std::string_view) {
    state.show_side(state.side_pane() == pane ? SidePane::none : pane);
}
template <SidePane pane> bool side_is(const State& state) { return state.side_pane() == pane; }

constexpr Command table[] = {
    {"compare.file", "Compare", "With a recorded tree…", "Ctrl+D",
     "Compares the tree with one that a file has recorded (raytree/1.0).", Argument::file,
     with_file, has_scene},
    {"compare.this_pixel", "Compare", "With this pixel", "A",
     "Keeps this pixel's tree: every pixel chosen from now on is compared with it.", none,
     with_this_pixel, has_tree},
    {"compare.pixel", "", "With a pixel", "", "Compares every pixel's tree with that of pixel I,J.",
     Argument::pixel, with_pixel, has_scene},
    {"compare.before", "Compare", "With before the change", "Shift+E",
     "Compares the tree with the one before the last change of the scene.", none, with_before,
     can_compare_before},
    {"compare.swap",
     "Compare",
     "Show the other tree",
     "O",
     "Shows the numbers of the other of the two trees.",
     none,
     swap,
     can_swap,
     nullptr,
     {},
     true},
    {"compare.next", "Compare", "Next difference", "D",
     "Selects the next ray that is different; first those where it begins.", none, go<1>,
     has_lines},
    {"compare.previous", "Compare", "Difference before", "Shift+D",
     "Selects the ray before that is different.", none, go<-1>, has_lines},
    {"compare.end", "Compare", "End comparing", "Shift+A", "Shows the tree alone again.", none, end,
     compares},
    {"pane.compare", "Compare", "Differences", "Shift+C", "Shows or hides the list of differences.",
     none, switch_side<SidePane::compare>, has_scene, side_is<SidePane::compare>, "Compare", true},
};

}  // namespace

std::span<const Command> compare_commands() { return table; }

}  // namespace raytree::inspector
