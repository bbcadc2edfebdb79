#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "check/report.h"

namespace raytree::cli {

/// Keeps the parts of a report on disk until all are there, so that a class of any size is reported
/// in little memory; then writes the whole, in the order of the submissions' names.
class ReportSpool {
  public:
    ReportSpool(check::ReportFormat format, check::Telling telling);

    void add(const check::Printed& submission);
    /// Writes the report to the file of that name, "-" is standard output.
    void write(const std::string& output);
    bool all_pass() const;

  private:
    struct Part {
        check::Summary summary;
        long offset;
        std::size_t size;
    };
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    check::ReportSheet sheet_;
    std::unique_ptr<std::FILE, Close> file_;
    std::vector<Part> parts_;
    long size_ = 0;
};

}  // namespace raytree::cli
