#include "report_spool.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "formats/output_file.h"
#include "scene/input_error.h"

namespace raytree::cli {
namespace {

[[noreturn]] void fail() {
    throw InputError("", "",
                     std::string("the temporary file of the report: ") + std::strerror(errno));
}

}  // namespace

ReportSpool::ReportSpool(check::ReportFormat format, check::Telling telling)
    : sheet_(format, telling), file_(std::tmpfile()) {
    if (!file_) {
        fail();
    }
}

void ReportSpool::add(const check::Printed& submission) {
    const std::string part = sheet_.part(submission);
    if (std::fwrite(part.data(), 1, part.size(), file_.get()) != part.size()) {
        fail();
    }
    parts_.push_back({check::summary_of(submission), size_, part.size()});
    size_ += static_cast<long>(part.size());
}

void ReportSpool::write(const std::string& output) {
    std::ranges::stable_sort(parts_, {}, [](const Part& part) { return part.summary.file; });
    std::vector<check::Summary> all;
    all.reserve(parts_.size());
    for (const Part& part : parts_) {
        all.push_back(part.summary);
    }
    OutputFile file(output);
    file.add(sheet_.head(all));
    std::string buffer;
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        buffer.resize(parts_[k].size);
        if (std::fseek(file_.get(), parts_[k].offset, SEEK_SET) != 0 ||
            std::fread(buffer.data(), 1, buffer.size(), file_.get()) != buffer.size()) {
            fail();
        }
        file.add(k == 0 ? "" : sheet_.separator());
        file.add(buffer);
    }
    file.add(sheet_.tail(all));
    file.finish();
}

bool ReportSpool::all_pass() const {
    return std::ranges::all_of(parts_,
                               [](const Part& part) { return part.summary.verdict == "pass"; });
}

}  // namespace raytree::cli
