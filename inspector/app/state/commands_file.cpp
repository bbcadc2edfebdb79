#include "state/command_groups.h"

namespace raytree::inspector {
namespace {

void open(State& state, std::string_view file) { state.show(open_file(file)); }

void reload(State& state, std::string_view) {
    const std::filesystem::path file = state.opened_file();
    const std::filesystem::path scene = state.document()->file();
    state.renew(open_file(file, file == scene ? std::nullopt : std::optional(scene)));
    if (state.message().empty()) {
        state.say("Read again: " + file.filename().string());
    }
}

void save(State& state, std::string_view) {
    state.own_file() ? state.save_scene_as(*state.own_file())
                     : state.request(Request::save_scene_as);
}
void save_as(State& state, std::string_view file) {
    state.save_scene_as(std::filesystem::path(file));
}
bool has_unsaved(const State& state) { return has_scene(state) && state.edits().unsaved(); }

constexpr Command table[] = {
    {"file.open", "File", "Open…", "Ctrl+O",
     "Opens a scene (.json, .nff, .txt, .obj) or a ray tree (raytree/1.0).", Argument::file, open,
     nullptr, nullptr, "Open"},
    {"file.reload", "File", "Read again", "F5 Ctrl+R", "Reads the open file again.", none, reload,
     has_scene},
    {"file.save",
     "File",
     "Save the scene",
     "Ctrl+S",
     "Writes the changed scene into its file; of what is no .json, asks for a new one.",
     none,
     save,
     has_unsaved,
     nullptr,
     {},
     true},
    {"file.save_as",
     "File",
     "Save the scene as…",
     "Ctrl+Shift+S",
     "Writes the scene, with what was changed, as raytree-scene (.json) or what it can of it as "
     ".nff or .txt.",
     Argument::new_file,
     save_as,
     has_scene,
     nullptr,
     {},
     false,
     "json nff txt"},
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
