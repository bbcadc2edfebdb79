#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "tree/ray_tree.h"

/// The colours of the program, the same in every view. Nothing is told by them alone.
namespace raytree::inspector {

enum class Theme { light, dark };

struct Ink {
    std::uint8_t r = 0, g = 0, b = 0;
    constexpr Ink() = default;
    constexpr explicit Ink(std::uint32_t rrggbb)
        : r(static_cast<std::uint8_t>(rrggbb >> 16)),
          g(static_cast<std::uint8_t>(rrggbb >> 8)),
          b(static_cast<std::uint8_t>(rrggbb)) {}
    friend constexpr bool operator==(const Ink&, const Ink&) = default;
};

/// `share` of `b`, the rest of `a`.
Ink mixed(Ink a, Ink b, double share);

/// What a ray is drawn as: its kind, and of a shadow ray whether light arrives.
enum class RayLook { primary, reflected, refracted, lit, blocked };
inline constexpr std::size_t look_count = 5;

RayLook look_of(const TreeRay<double>& ray);

struct LookText {
    std::string_view name;       ///< "reflected"
    std::string_view explained;  ///< "shadow ray that reaches the light"
};
const LookText& text_of(RayLook look);

struct Palette {
    Ink window, panel, text, dim_text, rule;  ///< of the window around the views
    Ink accent;                               ///< of what is chosen in lists and toolbars
    Ink space_top, space_bottom;              ///< behind the 3D view
    Ink shape_line, camera, light;            ///< of things in it
    Ink selection;
    double shape_strength;  ///< how firm see-through shapes are
    std::array<Ink, look_count> looks;

    const Ink& operator[](RayLook look) const { return looks[static_cast<std::size_t>(look)]; }
};
const Palette& palette_of(Theme theme);

/// The colour of a line, strong enough for words.
Ink letters_in(Ink line, const Palette& palette);

}  // namespace raytree::inspector
