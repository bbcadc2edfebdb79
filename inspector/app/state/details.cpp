#include "state/details.h"

#include <cmath>
#include <map>

#include "state/detail_rows.h"
#include "state/numbers.h"
#include "tree/eight_bit.h"
#include "tree/explain.h"

namespace raytree::inspector {
namespace {

using Row = DetailRow;
using Weight = DetailRow::Weight;

std::vector<double> values_of(const Rgb<double>& c) { return {c.r, c.g, c.b}; }

/// What a sum does not notice is shown as 0, and little of it with its decimals. Copied, it has all
/// of its digits.
Row summand_row(std::string label, const Rgb<double>& part, const Rgb<double>& sum) {
    std::vector<std::string> texts = aligned_with(sum, noticed(part, sum));
    return {std::move(label), std::move(texts), Weight::normal, false, {}, values_of(part)};
}

DetailSection way_of(const PixelTree& tree, const TreeRay<double>& ray) {
    DetailSection section{"Ray", {}, {}};
    auto& rows = section.rows;
    rows.push_back(text_row("level", std::to_string(ray.level) + " of at most " +
                                         std::to_string(tree.tree.settings.max_depth)));
    if (ray.parent) {
        rows.push_back(text_row("sent from", title_of(tree.tree.rays[*ray.parent])));
    }
    rows.push_back(heading_row({"x", "y", "z"}));
    rows.push_back(triple_row("origin", ray.origin));
    rows.push_back(triple_row("direction", ray.direction));
    return section;
}

DetailSection hit_of(const TreeHit<double>& hit) {
    DetailSection section{"Hit", {}, {}};
    auto& rows = section.rows;
    const bool own_material = hit.material.empty() || hit.material == hit.object;
    rows.push_back(text_row("object", hit.object));
    if (!own_material) {
        rows.push_back(text_row("material", hit.material));
    }
    rows.push_back(text_row("side", hit.side == Side::front ? "front" : "back"));
    rows.push_back(number_row("t", hit.t));
    rows.push_back(heading_row({"x", "y", "z"}));
    rows.push_back(triple_row("point", hit.point));
    rows.push_back(triple_row("normal n", hit.normal));
    rows.push_back(text_row("angle to n", angle_text(hit.cos_incident)));
    return section;
}

DetailSection refraction_of(const RayTree<double>& tree, const TreeHit<double>& hit) {
    const Interface<double>& at = *hit.interface;
    DetailSection section{"Refraction", {}, {}};
    section.rows.push_back(
        text_row("η1 → η2", number_text(at.eta1) + " → " + number_text(at.eta2)));
    section.rows.push_back(number_row("sin² θ2", at.sin2_transmitted));
    const std::string in = angle_text(hit.cos_incident);
    if (at.sin2_transmitted <= 1) {
        section.rows.push_back(text_row(
            "θ1 → θ2", in + " → " + angle_text(std::sqrt(1 - std::max(0.0, at.sin2_transmitted))) +
                           ", from the normal"));
        return section;
    }
    section.rows.push_back(text_row("θ1", in + " from the normal"));
    const double ratio = at.eta2 / at.eta1;
    if (ratio < 1) {
        section.rows.push_back(
            text_row("critical angle", angle_text(std::sqrt(1 - ratio * ratio)) + ", exceeded"));
    }
    if (kt_joins_kr(tree, hit)) {
        section.sentences.push_back(
            "The reflection is total: the reflected ray takes over what the refracted one would "
            "have, kt is added to kr.");
    }
    return section;
}

void add_branch(const PixelTree& tree, const TreeRay<double>& ray, const TreeRay<double>& child,
                std::vector<Row>& rows) {
    const bool reflected = child.kind == RayKind::reflected;
    const bool joined = reflected && kt_joins_kr(tree.tree, *ray.hit);
    const std::string k = joined ? "kr + kt" : reflected ? "kr" : "kt", i = reflected ? "Ir" : "It";
    const Rgb<double>& coefficient = reflected ? ray.hit->kr : ray.hit->kt;
    const Rgb<double> share = child.attenuation * (coefficient * child.intensity);
    rows.push_back(summand_row("+ " + (joined ? "(kr+kt)" : k) + "·f·" + i, share, ray.intensity));
    const auto faint = [&](const std::string& label, const Rgb<double>& triple) {
        rows.push_back(triple_row("   " + label, triple));
        rows.back().weight = Weight::faint;
    };
    faint(k, coefficient);
    if (tree.tree.settings.attenuation != Attenuation{}) {
        faint("f", Rgb<double>(child.attenuation));
    }
    rows.push_back(summand_row("   " + i + " of " + number_of(tree, child.id), child.intensity,
                               ray.intensity));
    rows.back().weight = Weight::faint;
}

DetailSection intensity_of(const PixelTree& tree, const TreeRay<double>& ray) {
    DetailSection section{"Intensity", {}, {}};
    auto& rows = section.rows;
    rows.push_back(heading_row({"red", "green", "blue"}));
    if (ray.hit) {
        rows.push_back(summand_row("ambient", ray.ambient, ray.intensity));
        rows.push_back(summand_row("+ diffuse", ray.diffuse, ray.intensity));
        rows.push_back(summand_row("+ specular", ray.specular, ray.intensity));
        for (const std::size_t child : tree.children[ray.id]) {
            // Of the tree that it is compared with, no ray adds anything to this one's.
            if (tree.tree.rays[child].kind != RayKind::shadow &&
                tree.is_own(child) == tree.is_own(ray.id)) {
                add_branch(tree, ray, tree.tree.rays[child], rows);
            }
        }
    }
    Row sum = triple_row(ray.hit ? "= intensity" : "background", ray.intensity);
    sum.weight = Weight::strong;
    sum.swatch = ray.intensity;
    rows.push_back(std::move(sum));
    return section;
}

DetailSection share_of(const TreeRay<double>& ray) {
    DetailSection section{"Share of the pixel", {}, {}};
    section.rows.push_back(heading_row({"red", "green", "blue"}));
    section.rows.push_back(triple_row("weight", ray.weight));
    if (ray.kind != RayKind::primary) {
        section.rows.push_back(triple_row("f of t", Rgb<double>(ray.attenuation)));
        section.rows.push_back(
            triple_row("weight·f·I", ray.attenuation * (ray.weight * ray.intensity)));
    }
    return section;
}

/// As a sentence: with a capital and a full stop.
std::string sentence(std::string text) {
    if (!text.empty() && text.front() >= 'a' && text.front() <= 'z') {
        text.front() = static_cast<char>(text.front() - 'a' + 'A');
    }
    return text + ".";
}

/// Why the ray ended, and each ray that was not sent; lights with the same reason in one sentence.
DetailSection endings_of(const PixelTree& tree, const TreeRay<double>& ray) {
    DetailSection section{"Where it ends", {}, {}};
    if (ray.termination) {
        section.sentences.push_back(sentence(ended_text(tree.tree, ray)));
    }
    std::map<Reason, std::string> lights;
    for (const Skipped& skipped : ray.skipped) {
        if (skipped.kind == RayKind::shadow) {
            std::string& names = lights[skipped.reason];
            names += (names.empty() ? "" : ", ") + skipped.light;
        }
    }
    for (const auto& [reason, names] : lights) {
        section.sentences.push_back("No shadow ray to " + names + ": " +
                                    std::string(text_of(reason).sentence) + ".");
    }
    for (const Skipped& skipped : ray.skipped) {
        if (skipped.kind != RayKind::shadow && !told_by_termination(ray, skipped)) {
            section.sentences.push_back("No " + std::string(word_of(skipped.kind)) +
                                        " ray: " + skipped_text(tree.tree, ray, skipped) + ".");
        }
    }
    return section;
}

DetailSection light_of(const TreeRay<double>& ray) {
    const ShadowPart<double>& shadow = *ray.shadow;
    DetailSection section{"Light", {}, {}};
    auto& rows = section.rows;
    rows.push_back(text_row("light", shadow.light));
    if (shadow.distance) {
        rows.push_back(number_row("distance", *shadow.distance));
    } else {
        rows.push_back(text_row("distance", "infinite: a directional light"));
    }
    if (shadow.blocked_by) {
        rows.push_back(text_row("blocked by", shadow.blocked_by->object));
        rows.push_back(number_row("at t", shadow.blocked_by->t));
    }
    section.sentences.push_back("The shadow ray " + shadow_text(ray) + ".");
    return section;
}

DetailSection lighting_of(const PixelTree& tree, const TreeRay<double>& ray) {
    const Rgb<double> all = ray.parent ? tree.tree.rays[*ray.parent].intensity : ray.intensity;
    DetailSection section{"What it adds", {}, {}};
    section.rows.push_back(heading_row({"red", "green", "blue"}));
    section.rows.push_back(triple_row("transmittance", ray.shadow->transmittance));
    section.rows.push_back(summand_row("diffuse", ray.diffuse, all));
    section.rows.push_back(summand_row("+ specular", ray.specular, all));
    Row sum = summand_row("= added", ray.diffuse + ray.specular, all);
    sum.weight = Weight::strong;
    sum.swatch = ray.diffuse + ray.specular;
    section.rows.push_back(std::move(sum));
    return section;
}

}  // namespace

std::vector<DetailSection> details_of(const PixelTree& tree, std::size_t id) {
    const TreeRay<double>& ray = tree.tree.rays[id];
    if (ray.shadow) {
        return {light_of(ray), lighting_of(tree, ray), way_of(tree, ray)};
    }
    std::vector<DetailSection> sections = {intensity_of(tree, ray)};
    DetailSection endings = endings_of(tree, ray);
    if (!endings.sentences.empty()) {
        sections.push_back(std::move(endings));
    }
    if (ray.hit) {
        sections.push_back(hit_of(*ray.hit));
    }
    if (ray.hit && ray.hit->interface) {
        sections.push_back(refraction_of(tree.tree, *ray.hit));
    }
    sections.push_back(share_of(ray));
    sections.push_back(way_of(tree, ray));
    return sections;
}

std::string title_of(const TreeRay<double>& ray) {
    const std::string kind(word_of(ray.kind));
    return "#" + std::to_string(ray.id) + " " + kind + " ray" +
           (ray.shadow ? " to " + ray.shadow->light : "");
}

std::string value_text(const Rgb<double>& intensity, Quantize quantize) {
    const EightBit pixel = eight_bit(intensity, quantize);
    std::string text = rgb_text(intensity) + "  →  ";
    std::string clamped;
    for (std::size_t c = 0; c < 3; ++c) {
        text += (c > 0 ? " " : "") + std::to_string(pixel.value[c]);
        if (pixel.clamped[c]) {
            clamped += (clamped.empty() ? "" : ", ") + std::string(channel_names[c]);
        }
    }
    return clamped.empty() ? text : text + "  (" + clamped + " clamped)";
}

std::string pixel_text(const RayTree<double>& tree) {
    return "Pixel " + text_of(Pixel{tree.pixel_i, tree.pixel_j}) + "   " +
           value_text(tree.intensity, tree.settings.quantize);
}

std::string counts_text(const RayTree<double>& tree) {
    const TreeCounts& n = tree.counts;
    const auto number = [](std::size_t count) { return grouped(static_cast<double>(count)); };
    return number(n.all()) + (n.all() == 1 ? " ray: " : " rays: ") + number(n.primary) +
           " primary, " + number(n.reflected) + " reflected, " + number(n.refracted) +
           " refracted, " + number(n.shadow) + " shadow   ·   full tree: (" +
           std::to_string(n.lights) + " + 1)(2^" + std::to_string(tree.settings.max_depth) +
           " − 1) = " + grouped(n.full_tree);
}

}  // namespace raytree::inspector
