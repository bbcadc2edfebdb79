#include "check/report_json.h"

#include "check/describe.h"
#include "formats/json_text.h"

namespace raytree::check {
namespace {

using Layout = JsonWriter::Layout;

void write_texts(JsonWriter& json, std::string_view key, const std::vector<std::string>& texts) {
    json.key(key).begin_array(Layout::block);
    for (const std::string& text : texts) {
        json.value(text);
    }
    json.end_array();
}

void write_finding(JsonWriter& json, const Printed& of, std::size_t place) {
    const PrintedFinding& finding = of.findings[place];
    json.begin_object();
    json.key("ray").raw(finding.ray);
    json.key("kind");
    if (finding.kind.empty()) {
        json.null();
    } else {
        json.value(finding.kind);
    }
    json.member("quantity", finding.quantity);
    json.key("expected").raw(finding.expected);
    json.key("found").raw(finding.found);
    json.member("relative_error", finding.relative_error);
    json.key("follows_from");
    if (finding.follows_from) {
        json.value(*finding.follows_from);
    } else {
        json.null();
    }
    json.key("followed_by").begin_array();
    for (std::size_t k = place + 1; !finding.follows_from && k < of.findings.size(); ++k) {
        if (of.findings[k].follows_from == place) {
            json.value(k);
        }
    }
    json.end_array();
    json.member("text", finding.text);
    json.member("rationale", finding.rationale);
    json.key("hints").begin_object();
    json.member("where", finding.where);
    json.member("quantity", finding.what);
    json.member("formula", finding.formula);
    json.end_object().end_object();
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
    json.member("lesson", mistake.lesson);
    json.end_object();
}

void write_conventions(JsonWriter& json, const Printed& of) {
    json.key("conventions").begin_array(Layout::block);
    for (const PrintedConvention& convention : of.conventions) {
        json.begin_object();
        json.member("axis", convention.axis);
        json.member("value", convention.value);
        json.member("text", convention.text);
        json.member("mistake_elsewhere", convention.mistake);
        json.end_object();
    }
    json.end_array();
}

void write_points(JsonWriter& json, const Points& points) {
    json.key("points").begin_object(Layout::block);
    json.member("earned", points.earned);
    json.member("total", points.total);
    json.key("rows").begin_array(Layout::block);
    for (const PointsRow& row : points.rows) {
        json.begin_object();
        json.member("quantity", row.quantity);
        json.member("kind", row.kind);
        json.member("level", row.level);
        json.member("compared", row.compared);
        json.member("right", row.right);
        json.member("points", row.points);
        json.member("of", row.of);
        json.end_object();
    }
    json.end_array().end_object();
}

}  // namespace

std::string json_of(const Printed& of) {
    JsonWriter json;
    json.begin_object(Layout::block);
    json.member("file", of.file);
    json.member("verdict", of.verdict);
    json.member("profile", of.profile);
    json.member("profile_asked_for", of.profile_asked_for);
    json.member("score", of.score);
    json.member("rays", of.rays);
    json.member("compared", of.compared);
    json.member("compares", of.compares);
    json.member("precision", of.precision);
    if (of.points) {
        write_points(json, *of.points);
    }
    json.key("findings").begin_array(Layout::block);
    for (std::size_t k = 0; k < of.findings.size(); ++k) {
        write_finding(json, of, k);
    }
    json.end_array();
    json.key("mistakes").begin_array(Layout::block);
    for (const NamedMistake& mistake : of.mistakes) {
        write_mistake(json, mistake);
    }
    json.end_array();
    write_conventions(json, of);
    write_texts(json, "telling_pixels", of.telling_pixels);
    write_texts(json, "remarks", of.remarks);
    json.end_object();
    std::string text = json.take();
    text.pop_back();  // the line feed
    return text;
}

std::string json_of(const std::vector<Group>& groups) {
    JsonWriter json;
    json.begin_array(Layout::block);
    for (const Group& group : groups) {
        json.begin_object();
        json.member("id", group.id);
        json.key("files").begin_array();
        for (const std::string& file : group.files) {
            json.value(file);
        }
        json.end_array().end_object();
    }
    json.end_array();
    std::string text = json.take();
    text.pop_back();
    return text;
}

std::string gradescope_of(const Printed& of, const std::string& output) {
    JsonWriter json;
    json.begin_object(Layout::block);
    json.member("name", of.file);
    json.member("score", of.points ? of.points->earned : of.score);
    json.member("max_score", of.points ? of.points->total : 1.0);
    json.member("status", of.verdict == "pass" ? "passed" : "failed");
    json.member("output_format", "text");
    json.member("output", output);
    json.end_object();
    std::string text = json.take();
    text.pop_back();
    return text;
}

}  // namespace raytree::check
