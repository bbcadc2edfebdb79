#include <algorithm>

#include "check/describe.h"
#include "check/report.h"
#include "formats/json_reader.h"
#include "formats/json_text.h"

namespace raytree::check {
namespace {

std::string value_json(const Value& value) {
    // A product of what a submission gives may be too large for a number.
    const auto& x = value.numbers.x;
    if (!isfinite(x[0]) || !isfinite(x[1]) || !isfinite(x[2])) {
        return json_string("too large");
    }
    if (!value.word.empty()) {
        return json_string(harmless(value.word));
    }
    if (value.numbers.size == 0) {
        return "null";
    }
    std::string text;
    for (int k = 0; k < value.numbers.size; ++k) {
        text += (k == 0 ? "" : ", ") + json_number(x[static_cast<std::size_t>(k)]);
    }
    return value.numbers.size == 1 ? text : '[' + text + ']';
}

/// An id is a number or a string, as the submission has it as far as that can be told.
std::string id_json(const std::string& id) {
    const bool number = !id.empty() && id.size() < 10 && (id == "0" || id.front() != '0') &&
                        id.find_first_not_of("0123456789") == std::string::npos;
    return number ? id : json_string(harmless(id));
}

PrintedFinding printed(const Finding& finding, const Report& report) {
    PrintedFinding out;
    out.of_the_whole = finding.problem == Problem::whole || finding.ray >= report.ids.size();
    if (!out.of_the_whole) {
        out.ray = id_json(report.ids[finding.ray]);
        out.kind = word_of(finding.kind);
    }
    out.quantity = quantity_of(finding);
    out.expected = value_json(finding.expected);
    out.found = value_json(finding.found);
    out.relative_error = isfinite(finding.error) ? finding.error : 1;
    out.follows_from = finding.follows_from;
    out.text = sentence(finding, report);
    out.rationale = rationale(finding);
    const Hints hint = hints(finding, report);
    out.where = hint.where;
    out.what = hint.quantity;
    out.formula = hint.formula;
    return out;
}

}  // namespace

std::size_t Printed::causes() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(findings, [](const auto& f) { return !f.follows_from; }));
}

Printed printed(const Report& report, const Rubric* rubric) {
    Printed out;
    out.file = harmless(report.file);
    out.verdict = word_of(report.verdict);
    out.profile = report.profile;
    out.score = report.score;
    out.rays = report.rays;
    out.compared = report.compared;
    out.precision = report.precision;
    out.compares = report.compares;
    out.mistakes = report.mistakes;
    out.profile_asked_for = report.profile_asked_for;
    for (const Finding& finding : report.findings) {
        out.findings.push_back(printed(finding, report));
    }
    for (const Convention* c : report.conventions) {
        out.conventions.push_back({std::string(c->axis), std::string(c->value),
                                   std::string(c->text), std::string(c->mistake)});
    }
    for (const std::string& remark : report.remarks) {
        out.remarks.push_back(harmless(remark));
    }
    out.telling_pixels = report.telling_pixels;
    if (rubric) {
        out.points = points_of(report, *rubric);
    }
    return out;
}

}  // namespace raytree::check
