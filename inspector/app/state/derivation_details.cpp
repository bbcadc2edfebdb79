#include "state/derivation_details.h"

#include <array>
#include <cmath>

#include "state/numbers.h"
#include "tree/explain.h"

namespace raytree::inspector {
namespace {

using Row = DetailRow;
using Weight = DetailRow::Weight;

Row number(std::string label, double value, Weight weight = Weight::normal) {
    return {std::move(label), aligned(std::array{value}), weight, false, {}, {value}};
}

Row text(std::string label, std::string words) {
    return {std::move(label), {std::move(words)}, Weight::normal, true, {}};
}

/// Why the other root is not the hit.
std::string root_sentence(const SphereDerivation& sphere, bool starts_on_it) {
    if (sphere.taken == 0) {
        return "The smaller root is taken: the ray comes to it first.";
    }
    if (starts_on_it) {
        return "t2 is taken: t1 is where the ray starts, on this very sphere, and 0 but for "
               "rounding.";
    }
    return sphere.roots[0] <= 0
               ? "t2 is taken: t1 is not above 0, so it lies behind the ray's start."
               : "t2 is taken: t1 lies before the part of the ray in which hits count.";
}

DetailSection section_of(const SphereDerivation& sphere, bool starts_on_it) {
    DetailSection section{"How the hit was found: sphere", {}, {}};
    auto& rows = section.rows;
    rows.push_back(number("A = d·d", sphere.a));
    rows.push_back(number("B = 2 d·(o−c)", sphere.b));
    rows.push_back(number("C = (o−c)²−r²", sphere.c));
    rows.push_back(number("B² − 4AC", sphere.discriminant));
    const auto weight = [&](int k) { return sphere.taken == k ? Weight::strong : Weight::faint; };
    rows.push_back(number("t1", sphere.roots[0], weight(0)));
    rows.push_back(number("t2", sphere.roots[1], weight(1)));
    section.sentences.push_back(root_sentence(sphere, starts_on_it));
    return section;
}

DetailSection section_of(const PolygonDerivation& polygon) {
    constexpr std::array<const char*, 3> axes = {"x", "y", "z"};
    const auto axis = [&](int k) { return axes[static_cast<std::size_t>(k % 3)]; };
    DetailSection section{"How the hit was found: polygon", {}, {}};
    auto& rows = section.rows;
    rows.push_back({"", {"x", "y", "z"}, Weight::faint, false, {}});
    const Vec3<double>& n = polygon.normal;
    rows.push_back({"plane's n", aligned(n), Weight::normal, false, {}, {n.x, n.y, n.z}});
    rows.push_back(number("n·x = D", polygon.offset));
    rows.push_back(number("n·o", polygon.start));
    rows.push_back(number("n·d", polygon.speed));
    rows.push_back(number("(D−n·o)/(n·d)", polygon.t, Weight::strong));
    rows.push_back(
        text("dropped axis", std::string(axis(polygon.dropped)) + ", the largest component of n"));
    rows.push_back(number(axis(polygon.dropped + 1), polygon.u));
    rows.push_back(number(axis(polygon.dropped + 2), polygon.v));
    const bool odd = polygon.crossings % 2 == 1;
    rows.push_back(text("crossings", std::to_string(polygon.crossings) +
                                         (odd ? ", odd: inside" : ", even: on an edge")));
    section.sentences.push_back(
        "A plane gives one t; it counts as it is above 0 and the point lies inside the outline.");
    return section;
}

std::string cone_sentence(const ConeDerivation& cone, bool starts_on_it) {
    if (cone.taken == 0) {
        return "The smaller root is taken: the ray comes to it first, and 0 ≤ z ≤ h.";
    }
    if (starts_on_it) {
        return "t2 is taken: t1 is where the ray starts, on this very surface, and 0 but for "
               "rounding.";
    }
    if (cone.roots[0] <= 0) {
        return "t2 is taken: t1 is not above 0, so it lies behind the ray's start.";
    }
    return cone.heights[0] < 0 || cone.heights[0] > cone.height
               ? "t2 is taken: at t1 the ray is beyond an open end, z being less than 0 or more "
                 "than h."
               : "t2 is taken: t1 lies before the part of the ray in which hits count.";
}

DetailSection section_of(const ConeDerivation& cone, bool starts_on_it) {
    DetailSection section{
        std::string("How the hit was found: ") + (cone.slope == 0 ? "cylinder" : "cone"), {}, {}};
    auto& rows = section.rows;
    rows.push_back(number("radius r at z = 0", cone.radius));
    if (cone.slope != 0) {
        rows.push_back(number("slope m", cone.slope));
    }
    rows.push_back(number("height h", cone.height));
    rows.push_back(number("A", cone.a));
    rows.push_back(number("B", cone.b));
    rows.push_back(number("C", cone.c));
    rows.push_back(number("B² − 4AC", cone.discriminant));
    for (std::size_t k = 0; k < 2; ++k) {
        if (std::isfinite(cone.roots[k])) {
            const Weight weight =
                cone.taken == static_cast<int>(k) ? Weight::strong : Weight::faint;
            const std::string name = std::to_string(k + 1);
            rows.push_back(number("t" + name, cone.roots[k], weight));
            rows.push_back(number("z at t" + name, cone.heights[k], Weight::faint));
        }
    }
    section.sentences.push_back(
        cone.slope == 0
            ? "|o + t d − base|² across the axis = r², z being the height along it."
            : "|o + t d − base|² across the axis = (r + m z)², z being the height along it.");
    section.sentences.push_back(cone_sentence(cone, starts_on_it));
    return section;
}

DetailSection along_of(const Derivation& derivation) {
    DetailSection section{"All hits along the ray", {}, {}};
    for (const AlongRay& met : derivation.along) {
        if (section.rows.size() == most_met) {
            section.sentences.push_back(
                "And " + std::to_string(derivation.along.size() - most_met) + " more.");
            break;
        }
        section.rows.push_back(text("t = " + number_text(met.t),
                                    met.object + (met.taken ? "  ←  the first that counts" : "")));
    }
    return section;
}

DetailSection media_of(const Derivation& derivation) {
    DetailSection section{"Media that the ray is in", {}, {}};
    for (const Medium& medium : derivation.media) {
        section.rows.push_back(text(medium.material, "η = " + number_text(medium.ior)));
    }
    if (derivation.media.empty()) {
        section.sentences.push_back("None: η = 1.");
    } else if (derivation.media.size() > 1) {
        section.sentences.push_back("The one entered last counts.");
    }
    return section;
}

}  // namespace

std::vector<DetailSection> derivation_details(const Derivation& derivation) {
    std::vector<DetailSection> sections;
    if (const auto* sphere = std::get_if<SphereDerivation>(&derivation.how)) {
        sections.push_back(section_of(*sphere, derivation.starts_on_it));
    } else if (const auto* polygon = std::get_if<PolygonDerivation>(&derivation.how)) {
        sections.push_back(section_of(*polygon));
    } else if (const auto* cone = std::get_if<ConeDerivation>(&derivation.how)) {
        sections.push_back(section_of(*cone, derivation.starts_on_it));
    }
    if (!sections.empty() && derivation.own_space) {
        sections.back().sentences.push_back(
            "In the shape's own space, before its transform; t is the distance in the world.");
    }
    if (!derivation.along.empty()) {
        sections.push_back(along_of(derivation));
    }
    sections.push_back(media_of(derivation));
    return sections;
}

}  // namespace raytree::inspector
