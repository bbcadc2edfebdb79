#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "check/check.h"
#include "check/rubric.h"

/// Reports of submissions, as text and as data, one submission at a time: a class of any size is
/// reported in little memory.
namespace raytree::check {

/// A finding as it is printed. Values are JSON.
struct PrintedFinding {
    std::string ray = "null", kind, quantity, expected = "null", found = "null";
    double relative_error = 0;
    std::optional<std::size_t> follows_from;
    std::string text, rationale, where, what, formula;
    bool of_the_whole = false;
};

struct PrintedConvention {
    std::string axis, value, text, mistake;
};

/// All that any report says of one submission: what is written is made of this alone, and what a
/// JSON report says can be read back into it.
struct Printed {
    std::string file, verdict, profile;
    double score = 0;
    std::size_t rays = 0, compared = 0;
    std::string precision;
    std::string compares = "quantities";  ///< or "pixels"
    std::vector<PrintedFinding> findings;
    std::vector<NamedMistake> mistakes;
    std::vector<PrintedConvention> conventions;
    bool profile_asked_for = false;
    std::vector<std::string> remarks;
    std::optional<Points> points;
    std::vector<std::string> telling_pixels;  ///< "12,7 of scene.json: ..."

    std::size_t causes() const;
};

Printed printed(const Report& report, const Rubric* rubric = nullptr);
/// The submissions of a JSON report. Throws InputError for what is none.
std::vector<Printed> read_report(const std::string& text, const std::filesystem::path& file);

enum class ReportFormat { text, json, gradescope, junit, csv };

/// What the head and the tail of a report need to know of each submission.
struct Summary {
    std::string file, verdict, mistake;
    std::string conventions;  ///< not the lecture's, by which it passes: "miss=black near=all"
    double score = 0, earned = 0, total = 0;
};
Summary summary_of(const Printed& of);

/// What several submissions have in common.
struct Group {
    std::string id;
    std::vector<std::string> files;
};
/// By their likeliest mistakes. The largest first, of equals by id.
std::vector<Group> groups_of(const std::vector<Summary>& all);

/// How much a report for people gives away: where to look, also which quantity, also its formula,
/// or all of it, with the numbers that are due and the mistake's name.
enum class Telling { where, quantity, formula, all };

/// A report is its head, its parts with the separator between them, and its tail.
class ReportSheet {
  public:
    explicit ReportSheet(ReportFormat format, Telling telling = Telling::all,
                         std::size_t most_findings = 12)
        : format_(format), telling_(telling), most_findings_(most_findings) {}

    std::string part(const Printed& of) const;
    std::string_view separator() const;
    std::string head(const std::vector<Summary>& all) const;
    std::string tail(const std::vector<Summary>& all) const;

  private:
    ReportFormat format_;
    Telling telling_;
    std::size_t most_findings_;
};

/// A whole report.
std::string write_report(const std::vector<Report>& reports, ReportFormat format);

}  // namespace raytree::check
