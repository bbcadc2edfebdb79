#include <algorithm>

#include "check/describe.h"
#include "check/report.h"
#include "formats/json_text.h"

namespace raytree::check {
namespace {

using Layout = JsonWriter::Layout;

void write_value(JsonWriter& json, std::string_view key, const Value& value) {
    json.key(key);
    // A product of what a submission gives may be too large for a number.
    const auto& x = value.numbers.x;
    if (!isfinite(x[0]) || !isfinite(x[1]) || !isfinite(x[2])) {
        json.value("too large");
    } else if (!value.word.empty()) {
        json.value(harmless(value.word));
    } else if (value.numbers.size == 0) {
        json.null();
    } else if (value.numbers.size == 1) {
        json.value(value.numbers.x[0]);
    } else {
        json.numbers(std::span<const double>(value.numbers.x.data(),
                                             static_cast<std::size_t>(value.numbers.size)));
    }
}

/// An id is a number or a string, as the submission has it as far as that can be told.
void write_id(JsonWriter& json, const std::string& id) {
    const bool number = !id.empty() && id.size() < 10 && (id == "0" || id.front() != '0') &&
                        id.find_first_not_of("0123456789") == std::string::npos;
    if (number) {
        json.value(std::stoi(id));
    } else {
        json.value(harmless(id));
    }
}

void write_finding(JsonWriter& json, const Finding& finding, const Report& report) {
    json.begin_object();
    json.key("ray");
    if (finding.problem == Problem::whole || finding.ray >= report.ids.size()) {
        json.null();
        json.key("kind").null();
    } else {
        write_id(json, report.ids[finding.ray]);
        json.member("kind", word_of(finding.kind));
    }
    json.member("quantity", quantity_of(finding));
    write_value(json, "expected", finding.expected);
    write_value(json, "found", finding.found);
    json.member("relative_error", isfinite(finding.error) ? finding.error : 1.0);
    json.key("follows_from");
    if (finding.follows_from) {
        json.value(*finding.follows_from);
    } else {
        json.null();
    }
    json.member("text", sentence(finding, report));
    const Hints hint = hints(finding, report);
    json.key("hints").begin_array();
    json.value(hint.where).value(hint.quantity).value(hint.formula);
    json.end_array().end_object();
}

void write_mistake(JsonWriter& json, const NamedMistake& mistake) {
    json.begin_object();
    json.member("id", mistake.id);
    json.member("sure", mistake.sure);
    json.member("rays_explained", mistake.rays);
    json.key("ties").begin_array();
    for (const std::string& tie : mistake.ties) {
        json.value(tie);
    }
    json.end_array();
    json.member("text", mistake.text);
    json.member("topic", mistake.topic);
    json.end_object();
}

void write_submission(JsonWriter& json, const Report& report) {
    json.begin_object(Layout::block);
    json.member("file", harmless(report.file));
    json.member("verdict", word_of(report.verdict));
    json.member("profile", report.profile);
    json.member("score", report.score);
    json.member("rays", report.rays);
    json.member("compared", report.compared);
    json.member("precision", report.precision);
    json.key("findings").begin_array(Layout::block);
    for (const Finding& finding : report.findings) {
        write_finding(json, finding, report);
    }
    json.end_array();
    json.key("mistakes").begin_array(Layout::block);
    for (const NamedMistake& mistake : report.mistakes) {
        write_mistake(json, mistake);
    }
    json.end_array();
    json.key("remarks").begin_array(Layout::block);
    for (const std::string& remark : report.remarks) {
        json.value(harmless(remark));
    }
    json.end_array().end_object();
}

}  // namespace

std::string write_report_json(const std::vector<Report>& reports) {
    JsonWriter json;
    json.begin_object(Layout::block);
    json.member("format", "raytree-report/1.0");
    json.key("submissions").begin_array(Layout::block);
    for (const Report& report : reports) {
        write_submission(json, report);
    }
    json.end_array();
    json.key("groups").begin_array(Layout::block);
    for (const Group& group : groups_of(reports)) {
        json.begin_object();
        json.member("id", group.id);
        json.key("files").begin_array();
        for (const std::string& file : group.files) {
            json.value(harmless(file));
        }
        json.end_array().end_object();
    }
    json.end_array().end_object();
    return json.take();
}

std::string write_report_gradescope(const std::vector<Report>& reports) {
    JsonWriter json;
    json.begin_object(Layout::block);
    double score = 0;
    for (const Report& report : reports) {
        score += report.score;
    }
    json.member("score", reports.empty() ? 0.0 : 100 * score / static_cast<double>(reports.size()));
    json.key("tests").begin_array(Layout::block);
    for (const Report& report : reports) {
        json.begin_object();
        json.member("name", harmless(report.file));
        json.member("score", report.score);
        json.member("max_score", 1.0);
        json.member("status", report.verdict == Verdict::pass ? "passed" : "failed");
        json.member("output_format", "text");
        json.member("output", write_report_text({report}));
        json.end_object();
    }
    json.end_array().end_object();
    return json.take();
}

}  // namespace raytree::check
