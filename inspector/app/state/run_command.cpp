#include <algorithm>

#include "state/commands.h"

namespace raytree::inspector {

const Command* find_command(std::string_view id) {
    const auto found = std::ranges::find(commands(), id, &Command::id);
    return found == commands().end() ? nullptr : &*found;
}

void run_command(State& state, std::string_view id, std::string_view argument) {
    const Command* const command = find_command(id);
    if (!command) {
        throw InputError("", std::string(id), "there is no such command");
    }
    if (!command->possible || command->possible(state)) {
        command->run(state, argument);
    }
}

bool run_line(State& state, std::string_view line) {
    constexpr std::string_view blanks = " \t\r";
    const std::size_t begin = line.find_first_not_of(blanks);
    if (begin == std::string_view::npos || line[begin] == '#') {
        return true;
    }
    line = line.substr(begin, line.find_last_not_of(blanks) + 1 - begin);
    const std::size_t end = std::min(line.find_first_of(blanks), line.size());
    const std::size_t argument = line.find_first_not_of(blanks, end);
    const std::string_view id = line.substr(0, end);
    const std::string_view words =
        argument == std::string_view::npos ? std::string_view() : line.substr(argument);
    const Command* const command = find_command(id);
    if (command && command->argument == Argument::none && !words.empty()) {
        throw InputError("", std::string(id),
                         "takes nothing besides; found '" + std::string(words) + "'");
    }
    const bool wants_file =
        command && (command->argument == Argument::file || command->argument == Argument::new_file);
    if (wants_file && words.empty()) {
        throw InputError("", std::string(id), "must be followed by a file's name");
    }
    const bool possible = !command || !command->possible || command->possible(state);
    run_command(state, id, words);
    return possible;
}

}  // namespace raytree::inspector
