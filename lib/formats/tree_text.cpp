#include "formats/tree_text.h"

#include <algorithm>
#include <array>

#include "formats/styled_text.h"
#include "formats/sum_text.h"
#include "formats/tree_title.h"
#include "tree/eight_bit.h"
#include "tree/explain.h"

namespace raytree {
namespace {

constexpr std::size_t label_columns = 7;

std::string superscript(int number) {
    constexpr std::array<const char*, 10> digits = {"⁰", "¹", "²", "³", "⁴",
                                                    "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text;
    for (const char digit : std::to_string(number)) {
        text += digits[static_cast<std::size_t>(digit - '0')];
    }
    return text;
}

std::string plural(std::size_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

Style style_of(const TreeRay<double>& ray) {
    switch (ray.kind) {
        case RayKind::primary:
            return Style::primary;
        case RayKind::reflected:
            return Style::reflected;
        case RayKind::refracted:
            return Style::refracted;
        case RayKind::shadow:
            break;
    }
    return reaches_light(ray) ? Style::lit : Style::blocked;
}

/// "min(1, 1 / (1 + 0.05 t + 0.002 t²))", without the terms that are 0.
std::string attenuation_text(const Attenuation& a) {
    std::string sum;
    const auto add = [&](double coefficient, const char* power) {
        if (coefficient != 0) {
            sum += (sum.empty() ? "" : " + ") + number_text(coefficient) + power;
        }
    };
    add(a.a, "");
    add(a.b, " t");
    add(a.c, " t²");
    return "min(1, 1 / (" + sum + ")), t the way of a reflected or refracted ray to its hit";
}

class Outline {
  public:
    Outline(const RayTree<double>& tree, const OutlineOptions& options)
        : tree_(tree),
          children_(children_of(tree)),
          bounds_(options.bounds),
          out_(options.colour, static_cast<std::size_t>(std::max(options.width, 40))) {}

    std::string write() {
        write_header();
        write_legend();
        if (!tree_.rays.empty()) {
            write_ray(tree_.rays.front(), "", "");
        }
        return out_.take();
    }

  private:
    using Ray = TreeRay<double>;

    /// Where the lines of an item begin: the rows of its text, and what hangs from it.
    struct Place {
        std::string body;
        std::string branch;
    };

    void row(const Place& at, std::string_view label, const std::string& text) {
        const std::string blanks(label_columns, ' ');
        out_.paragraph(at.body, at.body + blanks,
                       {{Style::label, padded(label, label_columns)}, {Style::plain, text}});
    }

    void write_header() {
        out_.paragraph("", "", {{Style::heading, "The ray tree of " + pixel_and_scene(tree_)}});
        out_.line("", {});
        row({}, "pixel", pixel_text());
        row({}, "rays", counts_text());
        if (tree_.counts.full_tree > 0) {
            row({}, "bound", bound_text());
        }
        if (tree_.counts.intersection_tests > 0) {
            row({}, "tests",
                std::to_string(tree_.counts.intersection_tests) + " of a ray with a shape");
        }
        if (tree_.settings.attenuation != Attenuation{}) {
            row({}, "f(t)", attenuation_text(tree_.settings.attenuation));
        }
        if (tree_.settings.shadows == ShadowMode::none) {
            row({}, "shadow", "none: every light in front of a surface is seen, untested");
        }
        out_.line("", {});
    }

    std::string pixel_text() const {
        const EightBit pixel = eight_bit(tree_.intensity, tree_.settings.quantize);
        std::string text = triple_text(tree_.intensity) + ", in 8 bits (" +
                           std::to_string(pixel.value[0]) + ", " + std::to_string(pixel.value[1]) +
                           ", " + std::to_string(pixel.value[2]) + ")";
        std::string clamped;
        for (std::size_t c = 0; c < 3; ++c) {
            if (pixel.clamped[c]) {
                clamped += (clamped.empty() ? "" : ", ") + std::string(channel_names[c]);
            }
        }
        return clamped.empty() ? text : text + "; clamped to the range 0 to 1: " + clamped;
    }

    std::string counts_text() const {
        const TreeCounts& n = tree_.counts;
        return std::to_string(n.all()) + ": " + std::to_string(n.primary) + " primary, " +
               std::to_string(n.reflected) + " reflected, " + std::to_string(n.refracted) +
               " refracted, " + std::to_string(n.shadow) + " shadow; " +
               plural(static_cast<std::size_t>(n.levels), "level");
    }

    std::string bound_text() const {
        const TreeCounts& n = tree_.counts;
        const int depth = tree_.settings.max_depth;
        return "at most " + number_text(n.full_tree) + " rays = (" + plural(n.lights, "light") +
               " + 1) (2" + superscript(depth) + " − 1) for " +
               plural(static_cast<std::size_t>(depth), "level") + "; here " +
               number_text(100 * static_cast<double>(n.all()) / n.full_tree) + " % of them";
    }

    void write_legend() {
        out_.paragraph(
            "", "",
            {{Style::plain,
              "I = ambient + diffuse + specular + kr·f·Ir + kt·f·It for (red, green, blue), one "
              "number where the three are equal. A term without its ray and an f of 1 are left "
              "out. The share of a ray is what its f·I is multiplied by on the way to the pixel. "
              "Numbers have 4 digits; those with fewer are exact."}});
        if (bounds_) {
            out_.paragraph("", "",
                           {{Style::plain,
                             "± is how far rounding may have moved the numbers of a ray; unsure is "
                             "what could have gone the other way by it."}});
        }
        out_.line("", {});
    }

    void write_ray(const Ray& ray, const std::string& first, const std::string& rest) {
        std::size_t told = 0;
        for (const Skipped& skipped : ray.skipped) {
            told += told_by_termination(ray, skipped) ? 0 : 1;
        }
        std::size_t left = children_[ray.id].size() + told;
        const Place at{rest + (left > 0 ? "│  " : "   "), rest};
        if (ray.shadow) {
            write_shadow_ray(ray, first, at);
        } else {
            write_carrying_ray(ray, first, at);
        }
        write_branches(ray, at, left);
    }

    void title(const Ray& ray, const std::string& prefix, const Place& at,
               const std::string& what_happens) {
        std::string kind(word_of(ray.kind));
        if (ray.shadow) {
            kind += " ray to " + ray.shadow->light;
        } else {
            kind += " ray";
        }
        out_.paragraph(prefix, at.body,
                       {{Style::label, "#" + std::to_string(ray.id) + " "},
                        {style_of(ray), kind},
                        {Style::plain, " " + what_happens}});
    }

    void write_shadow_ray(const Ray& ray, const std::string& prefix, const Place& at) {
        title(ray, prefix, at, shadow_text(ray));
        if (reaches_light(ray)) {
            const Rgb<double>& sum = tree_.rays[ray.parent.value_or(ray.id)].intensity;
            row(at, "adds",
                "diffuse " + triple_text(noticed(ray.diffuse, sum)) + " + specular " +
                    triple_text(noticed(ray.specular, sum)));
        }
        write_bounds(ray, at);
    }

    /// How far off the ray's numbers may be, and what could have gone the other way.
    void write_bounds(const Ray& ray, const Place& at) {
        if (!bounds_) {
            return;
        }
        const RayBounds& bounds = (*bounds_)[ray.id];
        std::string text = "direction " + number_text(bounds.direction);
        if (ray.shadow) {
            if (ray.shadow->distance) {
                text += ", distance " + number_text(bounds.distance);
            }
        } else if (ray.hit) {
            text += ", t " + number_text(bounds.hit.t) + ", point " +
                    number_text(bounds.hit.point) + ", normal " + number_text(bounds.hit.normal) +
                    ", cosine " + number_text(bounds.hit.cos_incident);
        }
        if (!ray.shadow) {
            text += ", I " + triple_text(bounds.intensity);
        }
        row(at, "±", text);
        for (const Doubt& doubt : bounds.doubts) {
            row(at, "unsure", doubt.text);
        }
    }

    void write_carrying_ray(const Ray& ray, const std::string& prefix, const Place& at) {
        if (!ray.hit) {
            title(ray, prefix, at, "escapes");
            write_share(ray, at);
            row(at, "I", triple_text(ray.intensity) + ", the background");
            write_bounds(ray, at);
            row(at, "ends", ended_text(tree_, ray));
            return;
        }
        const TreeHit<double>& hit = *ray.hit;
        const std::string material =
            hit.material.empty() || hit.material == hit.object ? "" : " (" + hit.material + ")";
        title(ray, prefix, at,
              "hits " + hit.object + material + " at t = " + number_text(hit.t) + ", on its " +
                  (hit.side == Side::front ? "front" : "back"));
        row(at, "point",
            point_text(hit.point) + "; " + angle_text(hit.cos_incident) + " from the normal " +
                point_text(hit.normal));
        if (hit.interface) {
            row(at, "η",
                refraction_text(hit) + (kt_joins_kr(tree_, hit) ? "; kt is added to kr" : ""));
        }
        write_share(ray, at);
        write_sum(ray, at);
        write_bounds(ray, at);
        if (ray.termination) {
            row(at, "ends", ended_text(tree_, ray));
        }
    }

    void write_share(const Ray& ray, const Place& at) {
        std::string text = triple_text(ray.weight) + " of the pixel";
        if (ray.attenuation != 1) {
            text += "; f(" + number_text(ray.hit ? ray.hit->t : 0) +
                    ") = " + number_text(ray.attenuation);
        }
        row(at, "share", text);
    }

    void write_sum(const Ray& ray, const Place& at) {
        const std::vector<Term> terms = terms_of(tree_, ray, children_[ray.id]);
        const std::size_t room = out_.room_after(at.body) - label_columns;
        for (const SumLine& line : sum_lines(ray.intensity, terms, room)) {
            out_.line(at.body, {{Style::label, padded(line.label, label_columns)},
                                {line.label.empty() ? Style::heading : Style::plain, line.text}});
        }
    }

    void write_branches(const Ray& ray, const Place& at, std::size_t left) {
        std::vector<const Ray*> branches;
        for (const std::size_t child : children_[ray.id]) {
            if (tree_.rays[child].shadow) {
                write_child(tree_.rays[child], at, --left == 0);
            } else {
                branches.push_back(&tree_.rays[child]);
            }
        }
        for (const RayKind kind : {RayKind::shadow, RayKind::reflected, RayKind::refracted}) {
            for (const Ray* branch : branches) {
                if (branch->kind == kind) {
                    write_child(*branch, at, --left == 0);
                }
            }
            for (const Skipped& skipped : ray.skipped) {
                if (skipped.kind == kind && !told_by_termination(ray, skipped)) {
                    write_absent(ray, skipped, at, --left == 0);
                }
            }
        }
    }

    void write_child(const Ray& child, const Place& at, bool last) {
        if (!child.shadow) {
            out_.line(at.branch + "│", {});
        }
        write_ray(child, at.branch + (last ? "└─ " : "├─ "), at.branch + (last ? "   " : "│  "));
    }

    void write_absent(const Ray& from, const Skipped& skipped, const Place& at, bool last) {
        const std::string kind(word_of(skipped.kind));
        const std::string target = skipped.light.empty() ? "" : " to " + skipped.light;
        out_.paragraph(at.branch + (last ? "└╌ " : "├╌ "), at.branch + (last ? "   " : "│  "),
                       {{Style::absent, "no " + kind + " ray" + target + ": " +
                                            skipped_text(tree_, from, skipped)}});
    }

    const RayTree<double>& tree_;
    std::vector<std::vector<std::size_t>> children_;
    const std::vector<RayBounds>* bounds_;
    StyledText out_;
};

}  // namespace

std::string write_tree_text(const RayTree<double>& tree, const OutlineOptions& options) {
    return Outline(tree, options).write();
}

}  // namespace raytree
