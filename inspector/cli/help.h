#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace raytree::cli {

/// Help that begins with the examples, which are the footer of a CLI::App.
class ExamplesFirst : public CLI::Formatter {
  public:
    std::string make_help(const CLI::App* app, std::string name,
                          CLI::AppFormatMode mode) const override;
};

/// One clear message for a command line that CLI11 refused: an unknown option or subcommand above
/// all, with the one that was probably meant.
std::string refusal(const CLI::App& program, const CLI::ParseError& error);

}  // namespace raytree::cli
