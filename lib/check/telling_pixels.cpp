#include "check/telling_pixels.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "check/forge.h"
#include "check/submission.h"
#include "scene/input_error.h"

namespace raytree::check {
namespace {

constexpr double smallest_difference = 1e-6;
constexpr std::size_t most_told_apart = 8;  // mistakes: their pairs are looked at

bool numbers_differ(const Numbers& a, const Numbers& b) {
    for (std::size_t k = 0; k < 3; ++k) {
        const double size = std::max({1e-3, std::abs(a.x[k]), std::abs(b.x[k])});
        if (!(std::abs(a.x[k] - b.x[k]) <= smallest_difference * size)) {
            return true;
        }
    }
    return a.size != b.size;
}

bool differ_in_words(const TreeRay<double>& a, const TreeRay<double>& b) {
    return a.kind != b.kind || a.level != b.level || a.parent != b.parent ||
           a.hit.has_value() != b.hit.has_value() ||
           (a.hit && (a.hit->object != b.hit->object || a.hit->side != b.hit->side)) ||
           (a.shadow && a.shadow->blocked_by.has_value() != b.shadow->blocked_by.has_value());
}

using Tree = std::optional<RayTree<double>>;

/// None where it grows out of range.
Tree tree_by(const Place& place, Laws laws, const MistakeRow* row, PixelPlace at) {
    if (row) {
        row->apply(laws);
    }
    try {
        return forge_tree(place, laws, at.i, at.j);
    } catch (const InputError&) {
        return std::nullopt;
    }
}

bool outcomes_differ(const Tree& a, const Tree& b) {
    return a.has_value() != b.has_value() || (a && check::differ(*a, *b));
}

/// Spread over the picture in a grid, each a little off its cell's middle.
std::vector<PixelPlace> looked_at(const Camera& camera, std::size_t count) {
    const double cells = static_cast<double>(count);
    const double aspect = static_cast<double>(camera.width) / camera.height;
    const int rows = std::clamp(static_cast<int>(std::sqrt(cells / aspect)), 1, camera.height);
    const int columns = std::clamp(static_cast<int>(cells / rows), 1, camera.width);
    std::vector<PixelPlace> places;
    for (int r = 0; r < rows; ++r) {
        for (int c = 0; c < columns; ++c) {
            const double off_column = 0.2 + 0.6 * ((3 * r + 5 * c) % 7) / 6.0;
            const double off_row = 0.2 + 0.6 * ((5 * r + 2 * c) % 5) / 4.0;
            places.push_back({static_cast<int>((c + off_column) * camera.width / columns),
                              static_cast<int>((r + off_row) * camera.height / rows)});
        }
    }
    return places;
}

std::size_t size_of(const std::vector<bool>& set) {
    return static_cast<std::size_t>(std::ranges::count(set, true));
}

void take_away(std::vector<bool>& from, const std::vector<bool>& what) {
    for (std::size_t k = 0; k < from.size(); ++k) {
        from[k] = from[k] && !what[k];
    }
}

/// Takes `most` pixels, each time the one that adds most to what is covered; once all is covered,
/// it is covered anew by others where `again` says so.
template <class Pixel> std::vector<Pixel> greedily(std::vector<Pixel> pixels,
                                                   std::vector<std::vector<bool>> covers,
                                                   std::size_t most, bool again) {
    std::vector<Pixel> chosen;
    std::vector<std::vector<bool>> left = covers;
    bool fresh = true;
    while (chosen.size() < most && !pixels.empty()) {
        std::size_t best = 0, gain = 0;
        for (std::size_t k = 0; k < pixels.size(); ++k) {
            const std::size_t adds = size_of(left[k]);
            if (adds > gain || (adds == gain && gain > 0 && pixels[k].rays < pixels[best].rays)) {
                best = k;
                gain = adds;
            }
        }
        if (gain == 0) {
            if (fresh || !again) {
                break;
            }
            left = covers;
            fresh = true;
            continue;
        }
        fresh = false;
        chosen.push_back(pixels[best]);
        const std::vector<bool> taken = left[best];
        for (std::vector<bool>& each : left) {
            take_away(each, taken);
        }
        const auto at = static_cast<std::ptrdiff_t>(best);
        pixels.erase(pixels.begin() + at);
        covers.erase(covers.begin() + at);
        left.erase(left.begin() + at);
    }
    return chosen;
}

}  // namespace

bool differ(const RayTree<double>& a, const RayTree<double>& b) {
    if (a.rays.size() != b.rays.size()) {
        return true;
    }
    for (std::size_t ray = 0; ray < a.rays.size(); ++ray) {
        if (differ_in_words(a.rays[ray], b.rays[ray])) {
            return true;
        }
        for (std::size_t k = 0; k < field_count; ++k) {
            const Field field = static_cast<Field>(k);
            if (numbers_differ(numbers_of(a, ray, field), numbers_of(b, ray, field))) {
                return true;
            }
        }
    }
    return false;
}

std::vector<TellingPixel> exposing_pixels(const Place& place,
                                          std::span<const MistakeRow* const> mistakes,
                                          const TellingOptions& options) {
    std::vector<TellingPixel> pixels;
    std::vector<std::vector<bool>> covered;
    for (const PixelPlace& at : looked_at(place.scene().camera, options.looked_at)) {
        const Tree truth = tree_by(place, model_laws(), nullptr, at);
        if (!truth || truth->rays.size() > options.most_rays) {
            continue;
        }
        TellingPixel pixel{at, truth->rays.size(), {}};
        std::vector<bool> exposed;
        for (const MistakeRow* row : mistakes) {
            exposed.push_back(outcomes_differ(truth, tree_by(place, model_laws(), row, at)));
            if (exposed.back()) {
                pixel.exposes.push_back(row);
            }
        }
        pixels.push_back(std::move(pixel));
        covered.push_back(std::move(exposed));
    }
    return greedily(std::move(pixels), std::move(covered), options.count, true);
}

TellingApart pixels_that_tell_apart(const Place& place, const Laws& laws,
                                    std::span<const MistakeRow* const> mistakes,
                                    const TellingOptions& options) {
    struct Pixel {
        PixelPlace at;
        std::size_t rays = 0;
    };
    TellingApart result;
    std::vector<Pixel> pixels;
    std::vector<std::vector<bool>> covered;
    for (const PixelPlace& at : looked_at(place.scene().camera, options.looked_at)) {
        const Tree truth = tree_by(place, laws, nullptr, at);
        if (!truth || truth->rays.size() > options.most_rays) {
            continue;
        }
        std::vector<Tree> trees;
        for (const MistakeRow* row : mistakes) {
            trees.push_back(tree_by(place, laws, row, at));
        }
        std::vector<bool> told;
        for (std::size_t a = 0; a < trees.size(); ++a) {
            for (std::size_t b = a + 1; b < trees.size(); ++b) {
                told.push_back(outcomes_differ(trees[a], trees[b]));
            }
        }
        pixels.push_back({at, truth->rays.size()});
        covered.push_back(std::move(told));
    }
    result.pairs =
        mistakes.size() * (mistakes.size() - std::min<std::size_t>(mistakes.size(), 1)) / 2;
    std::vector<bool> any(result.pairs, false);
    for (const auto& each : covered) {
        for (std::size_t k = 0; k < each.size(); ++k) {
            any[k] = any[k] || each[k];
        }
    }
    result.told = static_cast<std::size_t>(std::ranges::count(any, true));
    for (const Pixel& pixel :
         greedily(std::move(pixels), std::move(covered), options.count, false)) {
        result.at.push_back(pixel.at);
    }
    return result;
}

std::vector<std::string> suggestions(const Place& place, const Laws& laws,
                                     const std::vector<std::string>& mistakes,
                                     std::span<const NamedScene> others) {
    std::vector<const MistakeRow*> rows;
    std::string names;
    for (const std::string& id : mistakes) {
        const MistakeRow* const row = find_mistake(id);
        if (row && rows.size() < most_told_apart) {
            rows.push_back(row);
            names += (names.empty() ? "" : ", ") + id;
        }
    }
    if (rows.size() < 2) {
        return {};
    }
    const auto listed = [](const std::vector<PixelPlace>& at) {
        std::string text = at.size() == 1 ? "pixel " : "pixels ";
        for (const PixelPlace& pixel : at) {
            text += (&pixel == &at.front() ? "" : " and ") + std::to_string(pixel.i) + ',' +
                    std::to_string(pixel.j);
        }
        return text;
    };
    std::vector<std::string> sentences;
    TellingApart here = pixels_that_tell_apart(place, laws, rows);
    if (here.told > 0) {
        sentences.push_back("to tell apart " + names + ": " + listed(here.at) + " of this scene" +
                            (here.told == here.pairs ? ""
                                                     : " (" + std::to_string(here.told) + " of " +
                                                           std::to_string(here.pairs) + " pairs)"));
    }
    std::size_t most = here.told;
    for (const NamedScene& other : others) {
        if (most == here.pairs) {
            break;
        }
        const Place there(*other.scene);
        const TellingApart apart = pixels_that_tell_apart(there, laws, rows);
        if (apart.told > most) {
            most = apart.told;
            sentences.push_back("to tell apart " + names + ": " + listed(apart.at) + " of " +
                                other.name + " (" + std::to_string(apart.told) + " of " +
                                std::to_string(apart.pairs) + " pairs)");
        }
    }
    if (sentences.empty()) {
        sentences.push_back("no pixel of this scene" +
                            std::string(others.empty() ? "" : " or of the others") +
                            " tells apart " + names);
    }
    return sentences;
}

}  // namespace raytree::check
