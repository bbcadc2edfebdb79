#include "state/contrast_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "check/align.h"
#include "check/describe.h"
#include "state/numbers.h"
#include "tree/explain.h"

namespace raytree::inspector {
namespace {

using What = Contrast::What;

// Relative; what is less is rounding.
constexpr double same_tracer = 1e-9, as_recorded = 1e-5;

/// What a ray becomes by others' differences alone.
bool is_passed_on(Field field) {
    return field == Field::intensity || field == Field::weight || field == Field::origin ||
           field == Field::light;
}
/// What the rays that are sent from a hit depend on.
bool is_handed_down(Field field) { return field <= Field::sin2_transmitted; }

bool is_decision(Field field) {
    return field == Field::object || field == Field::side || field == Field::blocked_by ||
           field == Field::termination;
}

RayMark mark_of_own(const Contrast& contrast) {
    return contrast.what == What::cut    ? RayMark::none
           : contrast.shown_is_reference ? RayMark::missing
                                         : RayMark::extra;
}
RayMark mark_of_graft(const Contrast& contrast) {
    return contrast.what == What::cut    ? RayMark::cut
           : contrast.shown_is_reference ? RayMark::extra
                                         : RayMark::missing;
}

/// Whether the file says nothing of such rays: then none of them is missing.
bool leaves_out(const std::shared_ptr<const check::Submission>& recorded,
                const TreeRay<double>& ray) {
    return recorded && ray.shadow && !recorded->has_shadow_rays;
}

/// Marks what has no counterpart; all else is the same until it turns out not to be.
void mark_presence(const PixelTree& shown, Contrast& contrast) {
    for (std::size_t ray = 0; ray < shown.tree.rays.size(); ++ray) {
        const bool graft = !shown.is_own(ray);
        const bool left_out = leaves_out(contrast.other_recorded, shown.tree.rays[ray]) ||
                              (graft && leaves_out(shown.recorded, shown.tree.rays[ray]));
        contrast.marks.push_back(left_out                      ? RayMark::same
                                 : graft                       ? mark_of_graft(contrast)
                                 : !contrast.counterparts[ray] ? mark_of_own(contrast)
                                 : contrast.what == What::cut  ? RayMark::none
                                                               : RayMark::same);
    }
}

std::string side_by_side(const check::FieldDifference& one, const Contrast& contrast) {
    const check::Value& before = contrast.shown_is_reference ? one.first : one.second;
    const check::Value& after = contrast.shown_is_reference ? one.second : one.first;
    const auto text = [](const check::Value& value) {
        return value.none() ? std::string("none") : check::value_text(value);
    };
    return std::string(check::text_of(one.field).name) + " " + text(before) + " → " + text(after);
}

/// The differences of a ray and its counterpart that are not only of what no one gave.
std::vector<check::FieldDifference> differences_of(const PixelTree& shown, const Contrast& contrast,
                                                   std::size_t ray) {
    const std::size_t other = *contrast.counterparts[ray];
    const bool is_recorded = shown.recorded || contrast.other_recorded;
    auto found = check::differences(shown.tree, ray, contrast.other, other,
                                    is_recorded ? as_recorded : same_tracer);
    std::erase_if(found, [&](const check::FieldDifference& one) {
        return (shown.recorded && !shown.recorded->gives(ray, one.field)) ||
               (contrast.other_recorded && !contrast.other_recorded->gives(other, one.field));
    });
    return found;
}

std::string absent_text(const PixelTree& shown, const Contrast& contrast, std::size_t ray,
                        RayMark mark) {
    const TreeRay<double>& one = shown.tree.rays[ray];
    return number_of(shown, contrast, ray) + " " + std::string(word_of(one.kind)) + " ray" +
           (one.shadow ? " to " + one.shadow->light : "") + " is " +
           std::string(text_of(mark).word);
}

/// The union's ray that a ray of the other tree is.
std::vector<std::size_t> places_of_other(const PixelTree& shown, const Contrast& contrast) {
    std::vector<std::size_t> places(contrast.other.rays.size());
    for (std::size_t ray = 0; ray < shown.tree.rays.size(); ++ray) {
        if (contrast.counterparts[ray]) {
            places[*contrast.counterparts[ray]] = ray;
        }
    }
    return places;
}

std::size_t place_of_missing(const PixelTree& shown, std::size_t parent,
                             const check::Finding& finding) {
    return check::corresponding(shown.tree, shown.children[parent], finding.kind, finding.light)
        .value_or(parent);
}

/// A ray that should not be there by the file's own numbers may be in the true tree all the same.
RayMark mark_of(const check::Finding& finding, bool in_both) {
    using check::Problem;
    return finding.problem == Problem::missing             ? RayMark::missing
           : finding.problem == Problem::extra && !in_both ? RayMark::extra
           : finding.follows_from                          ? RayMark::follows
                                                           : RayMark::different;
}

/// The report with the rays' numbers as the views have them, and beside them what the file calls
/// them where that is something else.
check::Report renumbered(const check::Report& report, const PixelTree& shown,
                         const Contrast& contrast, const std::vector<std::size_t>& places) {
    check::Report named = report;
    for (std::size_t k = 0; k < named.ids.size(); ++k) {
        const std::size_t ray = places.empty() ? k : places[k];
        const std::string number = number_of(shown, contrast, ray);
        std::string& id = named.ids[k];
        id = number == "#" + id ? number : number + " (the file's " + id + ")";
    }
    return named;
}

void put_causes_first(Contrast& contrast) {
    std::ranges::stable_partition(
        contrast.lines, [](const ContrastLine& line) { return line.mark != RayMark::follows; });
}

}  // namespace

void mark_by_findings(const PixelTree& shown, Contrast& contrast, const check::Report& report,
                      bool of_shown) {
    mark_presence(shown, contrast);
    const auto places = of_shown ? std::vector<std::size_t>() : places_of_other(shown, contrast);
    const check::Report named = renumbered(report, shown, contrast, places);
    const auto& recorded = of_shown ? shown.recorded : contrast.other_recorded;
    if (recorded && !recorded->has_shadow_rays) {
        contrast.remarks.push_back("The file has no shadow rays: they are not judged.");
    }
    std::vector<ContrastLine> following;
    for (const check::Finding& finding : report.findings) {
        const std::string text = check::sentence(finding, named);
        if (finding.problem == check::Problem::whole) {
            contrast.remarks.push_back(text);
            continue;
        }
        std::size_t ray = of_shown ? finding.ray : places[finding.ray];
        const bool in_both = shown.is_own(ray) && contrast.counterparts[ray];
        const RayMark mark = mark_of(finding, in_both);
        if (finding.problem == check::Problem::missing) {
            ray = place_of_missing(shown, ray, finding);
        }
        RayMark& drawn = contrast.marks[ray];
        if (drawn == RayMark::same || (drawn == RayMark::follows && mark == RayMark::different)) {
            drawn = mark;
        }
        auto& list = finding.follows_from ? following : contrast.lines;
        // What is said of a ray that only one of them has bears the sign of that.
        const bool alone = drawn == RayMark::extra;
        list.push_back({ray,
                        alone || !finding.follows_from ? (alone ? drawn : mark) : RayMark::follows,
                        text});
    }
    contrast.lines.insert(contrast.lines.end(), following.begin(), following.end());
    for (const check::NamedMistake& mistake : report.mistakes) {
        contrast.remarks.push_back((mistake.sure ? "" : "Perhaps: ") + mistake.text);
    }
    if (std::ranges::find(report.findings, check::Problem::differs, &check::Finding::problem) !=
        report.findings.end()) {
        contrast.remarks.push_back(
            "“Must be” is what follows from the file's own numbers before it.");
    }
    if (report.profile != "lecture") {
        contrast.remarks.push_back("Judged by the conventions “" + report.profile + "”.");
    }
}

void mark_by_numbers(const PixelTree& shown, Contrast& contrast) {
    mark_presence(shown, contrast);
    if (contrast.what == What::cut) {
        return;
    }
    std::vector<bool> handed_down(shown.tree.rays.size()), reweighted(shown.tree.rays.size());
    for (const TreeRay<double>& ray : shown.tree.rays) {
        RayMark& mark = contrast.marks[ray.id];
        if (mark != RayMark::same) {
            const bool first = !ray.parent || contrast.marks[*ray.parent] != mark;
            contrast.lines.push_back({ray.id, first ? mark : RayMark::follows,
                                      absent_text(shown, contrast, ray.id, mark)});
            continue;
        }
        auto found = differences_of(shown, contrast, ray.id);
        if (contrast.what == What::pixel) {
            std::erase_if(found, [](const auto& one) { return !is_decision(one.field); });
        }
        if (found.empty()) {
            continue;
        }
        const bool from_above = ray.parent && handed_down[*ray.parent];
        const auto has = [&](Field field) {
            return std::ranges::find(found, field, &check::FieldDifference::field) != found.end();
        };
        reweighted[ray.id] = has(Field::weight) || has(Field::attenuation);
        // Of a ray that weighs something else though the one above does not, kr or kt is other.
        const bool own_weight = has(Field::weight) && ray.parent && !reweighted[*ray.parent];
        const auto is_own = [&](const check::FieldDifference& one) {
            return !is_passed_on(one.field) || (own_weight && one.field == Field::weight);
        };
        const bool own = std::ranges::any_of(found, is_own);
        handed_down[ray.id] =
            std::ranges::any_of(found, [](const auto& one) { return is_handed_down(one.field); });
        mark = own && !from_above ? RayMark::different : RayMark::follows;
        const auto first = std::ranges::find_if(found, is_own);
        const auto& told = first == found.end() ? found.front() : *first;
        std::string text = number_of(shown, contrast, ray.id) + " " +
                           std::string(word_of(ray.kind)) + " ray: " + side_by_side(told, contrast);
        if (found.size() > 1) {
            text += ", and " + std::to_string(found.size() - 1) + " more";
        }
        contrast.lines.push_back({ray.id, mark, std::move(text)});
    }
    put_causes_first(contrast);
}

std::string summary_of(const Contrast& contrast) {
    const auto count = [&](RayMark mark) { return std::ranges::count(contrast.marks, mark); };
    const auto causes = count(RayMark::different), follow = count(RayMark::follows);
    const auto extra = count(RayMark::extra);
    // Where it would stand is not known of every ray that a file lacks.
    const auto missing =
        count(RayMark::missing) + std::ranges::count_if(contrast.lines, [&](const auto& line) {
            return line.mark == RayMark::missing && contrast.marks[line.ray] != RayMark::missing;
        });
    if (causes + follow + missing + extra == 0) {
        return contrast.lines.empty()
                   ? "Every ray is the same in both."
                   : "The rays are the same in both, but for what is said below.";
    }
    const auto same = count(RayMark::same);
    // Of two pixels no number is the same: what is compared is where rays go.
    const char* const alike =
        contrast.what == What::pixel ? " to the same things, " : " the same, ";
    std::string text = std::to_string(same) + (same == 1 ? " ray" : " rays") + alike +
                       std::to_string(causes + follow) + " different";
    if (causes + follow > 0) {
        text += " (" + std::to_string(causes) + " where it begins, " + std::to_string(follow) +
                (follow == 1 ? " that follows)" : " that follow)");
    }
    return text + ", " + std::to_string(missing) + " missing, " + std::to_string(extra) + " extra.";
}

namespace {

constexpr int usual_digits = 6, most_digits = 17;

DetailRow words(std::string label, std::string cell) {
    DetailRow row{std::move(label), {std::move(cell)}, DetailRow::Weight::normal, true, {}};
    return row;
}

/// Numbers in their columns, to be copied in full.
DetailRow value_row(std::string label, const check::Value& value) {
    if (value.numbers.size == 0) {
        return words(std::move(label), value.none() ? "none" : check::value_text(value));
    }
    const std::span numbers(value.numbers.x.data(), static_cast<std::size_t>(value.numbers.size));
    return {std::move(label),
            aligned(numbers, usual_digits),
            DetailRow::Weight::normal,
            false,
            {},
            {numbers.begin(), numbers.end()}};
}

/// What the sum does not notice is shown as 0, as where raytree says what it has summed up.
bool is_summand(Field field) {
    return field == Field::ambient || field == Field::diffuse || field == Field::specular;
}

/// ", red" or ", x"; nothing for a number that stands alone.
std::string component_name(Field field, int size, std::size_t k) {
    constexpr std::array<const char*, 3> axes = {"x", "y", "z"};
    const bool in_space = field == Field::origin || field == Field::direction ||
                          field == Field::point || field == Field::normal;
    if (size != 3) {  // of two, the refractive indices
        return size == 1 ? "" : k == 0 ? ", η1" : ", η2";
    }
    return std::string(", ") + (in_space ? axes[k] : channel_names[k]);
}

/// Two numbers that look alike, below each other with so many digits that they do not.
void add_closely(const std::string& name, double here, double there, std::vector<DetailRow>& rows) {
    const auto text = [](double value, int digits) {
        return aligned(std::array{value}, digits).front();
    };
    int digits = usual_digits;
    while (digits < most_digits && text(here, digits) == text(there, digits)) {
        ++digits;
    }
    rows.push_back(words("   here" + name, text(here, digits)));
    rows.back().values = {here};
    rows.push_back(words("   there" + name, text(there, digits)));
    rows.back().values = {there};
}

/// What a quantity is in both trees. Where the two look alike, the numbers that make the
/// difference, each on a line: with more digits three do not fit beside each other.
void add_both(const check::FieldDifference& one, std::vector<DetailRow>& rows) {
    rows.push_back(words("≠ " + std::string(check::text_of(one.field).name), ""));
    const check::Numbers &here = one.first.numbers, &there = one.second.numbers;
    const DetailRow shown = value_row("   here", one.first);
    const DetailRow other = value_row("   there", one.second);
    if (shown.cells != other.cells || here.size == 0 || here.size != there.size) {
        rows.push_back(shown);
        rows.push_back(other);
        return;
    }
    constexpr double part = 1e-3;  // of the largest difference: what is less is rounding
    double largest = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(here.size); ++k) {
        largest = std::max(largest, std::abs(here.x[k] - there.x[k]));
    }
    for (std::size_t k = 0; k < static_cast<std::size_t>(here.size); ++k) {
        if (std::abs(here.x[k] - there.x[k]) >= part * largest) {
            add_closely(component_name(one.field, here.size, k), here.x[k], there.x[k], rows);
        }
    }
}

}  // namespace

