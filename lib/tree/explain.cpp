#include "tree/explain.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace raytree {
namespace {

constexpr int digits_shown = 4;

/// Independent of the locale, unlike printf.
std::string printed(std::chars_format format, int precision, double value) {
    std::array<char, 64> buffer;
    const auto end = std::to_chars(buffer.begin(), buffer.end(), value, format, precision).ptr;
    return {buffer.data(), end};
}

/// 0.2500 -> 0.25, 3.000 -> 3
void trim_zeros(std::string& text) {
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        text.erase(text.find_last_not_of('.') + 1);
    }
}

/// Whether the digits shown are all that there are. Input such as 0.1 is followed by rounding
/// errors once it has been multiplied, which are no digits that anyone wants to see.
bool is_exact(const std::string& shown, double value) {
    double read = 0;
    std::from_chars(shown.data(), shown.data() + shown.size(), read);
    return std::abs(read - value) <= 1e-12 * std::abs(value);
}

double degrees(double radians) { return radians * 180 / Real<double>::pi; }

std::string angle_of_sin2(double sin2) {
    return angle_text(std::sqrt(1 - std::clamp(sin2, 0.0, 1.0)));
}

Term plain_term(const char* symbols, const Rgb<double>& c) {
    return {symbols, {number_text(c.r), number_text(c.g), number_text(c.b)}, is_grey(c)};
}

Term branch_term(const RayTree<double>& tree, const TreeHit<double>& hit,
                 const TreeRay<double>& child) {
    const bool reflected = child.kind == RayKind::reflected;
    const bool attenuated = child.attenuation != 1;
    const Rgb<double>& coefficient = reflected ? hit.kr : hit.kt;
    Term term;
    const char* const k = !reflected ? "kt·" : kt_joins_kr(tree, hit) ? "(kr+kt)·" : "kr·";
    term.symbols = std::string(k) + (attenuated ? "f·" : "") + (reflected ? "Ir" : "It");
    for (std::size_t c = 0; c < 3; ++c) {
        term.numbers[c] = number_text(channels(coefficient)[c]) + "·" +
                          (attenuated ? number_text(child.attenuation) + "·" : "") +
                          number_text(channels(child.intensity)[c]);
    }
    term.grey = is_grey(coefficient) && is_grey(child.intensity);
    return term;
}

/// The largest component of the share that a branch would have had; empty where k is not known.
std::string refused_share(const TreeRay<double>& from, RayKind branch) {
    const Rgb<double>& k = branch == RayKind::reflected ? from.hit->kr : from.hit->kt;
    return is_zero(k) ? "" : number_text(largest_component(from.attenuation * (from.weight * k)));
}

/// The setting behind a reason; empty where it is not known: a tree that was read without its
/// settings has no bound either.
std::string setting_behind(const RayTree<double>& tree, Reason reason) {
    const Settings& settings = tree.settings;
    if (tree.counts.full_tree == 0) {
        return "";
    }
    switch (reason) {
        case Reason::max_depth:
            return "max_depth = " + std::to_string(settings.max_depth);
        case Reason::ray_budget:
            return "ray_budget = " + std::to_string(settings.ray_budget);
        case Reason::low_intensity:
            return "min_weight = " + number_text(settings.min_weight);
        case Reason::max_distance:
            return settings.max_distance ? "max_distance = " + number_text(*settings.max_distance)
                                         : "";
        default:
            return "";
    }
}

std::string listed(const std::string& a, const std::string& b) {
    return a + (a.empty() || b.empty() ? "" : ", ") + b;
}

std::string with_numbers(Reason reason, const std::string& numbers) {
    const std::string sentence(text_of(reason).sentence);
    return numbers.empty() ? sentence : sentence + " (" + numbers + ")";
}

}  // namespace

std::string number_text(double value) {
    if (value == 0) {
        return "0";
    }
    if (!std::isfinite(value)) {
        return std::isnan(value) ? "not a number" : value > 0 ? "infinite" : "-infinite";
    }
    // The exponent after rounding: 9.99996 has the digits of 10.
    const std::string scientific = printed(std::chars_format::scientific, digits_shown - 1, value);
    const std::size_t e = scientific.find('e');
    const int exponent = std::stoi(scientific.substr(e + 1));
    if (std::abs(value) < 1e-4 || std::abs(value) >= 1e6) {
        std::string mantissa = scientific.substr(0, e);
        if (is_exact(scientific, value)) {
            trim_zeros(mantissa);
        }
        return mantissa + "e" + std::to_string(exponent);
    }
    std::string text =
        printed(std::chars_format::fixed, std::max(0, digits_shown - 1 - exponent), value);
    if (is_exact(text, value)) {
        trim_zeros(text);
    }
    return text;
}

Rgb<double> noticed(const Rgb<double>& part, const Rgb<double>& sum) {
    const auto seen = [](double one, double all) {
        constexpr double rounding = std::numeric_limits<double>::epsilon() / 2;
        return std::abs(one) > rounding * std::abs(all) ? one : 0;
    };
    return {seen(part.r, sum.r), seen(part.g, sum.g), seen(part.b, sum.b)};
}

std::string triple_text(const Rgb<double>& c) {
    if (is_grey(c)) {
        return number_text(c.r);
    }
    return "(" + number_text(c.r) + ", " + number_text(c.g) + ", " + number_text(c.b) + ")";
}

