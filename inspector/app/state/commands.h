#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "state/state.h"

/// All that a user can do, in one table: menus, toolbar, keys, the cheat sheet and tests read it.
namespace raytree::inspector {

/// What a command has to be told besides.
enum class Argument {
    none,
    file,      ///< a scene or a tree; the window asks for it
    new_file,  ///< to be written; the window asks for it
    pixel,     ///< I,J
    ray,       ///< a ray's number
    words,     ///< what the command's help says
    optional   ///< the same, and may be left out
};

struct Command {
    std::string_view id;     ///< "ray.next"; for scripts and tests
    std::string_view menu;   ///< "Ray"; empty: in no menu
    std::string_view title;  ///< "Next ray"
    std::string_view keys;   ///< as Qt writes them, in the order of preference, divided by blanks
    std::string_view help;   ///< one sentence
    Argument argument = Argument::none;
    /// The effect. Throws InputError, the state being as before.
    void (*run)(State&, std::string_view argument) = nullptr;
    bool (*possible)(const State&) = nullptr;  ///< null: always
    bool (*on)(const State&) = nullptr;        ///< of a switch: whether it is on; null: no switch
    std::string_view toolbar = {};             ///< its short title there; empty: not there
    bool rule_before = false;                  ///< whether a rule stands above it in its menu
    std::string_view suffixes = {};            ///< of a new file, the usual one first
};

std::span<const Command> commands();

/// Null where there is none.
const Command* find_command(std::string_view id);

/// Runs a command by its id; does nothing where it is not possible just now. Throws InputError for
/// an unknown id or a bad argument.
void run_command(State& state, std::string_view id, std::string_view argument = {});

/// A line of a script: a command's id and, after a blank, its argument. Empty lines and those that
/// begin with # do nothing. False where the command is not possible just now: nobody sees a key
/// that does nothing here. Throws InputError as run_command does, and for an argument too many or
/// a file's name too few.
bool run_line(State& state, std::string_view line);

}  // namespace raytree::inspector
