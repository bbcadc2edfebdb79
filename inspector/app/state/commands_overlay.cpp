#include "state/command_groups.h"

namespace raytree::inspector {
namespace {

bool depth_is_shown(const State& state) {
    return state.look().depth_overlay && state.explained().depth;
}

template <Measure measure> void show_overlay(State& state, std::string_view) {
    state.change_look([](Look& look) {
        look.overlay = measure;
        look.depth_overlay = false;
    });
}
template <Measure measure> bool overlay_is(const State& state) {
    return !depth_is_shown(state) && state.look().overlay == measure;
}
void show_no_overlay(State& state, std::string_view) {
    state.change_look([](Look& look) {
        look.overlay.reset();
        look.depth_overlay = false;
    });
}
bool has_no_overlay(const State& state) { return !state.look().overlay && !depth_is_shown(state); }

/// Of the depth picture that is explained, or of one that is begun.
void show_depth(State& state, std::string_view) {
    if (!state.explained().depth) {
        run_command(state, "explain.depth");
    }
    state.change_look([](Look& look) {
        look.overlay.reset();
        look.depth_overlay = true;
    });
}

constexpr Command table[] = {
    {"overlay.none", "Overlay", "None: the picture", "Ctrl+0", "Shows the picture itself.", none,
     show_no_overlay, nullptr, has_no_overlay},
    {"overlay.rays", "Overlay", "Rays", "Ctrl+1", "Shows how many rays each pixel took.", none,
     show_overlay<Measure::rays>, nullptr, overlay_is<Measure::rays>},
    {"overlay.levels", "Overlay", "Levels", "Ctrl+2", "Shows how deep the tree of each pixel is.",
     none, show_overlay<Measure::levels>, nullptr, overlay_is<Measure::levels>},
    {"overlay.tests", "Overlay", "Tests", "Ctrl+3",
     "Shows how often the rays of each pixel were tested against shapes.", none,
     show_overlay<Measure::tests>, nullptr, overlay_is<Measure::tests>},
    {"overlay.time", "Overlay", "Time", "Ctrl+4", "Shows how long each pixel took.", none,
     show_overlay<Measure::nanoseconds>, nullptr, overlay_is<Measure::nanoseconds>},
    {"overlay.ended", "Overlay", "Why it ended", "Ctrl+5",
     "Shows why the weightiest branch of the tree of each pixel ended.", none,
     show_overlay<Measure::ended>, nullptr, overlay_is<Measure::ended>},
    {"overlay.depth", "Overlay", "Depth picture beside shadow rays", "Ctrl+6",
     "Shows where a light's depth picture and its shadow rays differ.", none, show_depth, has_light,
     depth_is_shown},
};

}  // namespace

std::span<const Command> overlay_commands() { return table; }

}  // namespace raytree::inspector
