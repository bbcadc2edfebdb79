#include "state/commands.h"

#include <vector>

#include "state/command_groups.h"

namespace raytree::inspector {
namespace {

/// In the order of the menus.
std::span<const Command> (*const groups[])() = {
    file_commands, export_commands, pixel_commands,  overlay_commands,
    ray_commands,  thing_commands,  view_commands,   filter_commands,
    tree_commands, table_commands,  lesson_commands, help_commands,
};

std::vector<Command> joined() {
    std::vector<Command> all;
    for (const auto group : groups) {
        const std::span<const Command> commands = group();
        all.insert(all.end(), commands.begin(), commands.end());
    }
    return all;
}

}  // namespace

std::span<const Command> commands() {
    static const std::vector<Command> all = joined();
    return all;
}

}  // namespace raytree::inspector
