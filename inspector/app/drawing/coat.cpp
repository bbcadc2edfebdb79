#include "drawing/coat.h"

#include <algorithm>
#include <cmath>

namespace raytree::inspector {

Coat coat_of(const Material& material) {
    const auto channel = [](double value) {
        return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
    };
    Ink ink;
    ink.r = channel(material.color.r);
    ink.g = channel(material.color.g);
    ink.b = channel(material.color.b);
    const double kt = largest_component(material.kt), kr = largest_component(material.kr);
    const double kd = largest_component(material.kd);
    if (kt > 0) {
        return {mixed(ink, Ink(0x7FB3CF), 0.6), 0.18};
    }
    if (kr > kd) {
        return {mixed(ink, Ink(0x9AA9B8), 0.7), 0.33};
    }
    return {mixed(ink, Ink(0xB8C0C8), 0.35), 0.43};
}

}  // namespace raytree::inspector
