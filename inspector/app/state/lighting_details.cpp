#include "state/lighting_details.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "state/detail_rows.h"
#include "state/thing.h"
#include "trace/shading.h"
#include "tree/explain.h"

namespace raytree::inspector {
namespace {

constexpr std::size_t most_lights = 8;  // that are told one by one

/// What a light meets: a hit's place and normal, its material, and where it is seen from.
struct LitHit {
    const TreeHit<double>& hit;
    const Material& material;
    Vec3<double> viewing;  ///< d of the ray that hits
    Rgb<double> sum;       ///< of which the terms are a part
};

std::optional<LitHit> lit_hit(const Document& document, const TreeRay<double>& ray) {
    const auto object = ray.hit ? object_named(document.scene(), ray.hit->object) : std::nullopt;
    if (!object) {
        return std::nullopt;
    }
    const Scene& scene = document.scene();
    return LitHit{*ray.hit, scene.materials[scene.objects[object->index].material], ray.direction,
                  ray.intensity};
}

/// What the sum does not notice is shown as 0, as elsewhere. Copied, it has all of its digits.
DetailRow term_row(std::string label, const Rgb<double>& term, const Rgb<double>& sum) {
    DetailRow row = triple_row(std::move(label), term);
    row.cells = aligned_with(sum, noticed(term, sum));
    row.weight = DetailRow::Weight::strong;
    return row;
}

void add_diffuse(std::vector<DetailRow>& rows, const LitHit& at, double cosine,
                 const Rgb<double>& arriving) {
    const Rgb<double> k = at.material.kd * at.material.color;
    rows.push_back(number_row("n · L", cosine));
    rows.push_back(heading_row({"red", "green", "blue"}));
    rows.push_back(triple_row("kd · colour", k));
    rows.push_back(triple_row("Il · g · T", arriving));
    rows.push_back(term_row("diffuse", cosine * (k * arriving), at.sum));
}

void add_specular(std::vector<DetailRow>& rows, const LitHit& at, SpecularModel model,
                  const Vec3<double>& towards, const Rgb<double>& arriving) {
    const Rgb<double> k = at.material.ks * at.material.specular_color;
    if (is_zero(k)) {
        return;
    }
    const double h = specular_cosine(model, at.hit.normal, towards, Vec3<double>(-at.viewing));
    const double power = std::pow(h, at.material.shininess);
    rows.push_back(number_row(model == SpecularModel::phong ? "h = R · V" : "h = n · H", h));
    rows.push_back(number_row("shininess m", at.material.shininess));
    rows.push_back(text_row("hᵐ", number_text(power)));
    rows.push_back(heading_row({"red", "green", "blue"}));
    rows.push_back(triple_row("ks · colour", k));
    rows.push_back(term_row("specular", power * (k * arriving), at.sum));
}

/// `transmittance`: how much of the light arrives.
DetailSection light_section(const Document& document, const LitHit& at, std::size_t k,
                            const Rgb<double>& transmittance, std::string title) {
    const WorldLight<double>& light = document.world().lights[k];
    const Illumination<double> lit = illuminate(light, at.hit.point, at.hit.normal);
    DetailSection section{std::move(title), {}, {}};
    auto& rows = section.rows;
    rows.push_back(heading_row({"x", "y", "z"}));
    rows.push_back(triple_row("L", lit.towards));
    if (!lit.in_front()) {
        rows.push_back(number_row("n · L", lit.cosine));
        section.sentences.push_back("The light is behind the surface: it adds nothing.");
        return section;
    }
    const double g = light.directional ? 1 : light.attenuation.at(lit.distance);
    if (!light.directional) {
        rows.push_back(number_row("distance D", lit.distance));
    }
    rows.push_back(number_row("g of D", g));
    rows.push_back(heading_row({"red", "green", "blue"}));
    rows.push_back(triple_row("Il", light.intensity));
    rows.push_back(triple_row("T", transmittance));
    const Rgb<double> arriving = g * (light.intensity * transmittance);
    const SpecularModel model = document.scene().settings.specular_model;
    add_diffuse(rows, at, lit.cosine, arriving);
    add_specular(rows, at, model, lit.towards, arriving);
    section.sentences.push_back(
        "diffuse = kd · colour · Il · g · T · (n · L), T the share of the light that arrives");
    if (!is_zero(at.material.ks * at.material.specular_color)) {
        section.sentences.push_back("specular = ks · its own colour · Il · g · T · hᵐ");
        section.sentences.push_back(model == SpecularModel::phong
                                        ? "h = max(0, R · V), R = 2 (n · L) n − L, V = −d"
                                        : "h = max(0, n · H), H halfway between L and V = −d");
    }
    return section;
}

DetailSection ambient_section(const Document& document, const LitHit& at) {
    const Rgb<double>& light = document.scene().ambient;
    DetailSection section{"How ambient is worked out", {}, {}};
    section.rows = {heading_row({"red", "green", "blue"}), triple_row("ka", at.material.ka),
                    triple_row("colour", at.material.color), triple_row("scene's light", light),
                    term_row("ambient", at.material.ka * at.material.color * light, at.sum)};
    return section;
}

}  // namespace

std::vector<DetailSection> lighting_details(const Document& document, const PixelTree& tree,
                                            std::size_t id) {
    const TreeRay<double>& ray = tree.tree.rays[id];
    const std::vector<Light>& lights = document.scene().lights;
    const auto at = lit_hit(document, ray.shadow ? tree.tree.rays[*ray.parent] : ray);
    std::vector<DetailSection> sections;
    if (!at) {
        return sections;
    }
    if (ray.shadow) {
        const auto light = std::ranges::find(lights, ray.shadow->light, &Light::name);
        if (light != lights.end()) {
            sections.push_back(light_section(
                document, *at, static_cast<std::size_t>(light - lights.begin()),
                ray.shadow->transmittance, "How diffuse and specular are worked out"));
        }
        return sections;
    }
    sections.push_back(ambient_section(document, *at));
    for (std::size_t k = 0; document.scene().settings.shadows == ShadowMode::none &&
                            k < std::min(lights.size(), most_lights);
         ++k) {
        sections.push_back(
            light_section(document, *at, k, Rgb<double>(1), "What " + lights[k].name + " adds"));
    }
    return sections;
}

}  // namespace raytree::inspector