std::vector<DetailSection> contrast_details(const PixelTree& tree, std::size_t ray) {
    const Contrast& contrast = *tree.contrast;
    const RayMark mark = contrast.marks[ray];
    DetailSection section{"Beside " + contrast.other_name, {}, {}};
    if (mark == RayMark::none) {
        return {};
    }
    if (!contrast.counterparts[ray] || !tree.is_own(ray)) {
        section.sentences.push_back(
            mark == RayMark::cut
                ? "╌ This ray was there before the change; the numbers are those it had."
                : std::string(text_of(mark).sign) + " This ray is " +
                      std::string(text_of(mark).word) + ": only " +
                      (tree.is_own(ray) ? contrast.shown_name : contrast.other_name) + " has it.");
        return {section};
    }
    const auto found = differences_of(tree, contrast, ray);
    if (found.empty()) {
        section.sentences.push_back("= Nothing is different in " + number_of(tree, ray) +
                                    " and its counterpart #" +
                                    std::to_string(*contrast.counterparts[ray]) + ".");
    }
    for (const check::FieldDifference& one : found) {
        add_both(one, section.rows);
    }
    for (const ContrastLine& line : contrast.lines) {
        if (line.ray == ray && contrast.what == What::file) {
            section.sentences.push_back(std::string(text_of(line.mark).sign) + " " + line.text);
        }
    }
    return {section};
}

