#include <algorithm>
#include <functional>
#include <map>

#include "check/catalogue.h"
#include "check/picture_mistakes.h"
#include "check/report.h"
#include "check/report_json.h"
#include "check/report_text.h"
#include "formats/json_text.h"

namespace raytree::check {
namespace {

/// Every line further in.
std::string indented(const std::string& text, const std::string& by) {
    std::string out = by;
    for (const char c : text) {
        out += c;
        out += c == '\n' ? by : "";
    }
    return out;
}

std::size_t count_of(const std::vector<Summary>& all, std::string_view verdict) {
    return static_cast<std::size_t>(std::ranges::count(all, verdict, &Summary::verdict));
}

/// In percent: of the points, where a rubric gives some.
double score_of(const std::vector<Summary>& all) {
    double score = 0, earned = 0, total = 0;
    for (const Summary& each : all) {
        score += each.score;
        earned += each.earned;
        total += each.total;
    }
    return all.empty()
               ? 0
               : 100 * (total > 0 ? earned / total : score / static_cast<double>(all.size()));
}

/// What is wrong, in words.
std::string sentence_of(const std::string& id) {
    if (const MistakeRow* const row = find_mistake(id)) {
        return std::string(row->text);
    }
    const auto rows = picture_mistakes();
    const auto row = std::ranges::find(rows, id, &PictureMistakeRow::id);
    return row == rows.end() ? "" : std::string(row->text);
}

/// Those that say something there; the largest group first, of equals by what they say.
std::vector<Group> grouped_by(const std::vector<Summary>& all, std::string Summary::*what) {
    std::map<std::string, std::vector<std::string>> files_of;
    for (const Summary& each : all) {
        if (!(each.*what).empty()) {
            files_of[each.*what].push_back(each.file);
        }
    }
    std::vector<Group> groups;
    for (auto& [id, files] : files_of) {
        groups.push_back({id, std::move(files)});
    }
    std::ranges::stable_sort(groups, std::greater<>(),
                             [](const Group& group) { return group.files.size(); });
    return groups;
}

std::string words_of_all(const std::vector<Summary>& all) {
    if (all.size() < 2) {
        return "";
    }
    const std::string of = " of " + std::to_string(all.size());
    std::string text = std::to_string(count_of(all, "pass")) + of + " pass\n";
    for (const Group& group : groups_of(all)) {
        text += "  " + std::to_string(group.files.size()) + of + ": " + sentence_of(group.id) +
                " [" + group.id + "]\n";
    }
    for (const Group& group : grouped_by(all, &Summary::conventions)) {
        text += "  " + std::to_string(group.files.size()) + of +
                " pass by conventions that are not the lecture's: " + group.id + '\n';
    }
    return text;
}

}  // namespace

Summary summary_of(const Printed& of) {
    Summary summary;
    summary.file = of.file;
    summary.verdict = of.verdict;
    summary.mistake = of.mistakes.empty() ? "" : of.mistakes.front().id;
    summary.conventions = of.verdict == "pass" ? conventions_of(of) : "";
    summary.score = of.score;
    if (of.points) {
        summary.earned = of.points->earned;
        summary.total = of.points->total;
    }
    return summary;
}

std::vector<Group> groups_of(const std::vector<Summary>& all) {
    return grouped_by(all, &Summary::mistake);
}

std::string ReportSheet::part(const Printed& of) const {
    switch (format_) {
        case ReportFormat::json:
            return indented(json_of(of), "    ");
        case ReportFormat::gradescope:
            return indented(gradescope_of(of, words_of(of, telling_, most_findings_)), "    ");
        case ReportFormat::junit:
            return junit_case_of(of);
        case ReportFormat::csv:
            return csv_row_of(of);
        default:
            return words_of(of, telling_, most_findings_);
    }
}

std::string_view ReportSheet::separator() const {
    return format_ == ReportFormat::json || format_ == ReportFormat::gradescope ? ",\n" : "";
}

std::string ReportSheet::head(const std::vector<Summary>& all) const {
    const std::string opened = all.empty() ? "[" : "[\n";
    switch (format_) {
        case ReportFormat::json:
            return "{\n  \"format\": \"raytree-report/1.0\",\n  \"submissions\": " + opened;
        case ReportFormat::gradescope:
            return "{\n  \"score\": " + json_number(score_of(all)) + ",\n  \"tests\": " + opened;
        case ReportFormat::junit:
            return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"raytree check\" "
                   "tests=\"" +
                   std::to_string(all.size()) + "\" failures=\"" +
                   std::to_string(count_of(all, "fail")) + "\" errors=\"" +
                   std::to_string(count_of(all, "unreadable")) + "\">\n";
        case ReportFormat::csv:
            return "file,verdict,score,points,profile,conventions,rays,compared,causes,mistake,"
                   "sure,first\n";
        default:
            return "";
    }
}

std::string ReportSheet::tail(const std::vector<Summary>& all) const {
    const std::string closed = all.empty() ? "]" : "\n  ]";
    switch (format_) {
        case ReportFormat::json:
            return closed +
                   ",\n  \"groups\": " + indented(json_of(groups_of(all)), "  ").substr(2) +
                   "\n}\n";
        case ReportFormat::gradescope:
            return closed + "\n}\n";
        case ReportFormat::junit:
            return "</testsuite>\n";
        case ReportFormat::csv:
            return "";
        default:
            return words_of_all(all);
    }
}

std::string write_report(const std::vector<Report>& reports, ReportFormat format) {
    const ReportSheet sheet(format);
    std::vector<Summary> all;
    std::string parts;
    for (const Report& report : reports) {
        const Printed each = printed(report);
        all.push_back(summary_of(each));
        parts += (parts.empty() ? "" : std::string(sheet.separator())) + sheet.part(each);
    }
    return sheet.head(all) + parts + sheet.tail(all);
}

}  // namespace raytree::check
