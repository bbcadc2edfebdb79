#include "check_run.h"

#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>

#include <algorithm>
#include <map>
#include <memory>

#include "check/picture_check.h"
#include "command.h"
#include "formats/output_file.h"
#include "report_spool.h"
#include "scene/input_error.h"
#include "submission_feed.h"

namespace raytree::cli {
namespace {

std::string picture_bytes(const std::filesystem::path& file) {
    std::error_code error;
    const auto size = std::filesystem::file_size(file, error);
    if (!error && size > check::largest_picture) {
        throw InputError("", "", "is too large for a picture");
    }
    return read_input(file);
}

check::Report judged_picture(const check::PictureChecker& checker, const Handed& handed) {
    try {
        return checker.check(handed.text ? *handed.text : picture_bytes(handed.file), handed.name);
    } catch (const InputError& error) {
        return check::refused(handed.name, error.mistakes().front().text);
    }
}

check::Report judged(const check::Checker& checker, const check::PictureChecker& pictures,
                     const Handed& handed) {
    if (!handed.refusal.empty()) {
        return check::refused(handed.name, handed.refusal);
    }
    if (handed.is_picture) {
        return judged_picture(pictures, handed);
    }
    if (handed.text) {
        return checker.check_text(*handed.text, handed.name);
    }
    return checker.check_file(handed.file, handed.name);
}

int exit_code(const ReportSpool& spool) { return spool.all_pass() ? done : found_wrong; }

}  // namespace

int check_submissions(const CheckRun& run) {
    SubmissionFeed feed(run.submissions, run.anonymous);
    const check::Checker checker(run.scene, run.options);
    const check::PictureChecker pictures(checker);
    ReportSpool spool(run.as);
    const std::size_t threads =
        run.threads > 0
            ? static_cast<std::size_t>(run.threads)
            : tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const auto take = [&](tbb::flow_control& control) {
        auto handed = feed.next();
        if (!handed) {
            control.stop();
            return std::shared_ptr<Handed>();
        }
        return std::make_shared<Handed>(*std::move(handed));
    };
    const auto judge = [&](const std::shared_ptr<Handed>& handed) {
        const check::Report report = judged(checker, pictures, *handed);
        return std::make_shared<check::Printed>(
            check::printed(report, run.rubric ? &*run.rubric : nullptr));
    };
    const auto put = [&](const std::shared_ptr<check::Printed>& printed) { spool.add(*printed); };
    tbb::parallel_pipeline(
        2 * threads,
        tbb::make_filter<void, std::shared_ptr<Handed>>(tbb::filter_mode::serial_in_order, take) &
            tbb::make_filter<std::shared_ptr<Handed>, std::shared_ptr<check::Printed>>(
                tbb::filter_mode::parallel, judge) &
            tbb::make_filter<std::shared_ptr<check::Printed>, void>(
                tbb::filter_mode::serial_in_order, put));
    spool.write(run.output);
    return exit_code(spool);
}

int merge_reports(const CheckRun& run) {
    std::map<std::string, std::string> numbers;
    for (const std::string& file : run.anonymous ? run.submissions : std::vector<std::string>()) {
        for (const check::Printed& submission : check::read_report(read_input(file), file)) {
            numbers[submission.file];
        }
    }
    std::size_t count = 0;
    for (auto& [name, number] : numbers) {
        number = anonymous_name(++count);
    }
    ReportSpool spool(run.as);
    for (const std::string& file : run.submissions) {
        for (check::Printed& submission : check::read_report(read_input(file), file)) {
            submission.file = run.anonymous ? numbers[submission.file] : submission.file;
            spool.add(submission);
        }
    }
    spool.write(run.output);
    return exit_code(spool);
}

}  // namespace raytree::cli
