#include "formats/scene_losses.h"

#include "formats/json_text.h"
#include "formats/scene_words.h"

namespace raytree {

Placement Placement::of(const Object& object) {
    Placement placement;
    if (object.transform) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& row = (*object.transform)[k];
            placement.rows[k] = {row[0], row[1], row[2]};
            placement.shift[static_cast<int>(k)] = row[3];
        }
    }
    return placement;
}

Point Placement::normal(const Point& n) const {
    // The cofactor matrix is the inverse transpose times the determinant.
    const Point cofactor(inner(outer(rows[1], rows[2]), n), inner(outer(rows[2], rows[0]), n),
                         inner(outer(rows[0], rows[1]), n));
    return mirrors() ? -cofactor : cofactor;
}

double Placement::uniform_scale() const {
    constexpr double rounding = 1e-12;
    const double square = inner(rows[0], rows[0]);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = i; j < 3; ++j) {
            const double expected = i == j ? square : 0;
            if (abs(inner(rows[i], rows[j]) - expected) > rounding * square) {
                return 0;
            }
        }
    }
    // Exact where there is no rotation, as in most scenes.
    const bool straight = rows[0].y == 0 && rows[0].z == 0;
    return straight ? abs(rows[0].x) : sqrt(square);
}

Placement chained(const Placement& first, const Placement& second) {
    Placement both;
    for (std::size_t i = 0; i < 3; ++i) {
        const Point& row = second.rows[i];
        both.rows[i] = row.x * first.rows[0] + row.y * first.rows[1] + row.z * first.rows[2];
    }
    both.shift = second.point(first.shift);
    return both;
}

void add_lost_settings(const Settings& settings, const Settings& implied, std::string_view format,
                       std::vector<std::string>& lost) {
    std::string names;
    const auto compare = [&](bool same, std::string_view name) {
        if (!same) {
            names += (names.empty() ? "" : ", ") + std::string(name);
        }
    };
    compare(settings.max_depth == implied.max_depth, "max_depth");
    compare(settings.min_weight == implied.min_weight, "min_weight");
    compare(settings.max_distance == implied.max_distance, "max_distance");
    compare(settings.attenuation == implied.attenuation, "attenuation");
    compare(settings.specular_model == implied.specular_model, "specular_model");
    compare(settings.shadows == implied.shadows, "shadows");
    compare(settings.total_internal_reflection == implied.total_internal_reflection,
            "total_internal_reflection");
    compare(settings.pixel_sample == implied.pixel_sample, "pixel_sample");
    compare(settings.secondary_background == implied.secondary_background, "secondary_background");
    compare(settings.quantize == implied.quantize, "quantize");
    compare(settings.ray_budget == implied.ray_budget, "ray_budget");
    if (!names.empty()) {
        lost.push_back("The " + std::string(format) +
                       " has settings of its own; lost are the scene's " + names + ".");
    }
}

double only_grey(const Colour& colour, const std::string& whose, std::vector<std::string>& lost) {
    if (is_one_number(colour)) {
        return colour.r;
    }
    lost.push_back(whose + " is one number there; the mean of its channels is written.");
    return (colour.r + colour.g + colour.b) / 3;
}

void append_numbers(std::string& out, std::initializer_list<double> numbers) {
    for (const double number : numbers) {
        out += ' ';
        out += json_number(number + 0.0);  // which makes -0 a plain 0
    }
}

void append_point(std::string& out, const Point& p) { append_numbers(out, {p.x, p.y, p.z}); }
void append_colour(std::string& out, const Colour& c) { append_numbers(out, {c.r, c.g, c.b}); }

}  // namespace raytree
