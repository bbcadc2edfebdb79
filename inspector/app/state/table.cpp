#include "state/table.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>
#include <span>
#include <variant>

#include "formats/tree_diagram.h"
#include "state/natural_order.h"
#include "state/numbers.h"
#include "state/outline.h"
#include "state/ray_filter.h"
#include "tree/explain.h"

namespace raytree::inspector {
namespace {

using Node = TreeRay<double>;

constexpr std::array<ColumnText, column_count> texts = {{
    {"ray", "Ray", "the ray's number and kind", false},
    {"met", "Meets", "what the ray meets; a shadow ray: its light, or what blocks it", false},
    {"t", "t", "distance along the ray", true},
    {"intensity", "Intensity", "what comes back along the ray; of a shadow ray, what it adds",
     false},
    {"ended", "Why it ended", "why the ray went no further", false},
    {"level", "Level", "1 for the primary ray", true},
    {"weight", "Share of the pixel", "with which the intensity enters the pixel", false},
    {"angle", "Angle to n", "between ray and normal, in degrees", true},
    {"eta", "η1 → η2", "refractive indices on both sides of the hit", false},
    {"side", "Side", "of the surface that is hit", false},
    {"material", "Material", "of the object that is hit", false},
    {"attenuation", "f of t", "the factor for the distance", true},
    {"origin", "Origin", "where the ray starts", false},
    {"direction", "Direction", "of the ray, unit", false},
    {"point", "Point", "of the hit", false},
    {"normal", "Normal", "at the hit, unit", false},
}};

/// What a cell holds: nothing, words, or one to three numbers.
using Numbers = std::vector<double>;
using Cell = std::variant<std::monostate, std::string, Numbers>;

Numbers numbers(const Vec3<double>& v) { return {v.x, v.y, v.z}; }
Numbers numbers(const Rgb<double>& c) { return {c.r, c.g, c.b}; }

double angle_of(const Node& ray) {
    return std::acos(std::clamp(ray.hit->cos_incident, -1.0, 1.0)) * 180 / std::numbers::pi;
}

Cell t_of(const Node& ray) {
    if (ray.hit) {
        return Numbers{ray.hit->t};
    }
    if (ray.shadow && ray.shadow->blocked_by) {
        return Numbers{ray.shadow->blocked_by->t};
    }
    return ray.shadow && ray.shadow->distance ? Cell(Numbers{*ray.shadow->distance}) : Cell();
}

/// Of a hit alone.
Cell hit_cell(const TreeHit<double>& hit, Column column) {
    switch (column) {
        case Column::eta:
            return hit.interface ? Cell(Numbers{hit.interface->eta1, hit.interface->eta2}) : Cell();
        case Column::side:
            return std::string(hit.side == Side::front ? "front" : "back");
        case Column::material:
            return hit.material;
        case Column::point:
            return numbers(hit.point);
        default:
            return numbers(hit.normal);
    }
}

/// Whether a column's value is known: of a tree that was recorded elsewhere some may be missing.
bool is_given(const PixelTree& tree, const Node& ray, Column column) {
    const auto gives = [&](Field field) { return tree.gives(ray.id, field); };
    switch (column) {
        case Column::t:
            return ray.shadow ? gives(Field::distance) || gives(Field::blocked_by)
                              : gives(Field::t);
        case Column::intensity:
            return tree.gives_intensity(ray.id);
        case Column::met:
            return ray.shadow || gives(Field::hit) || gives(Field::object);
        case Column::weight:
            return gives(Field::weight);
        case Column::angle:
            return gives(Field::cos_incident);
        case Column::eta:
            return gives(Field::eta);
        case Column::side:
            return gives(Field::side);
        case Column::attenuation:
            return gives(Field::attenuation);
        case Column::origin:
            return gives(Field::origin);
        case Column::direction:
            return gives(Field::direction);
        case Column::point:
            return gives(Field::point);
        case Column::normal:
            return gives(Field::normal);
        default:
            return true;
    }
}

Cell cell_of(const PixelTree& tree, const Node& ray, Column column) {
    if (!is_given(tree, ray, column)) {
        return {};
    }
    OutlineRow row;
    row.ray = ray.id;
    switch (column) {
        case Column::ray:
            return number_of(tree, ray.id) + " " + texts_of(tree, row).ray;
        case Column::met:
            return texts_of(tree, row).met;
        case Column::ended:
            return texts_of(tree, row).ended;
        case Column::t:
            return t_of(ray);
        case Column::intensity:
            return numbers(ray.shadow ? ray.diffuse + ray.specular : ray.intensity);
        case Column::level:
            return Numbers{static_cast<double>(ray.level)};
        case Column::weight:
            return ray.shadow ? Cell() : Cell(numbers(ray.weight));
        case Column::attenuation:
            return ray.shadow ? Cell() : Cell(Numbers{ray.attenuation});
        case Column::origin:
            return numbers(ray.origin);
        case Column::direction:
            return numbers(ray.direction);
        case Column::angle:
            return ray.hit ? Cell(Numbers{angle_of(ray)}) : Cell();
        default:
            return ray.hit ? hit_cell(*ray.hit, column) : Cell();
    }
}

/// What the numbers of a column's cells are called, where there are several.
std::span<const std::string_view> parts_of(Column column) {
    static constexpr std::array<std::string_view, 3> channels = {"r", "g", "b"};
    static constexpr std::array<std::string_view, 3> axes = {"x", "y", "z"};
    static constexpr std::array<std::string_view, 2> sides = {"from", "to"};
    switch (column) {
        case Column::intensity:
        case Column::weight:
            return channels;
        case Column::origin:
        case Column::direction:
        case Column::point:
        case Column::normal:
            return axes;
        case Column::eta:
            return sides;
        default:
            return {};
    }
}

/// One number for the order of a column; none where the cell is empty or is words.
std::optional<double> rank_of(const Cell& cell, Column column) {
    const auto* const values = std::get_if<Numbers>(&cell);
    if (!values) {
        return std::nullopt;
    }
    const bool vector = column == Column::point || column == Column::origin;
    return vector ? std::hypot((*values)[0], (*values)[1], (*values)[2])
                  : *std::ranges::max_element(*values);
}

}  // namespace

const ColumnText& text_of(Column column) { return texts[static_cast<std::size_t>(column)]; }

std::optional<Column> column_from(std::string_view word) {
    const auto found = std::ranges::find(texts, word, &ColumnText::word);
    return found == texts.end() ? std::nullopt
                                : std::optional(static_cast<Column>(found - texts.begin()));
}

bool Table::has(Column column) const { return std::ranges::find(columns, column) != columns.end(); }

void Table::flip(Column column) {
    if (column == Column::ray) {
        return;
    }
    if (std::erase(columns, column) == 0) {
        columns.insert(std::ranges::upper_bound(columns, column), column);
    } else if (sorted_by == column) {
        sorted_by.reset();
    }
}

void Table::turn(Column column) {
    if (sorted_by != column) {
        sorted_by = column;
        descending = false;
    } else if (!descending) {
        descending = true;
    } else {
        sorted_by.reset();
        descending = false;
    }
}

std::vector<std::size_t> sorted_rays(const PixelTree& tree, Column by, bool descending) {
    struct Key {
        bool empty;
        double number;
        std::string words;
    };
    std::vector<Key> keys;
    keys.reserve(tree.tree.rays.size());
    for (const Node& ray : tree.tree.rays) {
        if (by == Column::ray) {
            keys.push_back({false, static_cast<double>(ray.id), {}});
            continue;
        }
        const Cell cell = cell_of(tree, ray, by);
        const auto* const words = std::get_if<std::string>(&cell);
        const auto number = rank_of(cell, by);
        keys.push_back({!number && (!words || words->empty()), number.value_or(0),
                        words ? *words : std::string()});
    }
    std::vector<std::size_t> rays(keys.size());
    std::iota(rays.begin(), rays.end(), std::size_t{0});
    std::ranges::stable_sort(rays, [&](std::size_t left, std::size_t right) {
        const Key &a = keys[left], &b = keys[right];
        if (a.empty != b.empty) {
            return b.empty;
        }
        const Key &low = descending ? b : a, &high = descending ? a : b;
        return low.number != high.number ? low.number < high.number
                                         : NaturalOrder()(low.words, high.words);
    });
    return rays;
}

std::string text_of(const PixelTree& tree, std::size_t id, Column column) {
    const Node& ray = tree.tree.rays[id];
    if (!is_given(tree, ray, column)) {
        return column == Column::intensity ? "not given" : "";
    }
    if (column == Column::intensity) {
        return rgb_text(ray.shadow ? ray.diffuse + ray.specular : ray.intensity);
    }
    if (column == Column::weight && !ray.shadow) {
        return rgb_text(ray.weight);
    }
    if (column == Column::angle && ray.hit) {
        return angle_text(ray.hit->cos_incident);
    }
    if (column == Column::ended) {
        return ray.termination ? short_reason(*ray.termination)
                               : texts_of(tree, OutlineRow{id, {}, 0, 0}).ended;
    }
    const Cell cell = cell_of(tree, ray, column);
    if (const auto* const words = std::get_if<std::string>(&cell)) {
        return *words;
    }
    std::string text;
    if (const auto* const values = std::get_if<Numbers>(&cell)) {
        for (const double value : *values) {
            text += (text.empty() ? "" : column == Column::eta ? " → " : "  ") + number_text(value);
        }
    }
    return text;
}

std::string exact_text_of(const PixelTree& tree, std::size_t ray, Column column) {
    const Cell cell = cell_of(tree, tree.tree.rays[ray], column);
    if (const auto* const words = std::get_if<std::string>(&cell)) {
        return *words;
    }
    const auto* const values = std::get_if<Numbers>(&cell);
    return values ? exact(*values) : std::string();
}

std::string copied(const PixelTree& tree, const std::vector<std::size_t>& rays,
                   const std::vector<Column>& columns) {
    std::vector<std::string> cells;
    std::string text;
    const auto end_line = [&] {
        for (std::size_t k = 0; k < cells.size(); ++k) {
            text += (k > 0 ? "\t" : "") + cells[k];
        }
        text += '\n';
        cells.clear();
    };
    for (const Column column : columns) {
        const std::string title(text_of(column).title);
        const auto parts = parts_of(column);
        for (const std::string_view part : parts) {
            cells.push_back(title + " " + std::string(part));
        }
        if (parts.empty()) {
            cells.push_back(title);
        }
    }
    end_line();
    for (const std::size_t ray : rays) {
        for (const Column column : columns) {
            const Cell cell = cell_of(tree, tree.tree.rays[ray], column);
            const auto* const values = std::get_if<Numbers>(&cell);
            const std::size_t width = std::max<std::size_t>(parts_of(column).size(), 1);
            for (std::size_t k = 0; k < width; ++k) {
                cells.push_back(values       ? exact((*values)[k])
                                : width == 1 ? exact_text_of(tree, ray, column)
                                             : std::string());
            }
        }
        end_line();
    }
    return text;
}

}  // namespace raytree::inspector
