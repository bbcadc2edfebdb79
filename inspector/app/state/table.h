#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "state/pixel_tree.h"

/// The columns of the ray table, and what they say of a ray.
namespace raytree::inspector {

enum class Column {
    ray,
    met,
    t,
    intensity,
    ended,
    level,
    weight,
    angle,
    eta,
    side,
    material,
    attenuation,
    origin,
    direction,
    point,
    normal
};
inline constexpr std::size_t column_count = 16;

struct ColumnText {
    std::string_view word;   ///< in commands: "intensity"
    std::string_view title;  ///< above the column
    std::string_view help;
    bool number = false;  ///< of the kind that stands to the right
};
const ColumnText& text_of(Column column);
std::optional<Column> column_from(std::string_view word);

/// Which columns the table has, and in which order its rays are.
struct Table {
    std::vector<Column> columns = {Column::ray, Column::met, Column::t, Column::intensity,
                                   Column::ended};  ///< as they stand; the first is always `ray`
    std::optional<Column> sorted_by;                ///< none: as a tree
    bool descending = false;

    bool has(Column column) const;
    /// Shows or leaves out a column other than the first; new ones come in the order of Column.
    void flip(Column column);
    /// Sorts by a column; then the other way round; then as a tree again.
    void turn(Column column);
};

/// The rays in the order of the table, which is sorted: by numbers or by words, triples by their
/// largest channel or their length. Rays without a value come last, equal ones as in the tree.
std::vector<std::size_t> sorted_rays(const PixelTree& tree, Column by, bool descending);

/// What a column says of a ray, in few words and digits, and in full: whole sentences, and numbers
/// with every digit (see `exact`).
std::string text_of(const PixelTree& tree, std::size_t ray, Column column);
std::string exact_text_of(const PixelTree& tree, std::size_t ray, Column column);

/// The rays with their columns' titles, divided by tabs and line feeds; numbers in full precision,
/// each in a cell of its own: a triple takes three ("Intensity r").
std::string copied(const PixelTree& tree, const std::vector<std::size_t>& rays,
                   const std::vector<Column>& columns);

}  // namespace raytree::inspector
