#pragma once

#include <string>

#include "check/report.h"

/// Pieces of reports for people and for spreadsheets.
namespace raytree::check {

std::string words_of(const Printed& of, Telling telling, std::size_t most_findings);
/// "near=all miss=black"
std::string conventions_of(const Printed& of);
std::string csv_row_of(const Printed& of);
std::string junit_case_of(const Printed& of);

}  // namespace raytree::check
