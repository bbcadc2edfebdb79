#include "state/palette.h"

#include <cmath>

#include "tree/explain.h"

namespace raytree::inspector {

Ink mixed(Ink a, Ink b, double share) {
    const auto mix = [share](std::uint8_t x, std::uint8_t y) {
        return static_cast<std::uint8_t>(std::lround(x + share * (y - x)));
    };
    Ink result;
    result.r = mix(a.r, b.r);
    result.g = mix(a.g, b.g);
    result.b = mix(a.b, b.b);
    return result;
}

Ink letters_in(Ink line, const Palette& palette) { return mixed(line, palette.text, 0.4); }

RayLook look_of(const TreeRay<double>& ray) {
    switch (ray.kind) {
        case RayKind::primary:
            return RayLook::primary;
        case RayKind::reflected:
            return RayLook::reflected;
        case RayKind::refracted:
            return RayLook::refracted;
        case RayKind::shadow:
            break;
    }
    return reaches_light(ray) ? RayLook::lit : RayLook::blocked;
}

const LookText& text_of(RayLook look) {
    static constexpr std::array<LookText, look_count> texts = {{
        {"primary", "primary ray, from the eye"},
        {"reflected", "reflected ray"},
        {"refracted", "refracted ray"},
        {"shadow", "shadow ray that reaches the light"},
        {"shadow, blocked", "shadow ray that is blocked"},
    }};
    return texts[static_cast<std::size_t>(look)];
}

const Palette& palette_of(Theme theme) {
    static constexpr Palette light = {
        Ink(0xEEF1F5), Ink(0xFFFFFF),
        Ink(0x1F2933), Ink(0x53606D),
        Ink(0xD3DAE2), Ink(0x2A68AA),
        Ink(0xFDFDFE), Ink(0xDFE5EC),
        Ink(0x64717E), Ink(0x2B3440),
        Ink(0xE8B100), Ink(0xD6336C),
        0.85,          {Ink(0x2B3440), Ink(0xE07B00), Ink(0x0B84C6), Ink(0xB59A1E), Ink(0x9B2226)}};
    static constexpr Palette dark = {
        Ink(0x1B2129), Ink(0x12171D),
        Ink(0xE3E8EE), Ink(0x98A4B1),
        Ink(0x323C48), Ink(0x5B9BE0),
        Ink(0x242C36), Ink(0x0F1318),
        Ink(0xA9B6C4), Ink(0xDCE4EC),
        Ink(0xFFD54A), Ink(0xFF5C98),
        0.5,           {Ink(0xE8EEF5), Ink(0xFF9F38), Ink(0x45B5F5), Ink(0xE6D15C), Ink(0xF0626A)}};
    return theme == Theme::light ? light : dark;
}

}  // namespace raytree::inspector