DetailSection recorded_details(const PixelTree& tree, std::size_t ray) {
    const check::Submission& recorded = *tree.recorded;
    DetailSection section{"As recorded in the file", {}, {}};
    section.rows.push_back(words("its name", recorded.ids[ray]));
    const TreeRay<double>& one = tree.tree.rays[ray];
    const std::size_t whole = one.shadow && one.parent ? *one.parent : ray;  // what it is a part of
    std::string absent;
    for (std::size_t k = 0; k < field_count; ++k) {
        const Field field = static_cast<Field>(k);
        const check::Value value = check::value_of(tree.tree, ray, field);
        const std::string name(check::text_of(field).name);
        if (recorded.gives(ray, field) && !value.none()) {
            section.rows.push_back(value_row(name, value));
            if (is_summand(field) && recorded.gives(whole, Field::intensity)) {
                const Rgb<double>& sum = tree.tree.rays[whole].intensity;
                const auto& x = value.numbers.x;
                section.rows.back().cells = aligned_with(sum, noticed({x[0], x[1], x[2]}, sum));
            }
        } else if (!recorded.gives(ray, field) && !value.none()) {
            absent += (absent.empty() ? "" : ", ") + name;
        }
    }
    if (!absent.empty()) {
        section.sentences.push_back("Not in the file: " + absent + ".");
    }
    return section;
}

}  // namespace raytree::inspector
