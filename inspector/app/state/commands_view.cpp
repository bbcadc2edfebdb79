#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "state/command_groups.h"

namespace raytree::inspector {
namespace {

template <ShapeStyle style> void draw_shapes(State& state, std::string_view) {
    state.change_look([](Look& look) { look.shapes = style; });
}
template <ShapeStyle style> bool shapes_are(const State& state) {
    return state.look().shapes == style;
}

template <RayKind kind> void switch_kind(State& state, std::string_view) {
    state.change_look([](Look& look) {
        const RayGroup group = group_of(kind);
        look.filter.set(group,
                        look.filter.of(group) == Shown::hidden ? Shown::full : Shown::hidden);
    });
}
template <RayKind kind> bool kind_is_shown(const State& state) {
    return state.look().filter.of(group_of(kind)) != Shown::hidden;
}

template <bool Look::*field> void flip(State& state, std::string_view) {
    state.change_look([](Look& look) { look.*field = !(look.*field); });
}
template <bool Look::*field> bool is_on(const State& state) { return state.look().*field; }

template <Neighbours which> bool neighbours_are(const State& state) {
    return state.look().neighbours == which;
}
template <Neighbours which> void show_neighbours(State& state, std::string_view) {
    const bool shown = neighbours_are<which>(state);
    state.change_look([&](Look& look) { look.neighbours = shown ? Neighbours::none : which; });
}

/// Six numbers, divided by blanks or commas.
void look_from(State& state, std::string_view words) {
    std::array<double, 6> numbers{};
    const char *at = words.data(), *const end = at + words.size();
    const auto skip = [&] {
        at = std::find_if(at, end, [](char c) { return c != ' ' && c != ','; });
    };
    for (double& number : numbers) {
        skip();
        const auto read = std::from_chars(at, end, number);
        if (read.ec != std::errc() || !std::isfinite(number)) {
            at = nullptr;
            break;
        }
        at = read.ptr;
    }
    if (at) {
        skip();
    }
    const auto& [x, y, z, u, v, w] = numbers;
    if (at != end || (x == u && y == v && z == w)) {
        throw InputError("", "view.from",
                         "found '" + std::string(words) +
                             "', must be six numbers: the place to look from, and another one to "
                             "look at");
    }
    state.look_from({{x, y, z}, {u, v, w}, state.document()->scene().camera.up});
}

bool has_hit(const State& state) { return state.tree() && state.selected()->hit; }

void switch_theme(State& state, std::string_view) {
    state.change_look(
        [](Look& look) { look.theme = look.theme == Theme::light ? Theme::dark : Theme::light; });
}
bool is_dark(const State& state) { return state.look().theme == Theme::dark; }

constexpr Command table[] = {
    {"view.camera", "View", "Through the camera", "1",
     "Looks through the camera, as the picture does.", none, ask<Request::through_camera>,
     has_scene, nullptr, "Camera"},
    {"view.side", "View", "From the side", "2",
     "Looks from the side at the eye, the picture and the rays.", none, ask<Request::from_side>,
     has_scene, nullptr, "Side"},
    {"view.hit", "View", "Onto the selected hit", "3",
     "Looks straight onto the plane of incidence at the selected ray's hit: angles are as they "
     "are.",
     none, ask<Request::onto_hit>, has_hit},
    {"view.from", "", "Look from a place", "",
     "Looks from X,Y,Z at X,Y,Z, with the camera's upward direction.", Argument::words, look_from,
     has_scene},
    {"view.fit_tree", "View", "Fit the tree", "F", "Moves so that the whole tree fills the view.",
     none, ask<Request::fit_tree>, has_tree, nullptr, "Fit tree"},
    {"view.fit_selection", "View", "Fit the selection", "R",
     "Moves so that the selected ray and its hit, or the selected object or light, fill the view.",
     none, ask<Request::fit_selection>, has_scene, nullptr, "Fit"},
    {"view.closer",
     "View",
     "Closer",
     "Alt++ Alt+=",
     "Moves the 3D view nearer to what is in its middle.",
     none,
     ask<Request::view_closer>,
     has_scene,
     nullptr,
     {},
     true},
    {"view.further", "View", "Further away", "Alt+-", "Moves the 3D view away.", none,
     ask<Request::view_further>, has_scene},
    {"view.turn_left", "View", "Turn to the left", "Ctrl+Left",
     "Turns the 3D view to the left, as dragging does.", none, ask<Request::turn_left>, has_scene},
    {"view.turn_right", "View", "Turn to the right", "Ctrl+Right",
     "Turns the 3D view to the right.", none, ask<Request::turn_right>, has_scene},
    {"view.turn_up", "View", "Turn upwards", "Ctrl+Up", "Turns the 3D view upwards.", none,
     ask<Request::turn_up>, has_scene},
    {"view.turn_down", "View", "Turn downwards", "Ctrl+Down", "Turns the 3D view downwards.", none,
     ask<Request::turn_down>, has_scene},
    {"shapes.see_through",
     "View",
     "See-through shapes",
     "X",
     "Draws shapes see-through.",
     none,
     draw_shapes<ShapeStyle::see_through>,
     nullptr,
     shapes_are<ShapeStyle::see_through>,
     {},
     true},
    {"shapes.solid", "View", "Solid shapes", "Shift+X", "Draws shapes solid.", none,
     draw_shapes<ShapeStyle::solid>, nullptr, shapes_are<ShapeStyle::solid>},
    {"shapes.wire", "View", "Wire shapes", "W", "Draws shapes as wires.", none,
     draw_shapes<ShapeStyle::wire>, nullptr, shapes_are<ShapeStyle::wire>},
    {"show.shadow", "View", "Shadow rays", "S", "Shows or hides shadow rays in the 3D view.", none,
     switch_kind<RayKind::shadow>, nullptr, kind_is_shown<RayKind::shadow>, "Shadows", true},
    {"show.reflected", "View", "Reflected rays", "Shift+R",
     "Shows or hides reflected rays in the 3D view.", none, switch_kind<RayKind::reflected>,
     nullptr, kind_is_shown<RayKind::reflected>},
    {"show.refracted", "View", "Refracted rays", "Shift+T",
     "Shows or hides refracted rays in the 3D view.", none, switch_kind<RayKind::refracted>,
     nullptr, kind_is_shown<RayKind::refracted>},
    {"show.ghosts", "View", "Rays that were not sent", "G",
     "Shows or hides skipped rays, with their reasons, in the outline and at the selected hit.",
     none, flip<&Look::ghosts>, nullptr, is_on<&Look::ghosts>, "Not sent"},
    {"show.angles", "View", "Angles at the selected hit", "I",
     "Shows or hides the angles at the selected ray's hit, from the normal in degrees.", none,
     flip<&Look::angles>, nullptr, is_on<&Look::angles>},
    {"show.names", "View", "Names in the 3D view", "L",
     "Shows or hides the names of the eye, lights and shapes in the 3D view.", none,
     flip<&Look::names>, nullptr, is_on<&Look::names>},
    {"show.bounds", "View", "Error bounds", "Shift+I",
     "Shows beside each number how far rounding may have moved it, and marks rays that could have "
     "gone either way.",
     none, flip<&Look::bounds>, has_tree, is_on<&Look::bounds>},
    {"neighbours.square",
     "View",
     "Trees of the pixels around",
     "U",
     "Shows the trees of the eight pixels around as thin lines, too; or no longer.",
     none,
     show_neighbours<Neighbours::square>,
     has_tree,
     neighbours_are<Neighbours::square>,
     {},
     true},
    {"neighbours.row", "View", "Trees of a row of pixels", "Shift+U",
     "Shows the trees of four pixels on either side as thin lines, too; or no longer.", none,
     show_neighbours<Neighbours::row>, has_tree, neighbours_are<Neighbours::row>},
    {"neighbours.column", "View", "Trees of a column of pixels", "Ctrl+U",
     "Shows the trees of four pixels above and below as thin lines, too; or no longer.", none,
     show_neighbours<Neighbours::column>, has_tree, neighbours_are<Neighbours::column>},
    {"pane.next",
     "View",
     "Next pane",
     "Ctrl+Tab",
     "Gives the keys to the next pane.",
     none,
     ask<Request::next_pane>,
     nullptr,
     nullptr,
     {},
     true},
    {"pane.previous", "View", "Pane before", "Ctrl+Shift+Tab", "Gives the keys to the pane before.",
     none, ask<Request::previous_pane>},
    {"look.dark", "View", "Dark theme", "T", "Changes between the light and the dark theme.", none,
     switch_theme, nullptr, is_dark, "Dark", true},
};

}  // namespace

std::span<const Command> view_commands() { return table; }

}  // namespace raytree::inspector
