#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "state/state.h"

namespace raytree::inspector {

/// A line of the outline: a ray, or in grey one that was not sent.
struct OutlineRow {
    std::size_t ray = 0;                 ///< itself, or the one that it would have been sent from
    std::optional<std::size_t> skipped;  ///< of a ghost: place in that ray's list
    std::size_t parent = 0;              ///< its row; of the first, itself
    std::size_t place = 0;               ///< among its siblings
};

/// The tree as rows for an outline, ghosts where the rays would have stood. Rows come into being as
/// they are asked for: of a tree of a million rays, few are ever looked at.
class Outline {
  public:
    Outline() = default;
    /// `shown` tells which rows there are; null: all. Without a ray, nor is there what it sent.
    using Shown = std::function<bool(const OutlineRow&)>;
    Outline(std::shared_ptr<const PixelTree> tree, bool ghosts, Shown shown = nullptr);

    bool empty() const { return rows_.empty(); }
    /// Row 0 is the primary ray.
    const OutlineRow& row(std::size_t row) const { return rows_[row].row; }
    /// In the order of computation.
    const std::vector<std::size_t>& children_of(std::size_t row) const;
    /// Of a ray that has no row, that of the nearest one on the way to it.
    std::size_t row_of(std::size_t ray) const;

  private:
    struct Kept {
        OutlineRow row;
        std::optional<std::vector<std::size_t>> children;  ///< once asked for
    };
    void add_child(std::size_t parent, std::vector<std::size_t>& children, std::size_t ray,
                   std::optional<std::size_t> skipped) const;

    std::shared_ptr<const PixelTree> tree_;
    bool ghosts_ = true;
    Shown shown_;
    mutable std::deque<Kept> rows_;
};

/// What the columns say.
struct OutlineTexts {
    std::string ray;  ///< "refracted"; "shadow → key"
    std::string met;  ///< "glass ball, back"; of a shadow ray "the light", or what blocks it
    std::string t;
    std::string intensity;  ///< of a shadow ray: what it adds
    std::string ended;      ///< why it went no further, or was not sent
};
OutlineTexts texts_of(const PixelTree& tree, const OutlineRow& row);

/// The colour of a ray's intensity, or of what a shadow ray adds; none for a ghost, and where it is
/// not given.
std::optional<Rgb<double>> swatch_of(const PixelTree& tree, const OutlineRow& row);

}  // namespace raytree::inspector
