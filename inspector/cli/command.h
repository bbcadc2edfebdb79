#pragma once

#include <CLI/CLI.hpp>
#include <functional>

/// The subcommands of raytree, each in the file of its name.
namespace raytree::cli {

/// Exit codes: what every program of the project returns.
inline constexpr int done = 0;
inline constexpr int found_wrong = 1;  ///< what was looked at is wrong
inline constexpr int misuse_or_bad_input = 2;

struct Command {
    CLI::App* app;             ///< its part of the command line
    std::function<int()> run;  ///< does the work, once the command line is read; an exit code
};

Command trace_command(CLI::App& program);
Command render_command(CLI::App& program);
Command info_command(CLI::App& program);
Command check_command(CLI::App& program);
Command assign_command(CLI::App& program);
Command convert_command(CLI::App& program);
Command lesson_command(CLI::App& program);
Command study_command(CLI::App& program);
Command bench_command(CLI::App& program);

}  // namespace raytree::cli
