#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "check/check.h"

/// Reports of many submissions, in the order given.
namespace raytree::check {

/// The same likeliest mistake in several submissions.
struct Group {
    std::string id;
    std::vector<std::string> files;
};
/// The largest first, of equals by id.
std::vector<Group> groups_of(const std::vector<Report>& reports);

struct TextOptions {
    bool details = true;             ///< findings and hints, not only a line for each
    std::size_t most_findings = 12;  ///< of one submission
};
std::string write_report_text(const std::vector<Report>& reports, const TextOptions& options = {});
std::string write_report_json(const std::vector<Report>& reports);
std::string write_report_csv(const std::vector<Report>& reports);
std::string write_report_junit(const std::vector<Report>& reports);
/// Gradescope's results.json: of the one submission that an autograder is about.
std::string write_report_gradescope(const std::vector<Report>& reports);

}  // namespace raytree::check
