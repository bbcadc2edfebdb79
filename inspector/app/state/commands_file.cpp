#include "state/command_groups.h"

namespace raytree::inspector {
namespace {

void open(State& state, std::string_view file) { state.show(open_file(file)); }

void reload(State& state, std::string_view) {
    Opened opened = open_file(state.document()->file());
    if (opened.document->contains(state.pixel())) {
        opened.pixel = state.pixel();
    }
    state.show(opened);
    if (state.message().empty()) {
        state.say("Read again: " + state.document()->file().filename().string());
    }
}

constexpr Command table[] = {
    {"file.open", "File", "Open…", "Ctrl+O",
     "Opens a scene (.json, .nff, .txt, .obj) or a ray tree (raytree/1.0).", Argument::file, open,
     nullptr, nullptr, "Open"},
    {"file.reload", "File", "Read again", "F5 Ctrl+R", "Reads the open file again.", none, reload,
     has_scene, nullptr, "Reload"},
    {"file.quit",
     "File",
     "Quit",
     "Ctrl+Q",
     "Ends the program.",
     none,
     ask<Request::quit>,
     nullptr,
     nullptr,
     {},
     true},
};

}  // namespace

std::span<const Command> file_commands() { return table; }

}  // namespace raytree::inspector
