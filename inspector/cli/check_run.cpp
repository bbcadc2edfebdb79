#include "check_run.h"

#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <memory>
#include <set>

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

check::Report judged_picture(const check::PictureChecker& checker, const Handed& handed, bool drawn,
                             std::string& drawing) {
    try {
        const std::string bytes = handed.text ? *handed.text : picture_bytes(handed.file);
        const check::Report report = checker.check(bytes, handed.name);
        if (drawn) {
            drawing = checker.overlay(bytes, report);
        }
        return report;
    } catch (const InputError& error) {
        return check::refused(handed.name, error.mistakes().front().text);
    }
}

/// What is said of a submission, and the drawing of its tree or picture over the true one.
struct Judged {
    check::Printed printed;
    std::string drawing;
    bool is_picture = false;
};

check::Report judged_tree(const check::Checker& checker, const Handed& handed, bool drawn,
                          std::string& drawing) {
    if (!drawn) {
        return handed.text ? checker.check_text(*handed.text, handed.name)
                           : checker.check_file(handed.file, handed.name);
    }
    try {
        const std::string text =
            handed.text ? *handed.text : check::load_submission_text(handed.file);
        const check::Report report = checker.check_text(text, handed.name);
        drawing = checker.overlay(text, report);
        return report;
    } catch (const InputError& error) {
        return check::refused(handed.name, error.mistakes().front().text);
    }
}

Judged judged(const check::Checker& checker, const check::PictureChecker& pictures,
              const Handed& handed, const CheckRun& run) {
    Judged result;
    result.is_picture = handed.is_picture;
    const bool drawn = !run.pictures.empty();
    const check::Report report =
        !handed.refusal.empty() ? check::refused(handed.name, handed.refusal)
        : handed.is_picture     ? judged_picture(pictures, handed, drawn, result.drawing)
                                : judged_tree(checker, handed, drawn, result.drawing);
    result.printed = check::printed(report, run.rubric ? &*run.rubric : nullptr);
    return result;
}

/// Writes drawings to a folder, named like their submissions.
class Drawings {
  public:
    explicit Drawings(const std::string& folder) : folder_(folder) {
        std::error_code error;
        if (!folder.empty() && !std::filesystem::create_directories(folder, error) && error) {
            throw InputError(folder, "", "cannot be made: " + error.message());
        }
    }
    void add(const std::string& submission, const std::string& drawing, const char* extension) {
        if (!drawing.empty()) {
            write_output(
                (std::filesystem::path(folder_) / (name_of(submission) + extension)).string(),
                drawing);
        }
    }

  private:
    /// A plain file name, and one that no submission had before.
    std::string name_of(const std::string& submission) {
        std::string name = submission.substr(0, submission.rfind('.'));
        name = name.substr(0, longest_);
        for (char& c : name) {
            const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' ||
                               c == '_' || c == ',' || c == '.';
            c = plain ? c : '_';
        }
        name = name.empty() || name.front() == '.' ? "tree" + name : name;
        std::string unique = name;
        for (std::size_t k = 2; !used_.insert(unique).second; ++k) {
            unique = name + '-' + std::to_string(k);
        }
        return unique;
    }

    static constexpr std::size_t longest_ = 100;
    std::string folder_;
    std::set<std::string> used_;
};

/// The files themselves, and the .json files of folders: a class has more parts than a command
/// line.
std::vector<std::string> reports_in(const std::vector<std::string>& named) {
    std::vector<std::string> files;
    for (const std::string& name : named) {
        std::error_code error;
        if (!std::filesystem::is_directory(name, error)) {
            files.push_back(name);
            continue;
        }
        for (const auto& entry : std::filesystem::directory_iterator(name)) {
            if (entry.path().extension() == ".json") {
                files.push_back(entry.path().string());
            }
        }
    }
    return files;
}

int exit_code(const ReportSpool& spool) { return spool.all_pass() ? done : found_wrong; }

}  // namespace

int check_submissions(const CheckRun& run) {
    SubmissionFeed feed(run.submissions, run.anonymous);
    const check::Checker checker(run.scene, run.options);
    const check::PictureChecker pictures(checker);
    ReportSpool spool(run.as, run.telling);
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
        return std::make_shared<Judged>(judged(checker, pictures, *handed, run));
    };
    Drawings drawings(run.pictures);
    const auto put = [&](const std::shared_ptr<Judged>& result) {
        spool.add(result->printed);
        drawings.add(result->printed.file, result->drawing, result->is_picture ? ".png" : ".svg");
    };
    tbb::parallel_pipeline(
        2 * threads,
        tbb::make_filter<void, std::shared_ptr<Handed>>(tbb::filter_mode::serial_in_order, take) &
            tbb::make_filter<std::shared_ptr<Handed>, std::shared_ptr<Judged>>(
                tbb::filter_mode::parallel, judge) &
            tbb::make_filter<std::shared_ptr<Judged>, void>(tbb::filter_mode::serial_in_order,
                                                            put));
    spool.write(run.output);
    return exit_code(spool);
}

int merge_reports(const CheckRun& run) {
    const std::vector<std::string> files = reports_in(run.submissions);
    std::map<std::string, std::string> numbers;
    for (const std::string& file : run.anonymous ? files : std::vector<std::string>()) {
        for (const check::Printed& submission : check::read_report(read_input(file), file)) {
            numbers[submission.file];
        }
    }
    std::size_t count = 0;
    for (auto& [name, number] : numbers) {
        number = anonymous_name(++count);
    }
    ReportSpool spool(run.as, run.telling);
    for (const std::string& file : files) {
        for (check::Printed& submission : check::read_report(read_input(file), file)) {
            submission.file = run.anonymous ? numbers[submission.file] : submission.file;
            spool.add(submission);
        }
    }
    spool.write(run.output);
    return exit_code(spool);
}

}  // namespace raytree::cli
