#include <algorithm>
#include <cstdio>
#include <map>

#include "check/describe.h"
#include "check/report.h"
#include "formats/xml_text.h"

namespace raytree::check {
namespace {

std::string percent(double share) {
    char text[20];
    std::snprintf(text, sizeof text, "%.0f %%", 100 * share);
    return text;
}

std::string headline(const Report& report) {
    std::string line = harmless(report.file) + ": " + std::string(word_of(report.verdict));
    if (report.verdict == Verdict::unreadable) {
        return line;
    }
    line += ", " + std::to_string(report.rays) + (report.rays == 1 ? " ray, " : " rays, ") +
            std::to_string(report.compared) + " quantities compared";
    if (report.verdict == Verdict::fail) {
        line += ", " + percent(report.score) + " right";
    }
    return line + ", by the profile " + report.profile +
           (report.precision == "double" ? "" : ", numbers are " + report.precision);
}

/// Causes with all that hangs on them counted, not listed.
std::string causes_text(const Report& report, std::size_t most) {
    std::string text;
    std::size_t listed = 0;
    for (std::size_t k = 0; k < report.findings.size(); ++k) {
        const Finding& finding = report.findings[k];
        if (finding.follows_from) {
            continue;
        }
        if (++listed > most) {
            return text + "  and " + std::to_string(report.causes() - most) + " more\n";
        }
        text += "  " + std::to_string(listed) + ". " + sentence(finding, report) + '\n';
        const auto followers = std::ranges::count_if(
            report.findings, [k](const Finding& f) { return f.follows_from == k; });
        if (followers > 0) {
            text += "     " + std::to_string(followers) +
                    (followers == 1 ? " other difference follows" : " other differences follow") +
                    " from it\n";
        }
        if (finding.problem != Problem::whole) {
            text += "     " + hints(finding, report).formula + '\n';
        }
    }
    return text;
}

std::string mistakes_text(const Report& report) {
    std::string text;
    for (const NamedMistake& mistake : report.mistakes) {
        text += std::string("  ") + (mistake.sure ? "The mistake" : "Perhaps") + ": " +
                mistake.text + " [" + mistake.id + "]\n";
        text += "     explains " + std::to_string(mistake.rays) +
                (mistake.rays == 1 ? " ray" : " rays") + "; see the lecture on " + mistake.topic +
                '\n';
        if (!mistake.ties.empty()) {
            text += "     the same numbers would come from";
            for (const std::string& tie : mistake.ties) {
                text += (&tie == &mistake.ties.front() ? " " : ", ") + tie;
            }
            text += '\n';
        }
    }
    return text;
}

/// A field of a CSV row: quoted, and never a formula of a spreadsheet.
std::string cell(const std::string& text) {
    std::string safe = harmless(text);
    if (!safe.empty() && std::string_view("=+-@").find(safe.front()) != std::string_view::npos) {
        safe.insert(0, 1, '\'');
    }
    std::string quoted = "\"";
    for (const char c : safe) {
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    }
    return quoted + '"';
}

std::string xml(std::string_view text) { return xml_text(harmless(text)); }

std::string first_cause(const Report& report) {
    return report.findings.empty() ? "" : sentence(report.findings.front(), report);
}

}  // namespace

std::vector<Group> groups_of(const std::vector<Report>& reports) {
    std::map<std::string, std::vector<std::string>> by_id;
    for (const Report& report : reports) {
        if (!report.mistakes.empty()) {
            by_id[report.mistakes.front().id].push_back(report.file);
        }
    }
    std::vector<Group> groups;
    for (auto& [id, files] : by_id) {
        groups.push_back({id, std::move(files)});
    }
    std::ranges::stable_sort(groups, std::greater<>(),
                             [](const Group& group) { return group.files.size(); });
    return groups;
}

std::string write_report_text(const std::vector<Report>& reports, const TextOptions& options) {
    std::string text;
    std::size_t passed = 0;
    for (const Report& report : reports) {
        text += headline(report) + '\n';
        passed += report.verdict == Verdict::pass ? 1 : 0;
        if (options.details) {
            text += causes_text(report, options.most_findings);
            text += mistakes_text(report);
            for (const std::string& remark : report.remarks) {
                text += "  (" + harmless(remark) + ")\n";
            }
        }
    }
    if (reports.size() > 1) {
        text += std::to_string(passed) + " of " + std::to_string(reports.size()) + " pass\n";
        for (const Group& group : groups_of(reports)) {
            text += "  " + std::to_string(group.files.size()) + " of " +
                    std::to_string(reports.size()) + ": " + group.id + '\n';
        }
    }
    return text;
}

std::string write_report_csv(const std::vector<Report>& reports) {
    std::string text = "file,verdict,score,profile,rays,compared,causes,mistake,sure,first\n";
    for (const Report& report : reports) {
        char score[30];
        std::snprintf(score, sizeof score, "%.6g", report.score);
        const bool named = !report.mistakes.empty();
        text += cell(report.file) + ',' + std::string(word_of(report.verdict)) + ',' + score + ',' +
                report.profile + ',' + std::to_string(report.rays) + ',' +
                std::to_string(report.compared) + ',' + std::to_string(report.causes()) + ',' +
                (named ? report.mistakes.front().id : "") + ',' +
                (named && report.mistakes.front().sure ? "yes" : "") + ',' +
                cell(first_cause(report)) + '\n';
    }
    return text;
}

std::string write_report_junit(const std::vector<Report>& reports) {
    std::size_t failures = 0, errors = 0;
    std::string cases;
    for (const Report& report : reports) {
        cases += "  <testcase classname=\"raytree.check\" name=\"" + xml(report.file) + "\"";
        if (report.verdict == Verdict::pass) {
            cases += "/>\n";
            continue;
        }
        const bool unreadable = report.verdict == Verdict::unreadable;
        ++(unreadable ? errors : failures);
        const std::string tag = unreadable ? "error" : "failure";
        cases += "><" + tag + " message=\"" + xml(first_cause(report)) + "\">";
        for (const Finding& finding : report.findings) {
            cases += finding.follows_from ? "" : xml(sentence(finding, report)) + '\n';
        }
        cases += "</" + tag + "></testcase>\n";
    }
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"raytree check\" "
           "tests=\"" +
           std::to_string(reports.size()) + "\" failures=\"" + std::to_string(failures) +
           "\" errors=\"" + std::to_string(errors) + "\">\n" + cases + "</testsuite>\n";
}

}  // namespace raytree::check
