#include "help.h"

#include <vector>

#include "formats/did_you_mean.h"
#include "values.h"

namespace raytree::cli {
namespace {

/// The subcommand that was given, or the program itself.
const CLI::App& innermost(const CLI::App& program) {
    const auto given = program.get_subcommands();
    return given.empty() ? program : *given.front();
}

std::string names_of(const CLI::App& app) {
    std::string name = app.get_name();
    for (const CLI::App* parent = app.get_parent(); parent; parent = parent->get_parent()) {
        name = parent->get_name() + ' ' + name;
    }
    return name;
}

std::string unknown_option(const CLI::App& app, const std::string& found) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            names.push_back("--" + name);
        }
    }
    const std::string bare = found.substr(0, found.find('='));
    const std::vector<std::string_view> views(names.begin(), names.end());
    return "there is no option " + bare + did_you_mean(bare, views);
}

std::vector<std::string> subcommands_of(const CLI::App& program) {
    std::vector<std::string> names;
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
        names.push_back(command->get_name());
    }
    return names;
}

std::string unknown_subcommand(const CLI::App& program, const std::string& found) {
    const std::vector<std::string> names = subcommands_of(program);
    const std::vector<std::string_view> views(names.begin(), names.end());
    const std::string meant = did_you_mean(found, views);
    return "there is no subcommand \"" + found + '"' +
           (meant.empty() ? "; there are " + listed(views, "and") : meant);
}

std::string no_subcommand(const CLI::App& program) {
    const std::vector<std::string> names = subcommands_of(program);
    const std::vector<std::string_view> views(names.begin(), names.end());
    return "say what to do: " + listed(views, "or");
}

std::string complaint(const CLI::App& program, const CLI::ParseError& error) {
    const CLI::App& app = innermost(program);
    // What was not understood explains what is missing, so it comes first.
    for (const std::string& argument : app.remaining()) {
        if (argument.size() > 1 && argument.front() == '-') {
            return unknown_option(app, argument);
        }
        return &app == &program ? unknown_subcommand(program, argument)
                                : "there is nothing to do with \"" + argument + '"';
    }
    if (&app == &program) {
        return no_subcommand(program);
    }
    return error.what();
}

}  // namespace

std::string ExamplesFirst::make_help(const CLI::App* app, std::string name,
                                     CLI::AppFormatMode mode) const {
    const std::string help = make_footer(app) + '\n' + make_description(app) + '\n' +
                             make_usage(app, name) + make_positionals(app) +
                             make_groups(app, mode) + make_subcommands(app, mode);
    return CLI::detail::find_and_replace(help, "\n\n\n", "\n\n");
}

std::string refusal(const CLI::App& program, const CLI::ParseError& error) {
    return complaint(program, error) + " (see " + names_of(innermost(program)) + " --help)";
}

}  // namespace raytree::cli
