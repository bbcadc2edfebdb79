#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

/// Values of options: how they are read, and what is said of those that cannot be.
namespace raytree::cli {

/// A command line that cannot be understood; caught in `main` alone.
class Misuse : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// What was found for an option, and what is allowed.
Misuse wrong_value(std::string_view option, std::string_view found, std::string_view allowed);

std::optional<int> whole_number(std::string_view text);
std::optional<double> real_number(std::string_view text);
/// "3,4" for the separator ','.
std::optional<std::pair<int, int>> pair_of_numbers(std::string_view text, char separator);

/// A place among `words`; Misuse, with the word that was probably meant, for anything else.
std::size_t one_of(std::string_view option, std::string_view found,
                   std::span<const std::string_view> words);

/// "png, ppm or pfm"
std::string listed(std::span<const std::string_view> words, const char* conjunction = "or");

/// The file name's extension in lower case and without its dot.
std::string extension_of(const std::string& file);

/// Misuse where nothing could be written to the file, or where it is the scene that is read; said
/// before the work and not after it.
void expect_writable(const std::string& file, const std::string& scene);

/// An option with one value, shown in the help as VALUE, that `read` takes.
CLI::Option* add_value(CLI::App& app, const std::string& names, const std::string& value,
                       const std::string& help, std::function<void(const std::string&)> read);

}  // namespace raytree::cli
