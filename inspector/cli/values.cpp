#include "values.h"
#include "formats/output_file.h"

#include <charconv>
#include <cmath>
#include <filesystem>

#include "formats/did_you_mean.h"
#include "formats/output_file.h"

namespace raytree::cli {
namespace {

template <class Number> std::optional<Number> number(std::string_view text) {
    Number value{};
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    return error == std::errc{} && stop == end ? std::optional(value) : std::nullopt;
}

}  // namespace

Misuse wrong_value(std::string_view option, std::string_view found, std::string_view allowed) {
    return Misuse(std::string(option) + ": found \"" + std::string(found) + "\", must be " +
                  std::string(allowed));
}

std::optional<int> whole_number(std::string_view text) { return number<int>(text); }

std::optional<double> real_number(std::string_view text) {
    const auto value = number<double>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::pair<int, int>> pair_of_numbers(std::string_view text, char separator) {
    const std::size_t middle = text.find(separator);
    if (middle == std::string_view::npos) {
        return std::nullopt;
    }
    const auto first = whole_number(text.substr(0, middle));
    const auto second = whole_number(text.substr(middle + 1));
    return first && second ? std::optional(std::pair(*first, *second)) : std::nullopt;
}

std::size_t one_of(std::string_view option, std::string_view found,
                   std::span<const std::string_view> words) {
    for (std::size_t k = 0; k < words.size(); ++k) {
        if (words[k] == found) {
            return k;
        }
    }
    throw wrong_value(option, found, listed(words) + did_you_mean(found, words));
}

std::string listed(std::span<const std::string_view> words, const char* conjunction) {
    std::string text;
    for (std::size_t k = 0; k < words.size(); ++k) {
        if (k > 0) {
            text += k + 1 < words.size() ? ", " : ' ' + std::string(conjunction) + ' ';
        }
        text += words[k];
    }
    return text;
}

std::string extension_of(const std::string& file) {
    const std::string extension = std::filesystem::path(file).extension().string();
    return CLI::detail::to_lower(extension.empty() ? extension : extension.substr(1));
}

void expect_writable(const std::string& file, const std::string& scene) {
    if (const std::string why = why_not_writable(file, scene); !why.empty()) {
        throw Misuse(file + ": " + why);
    }
}

CLI::Option* add_value(CLI::App& app, const std::string& names, const std::string& value,
                       const std::string& help, std::function<void(const std::string&)> read) {
    return app.add_option_function<std::string>(names, std::move(read), help)
        ->option_text(value)
        ->type_name("value")
        ->take_last();
}

}  // namespace raytree::cli
