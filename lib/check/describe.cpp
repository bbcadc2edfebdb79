#include "check/describe.h"

#include <array>
#include <cstdio>

#include "scene/utf8.h"

namespace raytree::check {
namespace {

constexpr std::size_t longest_text = 300;

constexpr std::array<FieldText, field_count> field_texts = {{
    {"origin", "the eye for the primary ray, else the point that the parent hits",
     "rays and their origins"},
    {"direction",
     "primary: normalize(P - E); reflected: d - 2 (d . n) n; refracted: eta d + "
     "(eta c1 - sqrt(1 - s2)) n; shadow: normalize(light - point)",
     "directions of rays"},
    {"weight", "weight(parent) f(parent) k, k = kr or kt", "recursion"},
    {"hit", "the nearest intersection with t > 0", "intersection"},
    {"object", "the object of the nearest intersection with t > 0", "intersection"},
    {"t", "the smallest positive root, along a unit direction", "intersection"},
    {"point", "origin + t direction", "intersection"},
    {"normal", "sphere: (p - centre) / radius; turned so that d . n < 0", "normals"},
    {"side", "front where d . n_g < 0, else back", "normals"},
    {"cos_incident", "-d . n", "normals"},
    {"eta", "the indices on the ray's side and beyond; from inside they change places",
     "refraction"},
    {"sin2_transmitted", "(eta1 / eta2)^2 (1 - c1^2)", "refraction"},
    {"ambient", "ka color (scene ambient)", "local illumination"},
    {"light", "a shadow ray for each light", "shadows"},
    {"distance", "|light - point|", "shadows"},
    {"blocked_by", "any object at 0 < t < distance", "shadows"},
    {"transmittance", "1, or 0 where the light is blocked", "shadows"},
    {"diffuse", "kd color I (n . L), summed over the lights that are seen", "local illumination"},
    {"specular", "ks specular_color I h^shininess, h = max(0, R . V) or max(0, n . H)",
     "local illumination"},
    {"attenuation", "min(1, 1 / (a + b t + c t^2))", "attenuation"},
    {"intensity",
     "ambient + diffuse + specular + kr f Ir + kt f It; background where nothing is "
     "hit",
     "evaluation of the tree"},
    {"termination", "the reason why neither branch is grown", "recursion"},
}};

/// By which the finding's quantity is computed.
std::string formula_of(const Finding& finding) {
    const bool primary = finding.kind == RayKind::primary;
    if (finding.field == Field::origin) {
        return primary ? "the eye" : "the point that the parent hits";
    }
    if (finding.field == Field::direction) {
        switch (finding.kind) {
            case RayKind::primary:
                return "normalize(P - E), P the pixel's point on the image plane";
            case RayKind::reflected:
                return "d - 2 (d . n) n";
            case RayKind::refracted:
                return "eta d + (eta c1 - sqrt(1 - s2)) n, made unit";
            default:
                return "normalize(light - point)";
        }
    }
    return std::string(text_of(finding.field).formula);
}

std::string number(double x) {
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", x);
    return text;
}

std::string a_ray(RayKind kind) { return std::string(word_of(kind)) + " ray"; }

}  // namespace

const FieldText& text_of(Field field) { return field_texts[place_of(field)]; }

std::string harmless(std::string_view text) {
    if (text.size() <= longest_text) {
        return legible(text);
    }
    std::size_t end = longest_text;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) {
        --end;  // not within a character
    }
    return legible(text.substr(0, end)) + "...";
}

std::string quantity_of(const Finding& finding) {
    switch (finding.problem) {
        case Problem::differs:
            return std::string(word_of(finding.field));
        case Problem::whole:
            return finding.subject.empty() ? "file" : harmless(finding.subject);
        default:
            return "ray";
    }
}

std::string value_text(const Value& value) {
    if (value.none()) {
        return "nothing";
    }
    if (!value.word.empty()) {
        return harmless(value.word);
    }
    std::string text;
    for (int k = 0; k < value.numbers.size; ++k) {
        text += (k == 0 ? "" : ", ") + number(value.numbers.x[static_cast<std::size_t>(k)]);
    }
    return value.numbers.size == 1 ? text : '(' + text + ')';
}

std::string ray_text(const Finding& finding, const Report& report) {
    const std::string id = finding.ray < report.ids.size() ? harmless(report.ids[finding.ray]) : "";
    const bool shadow = finding.kind == RayKind::shadow && !finding.light.empty();
    return "ray " + id + " (" + std::string(word_of(finding.kind)) +
           (shadow ? " to " + harmless(finding.light) : "") + ", level " +
           std::to_string(finding.level) + ")";
}

std::string sentence(const Finding& finding, const Report& report) {
    switch (finding.problem) {
        case Problem::whole:
            return (finding.subject.empty() ? "" : harmless(finding.subject) + ": ") +
                   harmless(finding.reason);
        case Problem::missing:
            return "ray " + harmless(report.ids[finding.ray]) + " lacks its " +
                   a_ray(finding.kind) +
                   (finding.light.empty() ? "" : " to " + harmless(finding.light));
        case Problem::extra:
            return ray_text(finding, report) + " should not be there: " + harmless(finding.reason);
        default:
            break;
    }
    return ray_text(finding, report) + ": " + std::string(text_of(finding.field).name) + " is " +
           value_text(finding.found) + ", must be " + value_text(finding.expected);
}

std::string rationale(const Finding& finding) {
    switch (finding.problem) {
        case Problem::whole:
            return "It concerns the submission as a whole.";
        case Problem::missing:
            return "A ray is due here by the tree's own numbers: " +
                   std::string(finding.kind == RayKind::shadow
                                   ? "the light is in front of a surface that it can light."
                                   : "the coefficient is not 0 and nothing ends the branch.");
        case Problem::extra:
            return "No ray is due here: " + harmless(finding.reason) + ".";
        default:
            break;
    }
    if (finding.follows_from) {
        return "It follows from its own inputs, which are wrong by an earlier difference.";
    }
    return "It does not follow from the ray's own inputs by " + formula_of(finding) +
           " (lecture: " + std::string(text_of(finding.field).topic) + ").";
}

Hints hints(const Finding& finding, const Report& report) {
    Hints hints;
    if (finding.problem == Problem::whole) {
        hints.where = hints.quantity = hints.formula = sentence(finding, report);
        return hints;
    }
    hints.where = "Look at " + ray_text(finding, report) + '.';
    if (finding.problem == Problem::missing) {
        hints.where = "Look at what ray " + harmless(report.ids[finding.ray]) + " sends.";
        hints.quantity = "It should send a " + a_ray(finding.kind) + '.';
        hints.formula =
            finding.kind == RayKind::shadow
                ? "A shadow ray is due where the light is in front of a surface that it can light."
                : "A branch is grown where its coefficient is not 0, unless the depth, the "
                  "weight or total reflection ends it.";
    } else if (finding.problem == Problem::extra) {
        hints.quantity = "Should this ray be sent at all?";
        hints.formula = "No ray is due here: " + harmless(finding.reason) + '.';
    } else {
        const FieldText& text = text_of(finding.field);
        hints.quantity = "Its " + std::string(text.name) + " does not follow from its own inputs.";
        hints.formula = std::string(text.name) + " = " + formula_of(finding);
    }
    return hints;
}

std::string_view word_of(Verdict verdict) {
    constexpr std::array<std::string_view, 3> words = {"pass", "fail", "unreadable"};
    return words[static_cast<std::size_t>(verdict)];
}

}  // namespace raytree::check
