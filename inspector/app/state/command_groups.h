#pragma once

#include "state/commands.h"

/// The table of commands in parts, one for each theme and file; and what their rows share.
namespace raytree::inspector {

inline bool has_scene(const State& state) { return state.document() != nullptr; }
inline bool has_tree(const State& state) { return state.tree() != nullptr; }

inline bool has_light(const State& state) {
    return has_scene(state) && !state.document()->scene().lights.empty();
}

template <Request request> void ask(State& state, std::string_view) { state.request(request); }

inline constexpr Argument none = Argument::none;

// Each group is in commands_NAME.cpp.
std::span<const Command> file_commands();
std::span<const Command> export_commands();
std::span<const Command> pixel_commands();
std::span<const Command> overlay_commands();
std::span<const Command> ray_commands();
std::span<const Command> step_commands();
std::span<const Command> change_commands();
std::span<const Command> compare_commands();
std::span<const Command> view_commands();
std::span<const Command> filter_commands();
std::span<const Command> thing_commands();
std::span<const Command> table_commands();
std::span<const Command> tree_commands();
std::span<const Command> explain_commands();
std::span<const Command> lesson_commands();
std::span<const Command> help_commands();

}  // namespace raytree::inspector
