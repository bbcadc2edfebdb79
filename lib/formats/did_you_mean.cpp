#include "formats/did_you_mean.h"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace raytree {
namespace {

/// Longer names are not compared: the table of distances grows with the product of the lengths.
constexpr std::size_t kLongest = 100;

bool same_letter(char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) ==
           std::tolower(static_cast<unsigned char>(b));
}

/// Insertions, deletions, substitutions and swaps of neighbours that lead from `a` to `b`.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    const std::size_t width = b.size() + 1;
    std::vector<std::size_t> table((a.size() + 1) * width);
    const auto at = [&](std::size_t i, std::size_t j) -> std::size_t& {
        return table[i * width + j];
    };
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                at(i, j) = i + j;
                continue;
            }
            const std::size_t substituted =
                at(i - 1, j - 1) + (same_letter(a[i - 1], b[j - 1]) ? 0 : 1);
            at(i, j) = std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, substituted});
            if (i > 1 && j > 1 && same_letter(a[i - 1], b[j - 2]) &&
                same_letter(a[i - 2], b[j - 1])) {
                at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
            }
        }
    }
    return at(a.size(), b.size());
}

}  // namespace

std::string_view probably_meant(std::string_view found, std::span<const std::string_view> names) {
    std::string_view best;
    if (found.empty() || found.size() > kLongest) {
        return best;
    }
    std::size_t least = std::max<std::size_t>(2, found.size() / 3) + 1;
    for (const std::string_view name : names) {
        if (name.size() > kLongest) {
            continue;
        }
        const std::size_t distance = edit_distance(found, name);
        // As many edits as letters would turn anything into anything.
        if (distance < least && distance < std::max(found.size(), name.size())) {
            least = distance;
            best = name;
        }
    }
    return best;
}

std::string did_you_mean(std::string_view found, std::span<const std::string_view> names) {
    const std::string_view meant = probably_meant(found, names);
    return meant.empty() ? "" : "; did you mean \"" + std::string(meant) + "\"?";
}

}  // namespace raytree
