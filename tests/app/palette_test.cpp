// Words can be read in both themes.

#include "state/palette.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace raytree::inspector {
namespace {

/// Relative luminance and contrast as in WCAG 2.1.
double luminance(Ink ink) {
    const auto linear = [](std::uint8_t value) {
        const double v = value / 255.0;
        return v <= 0.03928 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(ink.r) + 0.7152 * linear(ink.g) + 0.0722 * linear(ink.b);
}
double contrast(Ink a, Ink b) {
    const auto [low, high] = std::minmax({luminance(a), luminance(b)});
    return (high + 0.05) / (low + 0.05);
}

TEST_CASE("app: words stand out from what they are written on, in both themes") {
    constexpr double least = 4.5;  // level AA
    CHECK(contrast(Ink(0x000000), Ink(0xFFFFFF)) == doctest::Approx(21));
    for (const Theme theme : {Theme::light, Theme::dark}) {
        const Palette& p = palette_of(theme);
        const Ink chosen_row = mixed(p.panel, p.selection, 0.2),
                  pressed = mixed(p.window, p.accent, 0.2);
        const Ink question = mixed(p.panel, p.accent, 0.07),
                  marked = mixed(p.panel, p.accent, 0.12);
        for (const Ink ground : {p.window, p.panel, chosen_row, pressed, question, marked}) {
            CHECK(contrast(p.text, ground) > 7);
        }
        for (const Ink ground : {p.window, p.panel, chosen_row}) {
            CHECK(contrast(p.dim_text, ground) > least);
        }
        for (const Ink ground : {p.window, p.panel, question, marked}) {
            CHECK(contrast(p.accent, ground) > least);
        }
        for (const Ink look : p.looks) {
            CHECK(contrast(letters_in(look, p), mixed(p.panel, look, 0.08)) > least);
        }
    }
}

TEST_CASE("app: kinds of rays differ in brightness or in their strokes") {
    // Seen without any hue: shadow rays are dashed and others are not; those that can be taken for
    // each other, reflected and refracted, have arrowheads and their kind in the legend's sign.
    // What must differ without it is whether a shadow ray reaches the light.
    for (const Theme theme : {Theme::light, Theme::dark}) {
        const Palette& p = palette_of(theme);
        CHECK(contrast(p[RayLook::lit], p[RayLook::blocked]) > 2);
        for (const RayLook look : {RayLook::reflected, RayLook::refracted, RayLook::lit}) {
            CHECK(contrast(p[RayLook::primary], p[look]) > 1.2);
        }
    }
}

}  // namespace
}  // namespace raytree::inspector
