#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "command.h"
#include "formats/did_you_mean.h"
#include "scene_arguments.h"
#include "values.h"

namespace raytree::cli {
namespace {

constexpr const char* examples =
    "Examples:\n"
    "  raytree bench                      all benchmarks, one after the other\n"
    "  raytree bench rays -o results      one, with its JSON and plots in results/\n"
    "  raytree bench rays --quick         small scenes, in seconds";

struct Arguments {
    std::vector<std::string> names;
    std::vector<std::string> passed_on;  ///< options for each program
};

/// The folder bench/ beside this program, where the build puts one program a benchmark.
std::filesystem::path programs_folder() {
    return std::filesystem::read_symlink("/proc/self/exe").parent_path() / "bench";
}

std::vector<std::string> benchmarks() {
    std::vector<std::string> names;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(programs_folder(), none)) {
        if (entry.is_regular_file() && access(entry.path().c_str(), X_OK) == 0) {
            names.push_back(entry.path().filename().string());
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::vector<std::string> chosen(const Arguments& arguments) {
    const std::vector<std::string> built = benchmarks();
    if (built.empty()) {
        throw Misuse("no benchmarks are built; ./dev bench builds and runs them");
    }
    const std::vector<std::string_view> words(built.begin(), built.end());
    for (const std::string& name : arguments.names) {
        one_of("NAME", name, words);
    }
    return arguments.names.empty() ? built : arguments.names;
}

/// Runs the program to its end; its exit code, or misuse_or_bad_input where it was stopped.
int run_program(const std::string& name, const std::vector<std::string>& options) {
    const std::string path = (programs_folder() / name).string();
    std::vector<char*> argv = {const_cast<char*>(path.c_str())};
    for (const std::string& option : options) {
        argv.push_back(const_cast<char*>(option.c_str()));
    }
    argv.push_back(nullptr);
    std::cout.flush();
    const pid_t child = fork();
    if (child == 0) {
        execv(path.c_str(), argv.data());
        _exit(127);
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status)) {
        say("the benchmark " + name + " did not run to its end");
        return misuse_or_bad_input;
    }
    return WEXITSTATUS(status);
}

int bench(const Arguments& arguments) {
    int worst = done;
    const std::vector<std::string> names = chosen(arguments);
    for (const std::string& name : names) {
        std::cout << (name == names.front() ? "" : "\n");
        worst = std::max(worst, run_program(name, arguments.passed_on));
    }
    return worst;
}

}  // namespace

Command bench_command(CLI::App& program) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* const app =
        program.add_subcommand("bench", "Speed, error and memory, beside other programs.");
    app->footer(examples);
    app->add_option("NAME", arguments->names,
                    "which benchmarks to run (default: all that are built)");
    const auto pass = [arguments](const std::string& option) {
        return [arguments, option](const std::string& value) {
            arguments->passed_on.insert(arguments->passed_on.end(), {option, value});
        };
    };
    add_value(*app, "-o,--output", "FOLDER", "write the numbers as JSON, and plots, there",
              pass("-o"));
    auto* const precision =
        add_value(*app, "--precision", "float|double|reference",
                  "the arithmetic of the benchmarks that can choose it\n(default: double)",
                  pass("--precision"));
    precision->check(CLI::IsMember({"float", "double", "reference"}));
    add_value(*app, "--rounds", "N", "how often the rivals take turns (default: 7)",
              pass("--rounds"));
    add_value(*app, "--data", "FOLDER", "scenes by others, those of the SPD in nff/",
              pass("--data"));
    add_value(*app, "--scene", "NAME", "only this scene of each benchmark", pass("--scene"));
    add_value(*app, "--shapes", "N", "only this size of each benchmark", pass("--shapes"));
    app->add_flag_callback(
        "--quick", [arguments] { arguments->passed_on.emplace_back("--quick"); },
        "small scenes and few rounds: shows that all works");
    return {app, [arguments] { return bench(*arguments); }};
}

}  // namespace raytree::cli
