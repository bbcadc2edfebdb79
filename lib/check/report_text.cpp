#include "check/report_text.h"

#include <algorithm>
#include <cctype>
#include <cstdio>

#include "check/conventions.h"
#include "formats/xml_text.h"

namespace raytree::check {
namespace {

std::string percent(double share) {
    char text[20];
    // Not all: "100 %" is for what is.
    std::snprintf(text, sizeof text, "%.3g %%", share < 1 ? std::min(100 * share, 99.9) : 100.0);
    return text;
}

std::string number(double x) {
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", x);
    return text;
}

std::string headline(const Printed& of) {
    std::string line = of.file + ": " + of.verdict;
    if (of.verdict == "unreadable") {
        return line;
    }
    if (of.compares != "pixels") {
        line += ", " + std::to_string(of.rays) + (of.rays == 1 ? " ray" : " rays");
    }
    const std::string one = of.compares == "pixels" ? "pixel" : "quantity";
    line += ", " + std::to_string(of.compared) + ' ' + (of.compared == 1 ? one : of.compares) +
            " compared";
    if (of.verdict == "fail") {
        line += ", " + percent(of.score) + " right";
    }
    if (of.points) {
        line += ", " + number(of.points->earned) + " of " + number(of.points->total) + " points";
    }
    return line + ", by the profile " + of.profile +
           (of.precision == "double" ? "" : ", numbers are " + of.precision);
}

std::string conventions_text(const Printed& of) {
    if (of.conventions.empty()) {
        return "";
    }
    std::string text =
        of.profile_asked_for   ? "  Nothing else is wrong than conventions of other courses:\n"
        : of.verdict == "pass" ? "  Right by conventions that are not the lecture's:\n"
                               : "  The profile " + of.profile + " differs from the lecture:\n";
    for (const PrintedConvention& convention : of.conventions) {
        text += "     " + convention.axis + '=' + convention.value + ": " + convention.text;
        text += convention.mistake.empty()
                    ? "\n"
                    : " (where it is not meant, the mistake " + convention.mistake + ")\n";
    }
    if (!of.profile_asked_for && of.verdict == "pass") {
        text +=
            "     --profile " + std::string(profiles().front().name) + " holds it to the lecture\n";
    }
    return text;
}

/// A finding as far as it is told, line by line.
std::string told(const PrintedFinding& finding, Telling telling) {
    if (finding.of_the_whole) {
        return finding.text + '\n';
    }
    switch (telling) {
        case Telling::where:
            return finding.where + '\n';
        case Telling::quantity:
            return finding.where + ' ' + finding.what + '\n';
        case Telling::formula:
            return finding.where + ' ' + finding.what + "\n     " + finding.formula + '\n';
        default:
            return finding.text + "\n     " + finding.formula + '\n';
    }
}

/// Causes with all that hangs on them counted, not listed.
std::string causes_text(const Printed& of, Telling telling, std::size_t most) {
    std::string text;
    std::size_t listed = 0;
    for (std::size_t k = 0; k < of.findings.size(); ++k) {
        const PrintedFinding& finding = of.findings[k];
        if (finding.follows_from) {
            continue;
        }
        if (++listed > most) {
            return text + "  and " + std::to_string(of.causes() - most) + " more\n";
        }
        text += "  " + std::to_string(listed) + ". " + told(finding, telling);
        const auto followers = std::ranges::count_if(
            of.findings, [k](const PrintedFinding& f) { return f.follows_from == k; });
        if (followers > 0 && of.compares == "pixels") {
            for (const PrintedFinding& group : of.findings) {
                text += group.follows_from == k ? "     " + group.text + '\n' : "";
            }
        } else if (followers > 0) {
            text += "     " + std::to_string(followers) +
                    (followers == 1 ? " other difference follows" : " other differences follow") +
                    " from it\n";
        }
    }
    return text;
}

std::string mistakes_text(const Printed& of) {
    std::string text;
    for (const NamedMistake& mistake : of.mistakes) {
        text += std::string("  ") + (mistake.sure ? "The mistake" : "Perhaps") + ": " +
                mistake.text + " [" + mistake.id + "]\n";
        text += "     explains " + std::to_string(mistake.rays) +
                (of.compares == "pixels" ? " pixels"
                 : mistake.rays == 1     ? " ray"
                                         : " rays") +
                "; see the lecture on " + mistake.topic + ", lesson " + mistake.lesson + '\n';
        if (!mistake.ties.empty()) {
            text += "     the same numbers would come from";
            for (const std::string& tie : mistake.ties) {
                text += (&tie == &mistake.ties.front() ? " " : ", ") + tie;
            }
            text += '\n';
        }
    }
    for (const std::string& pixel : of.telling_pixels) {
        text += "     " + pixel + '\n';
    }
    return text;
}

std::string points_text(const Printed& of) {
    std::string text;
    for (const PointsRow& row : of.points ? of.points->rows : std::vector<PointsRow>()) {
        if (row.right != row.compared) {
            text += "     " + row.quantity + " of " + row.kind + " rays, level " +
                    std::to_string(row.level) + ": " + std::to_string(row.right) + " of " +
                    std::to_string(row.compared) + " right, " + number(row.points) + " of " +
                    number(row.of) + '\n';
        }
    }
    return text.empty() ? text : "  Points lost:\n" + text;
}

/// A field of a CSV row: quoted, and never a formula of a spreadsheet.
std::string cell(const std::string& text) {
    std::string safe = text;
    if (!safe.empty() && std::string_view("=+-@").find(safe.front()) != std::string_view::npos) {
        safe.insert(0, 1, '\'');
    }
    std::string quoted = "\"";
    for (const char c : safe) {
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    }
    return quoted + '"';
}

/// A word as it is; of a report that was read, any text.
std::string word_cell(const std::string& text) {
    const bool plain = std::ranges::all_of(text, [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '_' || c == '-';
    });
    return plain && !text.starts_with('-') ? text : cell(text);
}

std::string first_cause(const Printed& of) {
    return of.findings.empty() ? "" : of.findings.front().text;
}

}  // namespace

std::string words_of(const Printed& of, Telling telling, std::size_t most_findings) {
    // What fits the whole of it comes before what it does to each ray.
    std::string text = headline(of) + '\n' + conventions_text(of) +
                       (telling == Telling::all ? mistakes_text(of) : "") +
                       causes_text(of, telling, most_findings) + points_text(of);
    for (const std::string& remark : of.remarks) {
        text += "  (" + remark + ")\n";
    }
    return text;
}

std::string conventions_of(const Printed& of) {
    std::string text;
    for (const PrintedConvention& each : of.conventions) {
        text += (text.empty() ? "" : " ") + each.axis + '=' + each.value;
    }
    return text;
}

std::string csv_row_of(const Printed& of) {
    const bool named = !of.mistakes.empty();
    return cell(of.file) + ',' + of.verdict + ',' + number(of.score) + ',' +
           (of.points ? number(of.points->earned) : "") + ',' + word_cell(of.profile) + ',' +
           cell(conventions_of(of)) + ',' + std::to_string(of.rays) + ',' +
           std::to_string(of.compared) + ',' + std::to_string(of.causes()) + ',' +
           (named ? word_cell(of.mistakes.front().id) : "") + ',' +
           (named && of.mistakes.front().sure ? "yes" : "") + ',' + cell(first_cause(of)) + '\n';
}

std::string junit_case_of(const Printed& of) {
    const std::string name =
        "  <testcase classname=\"raytree.check\" name=\"" + xml_text(of.file) + "\"";
    if (of.verdict == "pass") {
        return name + "/>\n";
    }
    const std::string tag = of.verdict == "unreadable" ? "error" : "failure";
    std::string text = name + "><" + tag + " message=\"" + xml_text(first_cause(of)) + "\">";
    for (const PrintedFinding& finding : of.findings) {
        text += finding.follows_from ? "" : xml_text(finding.text) + '\n';
    }
    for (const NamedMistake& mistake : of.mistakes) {
        text += xml_text((mistake.sure ? "The mistake: " : "Perhaps: ") + mistake.text + " [" +
                         mistake.id + "]") +
                '\n';
    }
    return text + "</" + tag + "></testcase>\n";
}

}  // namespace raytree::check
