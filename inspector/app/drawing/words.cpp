#include "drawing/words.h"

#include <algorithm>
#include <cmath>

namespace raytree::inspector {
namespace {

constexpr double off = 12;  // from a mark

/// Beside the mark, the best first.
std::vector<WordBox> beside(const WordWish& wish) {
    const double w = wish.width, h = wish.height;
    constexpr double aslant = 0.7 * off;
    return {{wish.x + off, wish.y - h / 2, w, h},
            {wish.x - off - w, wish.y - h / 2, w, h},
            {wish.x - w / 2, wish.y - off - h, w, h},
            {wish.x - w / 2, wish.y + off, w, h},
            {wish.x + aslant, wish.y - aslant - h, w, h},
            {wish.x + aslant, wish.y + aslant, w, h},
            {wish.x - aslant - w, wish.y - aslant - h, w, h},
            {wish.x - aslant - w, wish.y + aslant, w, h}};
}

/// Along the way outwards, and a little to its sides.
std::vector<WordBox> outwards(const WordWish& wish) {
    double dx = (*wish.out)[0] - wish.x, dy = (*wish.out)[1] - wish.y;
    const double length = std::hypot(dx, dy);
    dx = length > 1e-6 ? dx / length : 0;
    dy = length > 1e-6 ? dy / length : -1;
    // The words begin beyond the place, whichever way they lie from it.
    constexpr double gap = 4;
    const double half = (std::abs(dx) * wish.width + std::abs(dy) * wish.height) / 2 + gap;
    const double x = wish.x + dx * half, y = wish.y + dy * half;
    std::vector<WordBox> places;
    for (const double along : {0.0, 12.0, 26.0, 42.0, 60.0, 80.0, 110.0, 150.0}) {
        if (along > wish.far) {
            break;
        }
        for (const double aside : {0.0, 1.1, -1.1, 2.2, -2.2}) {
            const double shift = aside * wish.height;
            places.push_back({x + dx * along - dy * shift - wish.width / 2,
                              y + dy * along + dx * shift - wish.height / 2, wish.width,
                              wish.height});
        }
    }
    return places;
}

}  // namespace

bool WordLine::crosses(const WordBox& box) const {
    double first = 0, last = 1;
    const auto keep = [&](double from, double way, double low, double high) {
        if (way == 0) {
            last = from < low || from > high ? -1 : last;
            return;
        }
        const double a = (low - from) / way, b = (high - from) / way;
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    };
    keep(x0, x1 - x0, box.x, box.x + box.width);
    keep(y0, y1 - y0, box.y, box.y + box.height);
    return first <= last;
}

std::optional<WordBox> place_words(const WordWish& wish, const WordBox& room,
                                   const std::vector<WordBox>& taken,
                                   const std::vector<WordLine>& lines) {
    constexpr double each_further = 0.15;  // as bad as covering so much of a line
    std::optional<WordBox> best;
    double least = 1e300, further = 0;
    for (const WordBox& place : wish.out ? outwards(wish) : beside(wish)) {
        const auto crossed =
            std::ranges::count_if(lines, [&](const WordLine& line) { return line.crosses(place); });
        const double badness = static_cast<double>(crossed) + further;
        further += each_further;
        if (badness < least && room.holds(place) &&
            std::ranges::none_of(taken, [&](const WordBox& other) { return other.meets(place); })) {
            best = place;
            least = badness;
        }
    }
    return best;
}

}  // namespace raytree::inspector
