#include "state/formula_details.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "state/numbers.h"
#include "trace/eye_space.h"
#include "tree/explain.h"

namespace raytree::inspector {
namespace {

using lesson::Formula;
using Row = DetailRow;

Row triple(std::string label, const Vec3<double>& v) {
    return {std::move(label), aligned(v), Row::Weight::normal, false, {}};
}
Row number(std::string label, double value, Row::Weight weight = Row::Weight::normal) {
    return {std::move(label), aligned(std::array{value}), weight, false, {}};
}
Row words(std::string label, std::string text) {
    return {std::move(label), {std::move(text)}, Row::Weight::normal, true, {}};
}
Row axes() { return {"", {"x", "y", "z"}, Row::Weight::faint, false, {}}; }

constexpr const char* pixel_title = "The ray through the pixel";
constexpr const char* reflection_title = "The reflected direction";
constexpr const char* attenuation_title = "Attenuation by distance";
constexpr const char* bound_title = "The most rays that a tree can have";

DetailSection pixel_section(const State& state) {
    const Document& document = *state.document();
    const CameraRays<double>& rays = document.world().camera;
    const Pixel pixel = state.pixel();
    const double x = rays.xp(pixel.i), y = rays.yp(pixel.j);
    DetailSection section{pixel_title, {}, {}};
    section.rows = {
        words("pixel i, j", text_of(pixel)),
        number("pixel width", rays.xp(1) - rays.xp(0)),
        number("xp", x),
        number("yp", y),
        axes(),
        triple("Vx", rays.right().vec()),
        triple("Vy", rays.up()),
        triple("Vz", rays.forward().vec()),
        triple("P − E", rays.forward().vec() + x * rays.right().vec() + y * rays.up()),
        triple("at length 1", document.world().camera.primary(pixel.i, pixel.j).direction)};
    section.sentences = {"P − E = xp Vx + yp Vy + Vz"};
    return section;
}

DetailSection reflection_section(const TreeRay<double>& ray) {
    DetailSection section{reflection_title, {}, {}};
    if (!ray.hit) {
        section.sentences = {"The ray hits nothing that could reflect it."};
        return section;
    }
    // Of the two normals the one on the side from which the ray comes.
    const double cosine = inner(ray.hit->normal, ray.direction);
    const Vec3<double> direction = ray.direction;
    const Vec3<double> normal = ray.hit->normal;
    section.rows = {axes(), triple("d", direction), triple("n", normal), number("d·n", cosine),
                    triple("r", direction - 2 * cosine * normal)};
    section.sentences = {"r = d − 2 (d · n) n"};
    return section;
}

DetailSection attenuation_section(const State& state, const TreeRay<double>& ray) {
    const Attenuation& c = state.document()->scene().settings.attenuation;
    DetailSection section{attenuation_title, {}, {}};
    section.rows = {number("a", c.a), number("b", c.b), number("c", c.c),
                    number("f of the ray", ray.attenuation)};
    section.sentences = {"f = min(1, 1 / (a + b t + c t²))"};
    if (ray.hit) {
        section.rows.insert(section.rows.end() - 1, number("t", ray.hit->t));
    }
    return section;
}

DetailSection bound_section(const State& state) {
    const RayTree<double>& tree = state.tree()->tree;
    DetailSection section{bound_title, {}, {}};
    section.rows = {words("lights m", std::to_string(tree.counts.lights)),
                    words("levels n", std::to_string(tree.settings.max_depth)),
                    words("(m + 1)(2ⁿ − 1)", grouped(tree.counts.full_tree)),
                    words("this tree", grouped(static_cast<double>(tree.counts.all())))};
    return section;
}

DetailSection eye_space_section(const State& state, const TreeRay<double>& ray) {
    const Scene& scene = state.document()->scene();
    const EyeSpace<double> space(scene.camera, scene.settings.pixel_sample);
    DetailSection section{"In eye space", {}, {}};
    section.rows = {axes(), triple("origin", space.point(ray.origin)),
                    triple("direction", space.direction(ray.direction))};
    if (ray.hit) {
        section.rows.push_back(triple("point", space.point(ray.hit->point)));
        section.rows.push_back(triple("normal n", space.direction(ray.hit->normal)));
    }
    return section;
}

}  // namespace

std::optional<Formula> marked_formula(const State& state) {
    const bool taught = state.lesson() && state.lesson_side() == LessonSide::lesson;
    return taught ? state.lesson()->here().show.formula : std::nullopt;
}

bool is_about(const DetailSection& section, Formula formula) {
    constexpr std::string_view found = "How the hit was found";
    const std::string_view title = section.title;
    switch (formula) {
        case Formula::pixel:
            return title == pixel_title;
        case Formula::sphere:
        case Formula::polygon:
            return title.starts_with(found);
        case Formula::normal:
            return title == "Hit";
        case Formula::media:
            return title.starts_with("Media");
        case Formula::illumination:
            return title == "Intensity" || title == "What it adds";
        case Formula::shadow:
            return title == "Light";
        case Formula::reflection:
            return title == reflection_title;
        case Formula::refraction:
            return title == "Refraction";
        case Formula::attenuation:
            return title == attenuation_title;
        case Formula::termination:
            return title == "Where it ends";
        case Formula::bound:
            return title == bound_title;
        default:
            return title == "All hits along the ray";
    }
}

std::vector<DetailSection> formula_details(const State& state) {
    std::vector<DetailSection> sections;
    const TreeRay<double>* const ray = state.selected();
    if (!ray) {
        return sections;
    }
    const auto formula = marked_formula(state);
    if (formula == Formula::pixel && ray->kind == RayKind::primary) {
        sections.push_back(pixel_section(state));
    } else if (formula == Formula::reflection) {
        sections.push_back(reflection_section(*ray));
    } else if (formula == Formula::attenuation) {
        sections.push_back(attenuation_section(state, *ray));
    } else if (formula == Formula::bound) {
        sections.push_back(bound_section(state));
    }
    if (state.explained().eye_space) {
        sections.push_back(eye_space_section(state, *ray));
    }
    return sections;
}

}  // namespace raytree::inspector
