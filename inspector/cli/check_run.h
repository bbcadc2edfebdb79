#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/report.h"
#include "check/rubric.h"

/// What raytree check does once its command line is understood.
namespace raytree::cli {

struct CheckRun {
    std::vector<std::string> submissions;
    Scene scene;
    check::CheckOptions options;
    std::vector<Scene> other_scenes;  ///< to suggest pixels of
    std::optional<check::Rubric> rubric;
    bool anonymous = false;
    check::ReportFormat as = check::ReportFormat::text;
    check::Telling telling = check::Telling::all;
    std::string output = "-";
    std::string pictures;  ///< the folder for drawings of the trees; empty: none
    int threads = 0;       ///< 0: all cores
};

/// Judges all submissions, several at a time, and writes one report. An exit code.
int check_submissions(const CheckRun& run);

/// Joins the reports that `submissions` names into the one that a single run would have written.
int merge_reports(const CheckRun& run);

}  // namespace raytree::cli
