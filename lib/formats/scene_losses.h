#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

/// What the writers of formats by others share: placing shapes in the world, and sentences about
/// what such a format cannot say of a scene.
namespace raytree {

/// An object's transform, or the identity: `p' = linear p + shift`.
struct Placement {
    std::array<Point, 3> rows{Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)};  ///< of `linear`
    Point shift{0, 0, 0};

    static Placement of(const Object& object);
    Point vector(const Point& v) const {
        return {inner(rows[0], v), inner(rows[1], v), inner(rows[2], v)};
    }
    Point point(const Point& p) const { return vector(p) + shift; }
    /// By the inverse transpose; not of unit length.
    Point normal(const Point& n) const;
    /// The factor of a map that keeps angles, to about 12 digits; 0 of any other.
    double uniform_scale() const;
    bool mirrors() const { return inner(rows[0], outer(rows[1], rows[2])) < 0; }
};

/// `first`, then `second`.
Placement chained(const Placement& first, const Placement& second);

/// Adds one sentence that lists the settings that differ from those that the format implies.
void add_lost_settings(const Settings& settings, const Settings& implied, std::string_view format,
                       std::vector<std::string>& lost);

/// Whether the three channels are the same number.
inline bool is_one_number(const Colour& c) { return c.r == c.g && c.g == c.b; }

/// The one number for all channels: the colour's, or its mean, with a sentence, where they differ.
double only_grey(const Colour& colour, const std::string& whose, std::vector<std::string>& lost);

/// Appends the numbers, each after a space.
void append_numbers(std::string& out, std::initializer_list<double> numbers);
void append_point(std::string& out, const Point& p);
void append_colour(std::string& out, const Colour& c);

}  // namespace raytree
