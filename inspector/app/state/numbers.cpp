#include "state/numbers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "tree/explain.h"

namespace raytree::inspector {
namespace {

/// Without the sign of what is rounded to zero.
std::string printed(double value, std::chars_format format, int precision) {
    std::array<char, 400> buffer;
    const auto end = std::to_chars(buffer.begin(), buffer.end(), value, format, precision).ptr;
    const std::string text(buffer.data(), end);
    const bool zero = text.find_first_not_of("-0.") == std::string::npos;
    return zero && text.starts_with('-') ? text.substr(1) : text;
}

constexpr double least_plain = 1e-3, most_plain = 1e6;

bool is_plain(double value) { return value >= least_plain && value < most_plain; }

double largest_of(std::span<const double> values) {
    double largest = 0;
    for (const double value : values) {
        largest = std::max(largest, std::abs(value));
    }
    return largest;
}

/// With as many decimals as give `largest` so many digits.
std::vector<std::string> beneath(double largest, std::span<const double> values, int digits) {
    const int exponent = largest > 0 ? static_cast<int>(std::floor(std::log10(largest))) : 0;
    std::vector<std::string> texts;
    for (const double value : values) {
        if (value == 0) {
            texts.emplace_back("0");
        } else if (is_plain(largest)) {
            // Numbers below 1 keep the places of those above it: they stand in one column.
            const int decimals = std::clamp(digits - 1 - std::max(exponent, 0), 0, 9);
            texts.push_back(printed(value, std::chars_format::fixed, decimals));
        } else {
            texts.push_back(printed(value, std::chars_format::scientific, digits - 4));
        }
    }
    return texts;
}

std::string listed(const Rgb<double>& c, int decimals, const char* between) {
    std::string text;
    for (const double value : channels(c)) {
        const bool plain = std::abs(value) < 1e4;
        text += (text.empty() ? "" : between) +
                (plain ? printed(value, std::chars_format::fixed, decimals) : number_text(value));
    }
    return text;
}

}  // namespace

std::vector<std::string> aligned(std::span<const double> values, int digits) {
    return beneath(largest_of(values), values, digits);
}

std::vector<std::string> aligned_with(const Rgb<double>& sum, const Rgb<double>& part) {
    const double whole = largest_of(channels(sum)), own = largest_of(channels(part));
    return beneath(own < least_plain && is_plain(whole) ? whole : own, channels(part), 6);
}

std::vector<std::string> aligned(const Vec3<double>& v, int digits) {
    return aligned(std::array{v.x, v.y, v.z}, digits);
}

std::vector<std::string> aligned(const Rgb<double>& c, int digits) {
    return aligned(channels(c), digits);
}

std::string rgb_text(const Rgb<double>& c) { return listed(c, 3, "  "); }

std::string brief_rgb_text(const Rgb<double>& c) { return listed(c, 2, " "); }

std::string exact(double value) {
    std::array<char, 32> buffer;
    return {buffer.data(), std::to_chars(buffer.begin(), buffer.end(), value).ptr};
}

std::string exact(std::span<const double> values) {
    std::string text;
    for (const double value : values) {
        text += (text.empty() ? "" : " ") + exact(value);
    }
    return text;
}

std::string grouped(double count) {
    if (!(count < 1e15)) {
        return number_text(count);
    }
    std::string text = printed(count, std::chars_format::fixed, 0);
    for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3) {
        text.insert(static_cast<std::size_t>(at), ",");
    }
    return text;
}

}  // namespace raytree::inspector
