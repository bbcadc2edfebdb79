#include "scene/range_check.h"

#include <array>
#include <charconv>

namespace raytree {

std::string shown_number(double number) {
    std::array<char, 32> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
    return {buffer.data(), end.ptr};
}

std::string quoted(std::string_view name) { return '"' + std::string(name) + '"'; }

void RangeCheck::add(const JsonPlace& place, std::string text) {
    if (mistakes_.size() < kMostMistakes) {
        mistakes_.push_back({"", place.pointer(), std::move(text)});
    } else {
        ++left_out_;
    }
}

bool RangeCheck::require(bool good, const JsonPlace& place, double found, const char* allowed) {
    if (!good) {
        add(place, "found " + shown_number(found) + ", must be " + allowed);
    }
    return good;
}

bool RangeCheck::not_negative(const JsonPlace& place, double found) {
    return require(found >= 0 && isfinite(found), place, found, "a finite number, 0 or more");
}

bool RangeCheck::positive(const JsonPlace& place, double found) {
    return require(found > 0 && isfinite(found), place, found, "a finite number over 0");
}

bool RangeCheck::finite(const JsonPlace& place, const Point& p) {
    const bool good = isfinite(p.x) && isfinite(p.y) && isfinite(p.z);
    if (!good) {
        add(place, "must be three finite numbers");
    }
    return good;
}

bool RangeCheck::direction(const JsonPlace& place, const Point& v) {
    if (!finite(place, v)) {
        return false;
    }
    if (v == Point(0)) {
        add(place, "found a vector of length 0, must have a length");
    }
    return v != Point(0);
}

bool RangeCheck::finite(const JsonPlace& place, const Colour& c) {
    if (!isfinite(c)) {
        add(place, "must be finite numbers");
    }
    return isfinite(c);
}

bool RangeCheck::not_negative(const JsonPlace& place, const Colour& c) {
    return not_negative(place, c.r) && not_negative(place, c.g) && not_negative(place, c.b);
}

bool RangeCheck::attenuation(const JsonPlace& place, const Attenuation& f) {
    const auto is_good = [](double x) { return x >= 0 && isfinite(x); };
    const bool good = is_good(f.a) && is_good(f.b) && is_good(f.c) && !(f == Attenuation{0, 0, 0});
    if (!good) {
        add(place, "found [" + shown_number(f.a) + ", " + shown_number(f.b) + ", " +
                       shown_number(f.c) +
                       "], must be three finite numbers, each 0 or more, not all 0");
    }
    return good;
}

std::vector<Mistake> RangeCheck::take() {
    if (left_out_ > 0) {
        mistakes_.push_back({"", "", "and " + std::to_string(left_out_) + " more mistakes"});
    }
    return std::move(mistakes_);
}

}  // namespace raytree
