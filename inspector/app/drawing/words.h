#pragma once

#include <array>
#include <optional>
#include <vector>

/// Room for words over the 3D view, in pixels, y down.
namespace raytree::inspector {

struct WordBox {
    double x = 0, y = 0, width = 0, height = 0;

    bool meets(const WordBox& other) const {
        return x < other.x + other.width && other.x < x + width && y < other.y + other.height &&
               other.y < y + height;
    }
    bool holds(const WordBox& other) const {
        return other.x >= x && other.y >= y && other.x + other.width <= x + width &&
               other.y + other.height <= y + height;
    }
};

/// Something thin that words had better not cover.
struct WordLine {
    double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    /// Whether it comes into the box (Liang & Barsky 1984).
    bool crosses(const WordBox& box) const;
};

/// Where words of a size want to stand: beside a mark, or at a place and on towards another.
struct WordWish {
    double x = 0, y = 0;
    std::optional<std::array<double, 2>> out;
    double width = 0, height = 0;
    double far = 150;  ///< how far outwards they may go, pixels
};

/// The best place within the room that is free: one that covers few lines, and is near. None where
/// none is free.
std::optional<WordBox> place_words(const WordWish& wish, const WordBox& room,
                                   const std::vector<WordBox>& taken,
                                   const std::vector<WordLine>& lines = {});

}  // namespace raytree::inspector
