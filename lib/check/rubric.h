#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "check/check.h"

/// Partial credit: what a teacher gives for each quantity, level and kind of ray.
namespace raytree::check {

/// Points of a quantity at a ray: those of the quantity times the factors of the ray's kind and
/// level. What is right, over all that was compared, scaled to `total`.
struct Rubric {
    double total = 100;
    std::array<double, field_count> quantities;  ///< 1 where nothing is said
    std::array<double, 4> kinds;                 ///< by RayKind
    std::map<int, double> levels;                ///< 1 where nothing is said
    double missing_ray = 1, extra_ray = 1;       ///< taken for each

    Rubric() {
        quantities.fill(1);
        kinds.fill(1);
    }
};

/// Reads raytree-rubric/1.0. Throws InputError with file and place.
Rubric read_rubric(const std::string& text, const std::filesystem::path& file);

struct PointsRow {
    std::string quantity, kind;
    int level = 1;
    std::size_t compared = 0, right = 0;
    double points = 0, of = 0;
};
struct Points {
    double earned = 0, total = 0;
    std::vector<PointsRow> rows;  ///< by quantity, kind, level
};

/// Nothing for what could not be read or compared.
Points points_of(const Report& report, const Rubric& rubric);

}  // namespace raytree::check