bool is_grey(const Rgb<double>& c) {
    return number_text(c.r) == number_text(c.g) && number_text(c.g) == number_text(c.b);
}

std::string point_text(const Vec3<double>& p) {
    return "(" + number_text(p.x) + ", " + number_text(p.y) + ", " + number_text(p.z) + ")";
}

std::string angle_text(double cosine) {
    const double angle = degrees(std::acos(std::clamp(cosine, -1.0, 1.0)));
    // Near 0 the arc cosine of a rounded number has no digits worth showing.
    return number_text(angle < 5e-5 ? 0 : angle) + "°";
}

std::array<double, 3> channels(const Rgb<double>& c) { return {c.r, c.g, c.b}; }

std::vector<std::vector<std::size_t>> children_of(const RayTree<double>& tree) {
    std::vector<std::vector<std::size_t>> children(tree.rays.size());
    for (const TreeRay<double>& ray : tree.rays) {
        if (ray.parent) {
            children[*ray.parent].push_back(ray.id);
        }
    }
    return children;
}

bool kt_joins_kr(const RayTree<double>& tree, const TreeHit<double>& hit) {
    return hit.interface && hit.interface->sin2_transmitted > 1 && !is_zero(hit.kt) &&
           tree.settings.total_internal_reflection == TotalReflection::reflect;
}

std::vector<Term> terms_of(const RayTree<double>& tree, const TreeRay<double>& ray,
                           const std::vector<std::size_t>& children) {
    std::vector<Term> terms = {plain_term("ambient", noticed(ray.ambient, ray.intensity)),
                               plain_term("diffuse", noticed(ray.diffuse, ray.intensity)),
                               plain_term("specular", noticed(ray.specular, ray.intensity))};
    for (const std::size_t child : children) {
        if (tree.rays[child].kind != RayKind::shadow) {
            terms.push_back(branch_term(tree, *ray.hit, tree.rays[child]));
        }
    }
    return terms;
}

std::string refraction_text(const TreeHit<double>& hit) {
    const Interface<double>& at = *hit.interface;
    const std::string media = number_text(at.eta1) + " → " + number_text(at.eta2);
    const std::string in = angle_text(hit.cos_incident);
    if (at.sin2_transmitted <= 1) {
        return media + ", " + in + " → " + angle_of_sin2(at.sin2_transmitted) + " from the normal";
    }
    const double ratio = at.eta2 / at.eta1;
    std::string text = media + ", " + in + " → none: its sin² would be " +
                       number_text(at.sin2_transmitted) + " > 1";
    if (ratio < 1) {
        text += "; the critical angle is " + angle_of_sin2(ratio * ratio);
    }
    return text;
}

std::string skipped_text(const RayTree<double>& tree, const TreeRay<double>& from,
                         const Skipped& skipped) {
    std::string numbers = setting_behind(tree, skipped.reason);
    if (skipped.reason == Reason::low_intensity && from.hit) {
        const std::string share = refused_share(from, skipped.kind);
        numbers = listed(share.empty() ? "" : share + " at most", numbers);
    }
    return with_numbers(skipped.reason, numbers);
}

std::string ended_text(const RayTree<double>& tree, const TreeRay<double>& ray) {
    if (!ray.termination) {
        return "";
    }
    std::string numbers;
    for (const Skipped& branch : ray.skipped) {
        if (ray.hit && branch.reason == Reason::low_intensity) {
            const std::string share = refused_share(ray, branch.kind);
            numbers = listed(numbers,
                             share.empty() ? "" : std::string(word_of(branch.kind)) + " " + share);
        }
    }
    const bool low = *ray.termination == Reason::low_intensity;
    numbers = listed(low ? numbers : "", setting_behind(tree, *ray.termination));
    return (ray.hit ? "no branch is sent: " : "") + with_numbers(*ray.termination, numbers);
}

bool reaches_light(const TreeRay<double>& ray) {
    return ray.shadow && !ray.shadow->blocked_by && !is_zero(ray.shadow->transmittance);
}

std::string shadow_text(const TreeRay<double>& ray) {
    const ShadowPart<double>& shadow = *ray.shadow;
    const std::string away = shadow.distance ? ", " + number_text(*shadow.distance) + " away" : "";
    if (shadow.blocked_by) {
        return "is blocked by " + shadow.blocked_by->object +
               " at t = " + number_text(shadow.blocked_by->t) +
               (away.empty() ? "" : "; the light is" + away.substr(1));
    }
    if (!reaches_light(ray)) {
        return "does not reach it" + away;
    }
    if (shadow.transmittance == Rgb<double>(1)) {
        return "reaches it" + away;
    }
    return "reaches it" + away + ", through surfaces that let " +
           triple_text(shadow.transmittance) + " of the light pass";
}

bool told_by_termination(const TreeRay<double>& ray, const Skipped& skipped) {
    if (!ray.termination || skipped.kind == RayKind::shadow) {
        return false;
    }
    return std::ranges::all_of(ray.skipped, [&](const Skipped& other) {
        return other.kind == RayKind::shadow || other.reason == *ray.termination ||
               *ray.termination == Reason::opaque;
    });
}

}  // namespace raytree
