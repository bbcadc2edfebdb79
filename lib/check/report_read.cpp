#include "check/report.h"
#include "formats/json_members.h"
#include "formats/json_text.h"

namespace raytree::check {
namespace {

/// A number, a string, a list of numbers or `null`, as reports have them.
std::string json_text(const Json& value) {
    if (value.is_string()) {
        return json_string(value.get_ref<const std::string&>());
    }
    if (value.is_number()) {
        return json_number(value.get<double>());
    }
    if (!value.is_array()) {
        return "null";
    }
    std::string text;
    for (const Json& number : value) {
        text += (text.empty() ? "" : ", ") + json_text(number);
    }
    return '[' + text + ']';
}

std::string json_of(const OptionalMembers& in, std::string_view key) {
    return in.gives(key) ? json_text(*in.reader().find(key)) : "null";
}

PrintedFinding read_finding(const OptionalMembers& in) {
    PrintedFinding out;
    out.ray = json_of(in, "ray");
    in.text("kind", out.kind);
    in.text("quantity", out.quantity);
    out.expected = json_of(in, "expected");
    out.found = json_of(in, "found");
    in.number("relative_error", out.relative_error);
    std::size_t cause = 0;
    if (in.count("follows_from", cause)) {
        out.follows_from = cause;
    }
    in.text("text", out.text);
    in.text("rationale", out.rationale);
    in.object("hints", [&](const OptionalMembers& hints) {
        hints.text("where", out.where);
        hints.text("quantity", out.what);
        hints.text("formula", out.formula);
    });
    out.of_the_whole = out.kind.empty();
    return out;
}

void read_texts(const OptionalMembers& in, std::string_view key, std::vector<std::string>& out) {
    const Json* const list = in.reader().find(key);
    for (const Json& text : list && list->is_array() ? *list : Json::array()) {
        out.push_back(text.is_string() ? text.get<std::string>() : "");
    }
}

NamedMistake read_mistake(const OptionalMembers& in) {
    NamedMistake out;
    in.text("id", out.id);
    in.reader().truth("sure", out.sure, Need::optional);
    in.count("rays_explained", out.rays);
    read_texts(in, "ties", out.ties);
    in.text("text", out.text);
    in.text("topic", out.topic);
    in.text("lesson", out.lesson);
    return out;
}

PrintedConvention read_convention(const OptionalMembers& in) {
    PrintedConvention out;
    in.text("axis", out.axis);
    in.text("value", out.value);
    in.text("text", out.text);
    in.text("mistake_elsewhere", out.mistake);
    return out;
}

Points read_points(const OptionalMembers& in) {
    Points out;
    in.number("earned", out.earned);
    in.number("total", out.total);
    in.list("rows", [&](const OptionalMembers& row) {
        PointsRow& read = out.rows.emplace_back();
        row.text("quantity", read.quantity);
        row.text("kind", read.kind);
        std::size_t level = 1;
        row.count("level", level);
        read.level = static_cast<int>(level);
        row.count("compared", read.compared);
        row.count("right", read.right);
        row.number("points", read.points);
        row.number("of", read.of);
    });
    return out;
}

Printed read_submission(const OptionalMembers& in) {
    Printed out;
    in.reader().text("file", out.file, Need::required);
    constexpr std::array<std::string_view, 3> verdicts = {"pass", "fail", "unreadable"};
    std::size_t verdict = 0;
    in.reader().choice("verdict", {verdicts.begin(), verdicts.end()}, verdict, Need::required);
    out.verdict = verdicts[verdict];
    in.text("profile", out.profile);
    in.reader().truth("profile_asked_for", out.profile_asked_for, Need::optional);
    in.number("score", out.score);
    in.count("rays", out.rays);
    in.count("compared", out.compared);
    in.text("compares", out.compares);
    in.text("precision", out.precision);
    in.object("points", [&](const OptionalMembers& points) { out.points = read_points(points); });
    in.list("findings", [&](const OptionalMembers& f) { out.findings.push_back(read_finding(f)); });
    in.list("mistakes", [&](const OptionalMembers& m) { out.mistakes.push_back(read_mistake(m)); });
    in.list("conventions",
            [&](const OptionalMembers& c) { out.conventions.push_back(read_convention(c)); });
    read_texts(in, "telling_pixels", out.telling_pixels);
    read_texts(in, "remarks", out.remarks);
    return out;
}

}  // namespace

std::vector<Printed> read_report(const std::string& text, const std::filesystem::path& file) {
    JsonReport report;
    report.file = file.string();
    const Json document = parse_json(text, report.file);
    check_json_format(document, "raytree-report", 1, 0, report);
    const JsonPlace top;
    const OptionalMembers in(document, top, report);
    in.reader().need("submissions", "a list of objects");
    std::vector<Printed> submissions;
    in.list("submissions",
            [&](const OptionalMembers& each) { submissions.push_back(read_submission(each)); });
    if (!report.mistakes.empty()) {
        throw InputError(std::move(report.mistakes));
    }
    return submissions;
}

}  // namespace raytree::check
