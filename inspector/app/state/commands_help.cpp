#include "state/command_groups.h"

namespace raytree::inspector {
namespace {

constexpr Command table[] = {
    {"help.keys", "Help", "Keys and commands", "? F1", "Lists every command and its key.", none,
     ask<Request::cheat_sheet>},
};

}  // namespace

std::span<const Command> help_commands() { return table; }

}  // namespace raytree::inspector
