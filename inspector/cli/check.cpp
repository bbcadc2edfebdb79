#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>

#include "check/check.h"
#include "check/conventions.h"
#include "check/report.h"
#include "command.h"
#include "formats/output_file.h"
#include "formats/tree_json.h"
#include "scene/input_error.h"
#include "scene_arguments.h"
#include "values.h"

namespace raytree::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* examples =
    "Examples:\n"
    "  raytree check tree.json --scene scene.json              is the tree right?\n"
    "  raytree check class/ --scene scene.json --as csv        a row for each of a folder's\n"
    "  raytree check tree.json --reference truth.json          against a tree with its scene\n"
    "                                                          inside (trace --embed-scene)";

constexpr std::array<std::string_view, 5> format_words = {"text", "json", "gradescope", "junit",
                                                          "csv"};

struct Arguments {
    std::vector<std::string> submissions;
    SceneArguments scene;
    std::string reference;
    std::string output = "-";
    std::size_t as = 0;
    check::CheckOptions options;
};

/// The files meant: those of a folder are all its .json, in the order of their names.
std::vector<fs::path> files_of(const std::vector<std::string>& named) {
    std::vector<fs::path> files;
    for (const std::string& name : named) {
        std::error_code error;
        if (!fs::is_directory(name, error)) {
            files.emplace_back(name);
            continue;
        }
        std::vector<fs::path> inside;
        for (fs::recursive_directory_iterator entry(name, error), end; entry != end && !error;
             entry.increment(error)) {
            if (extension_of(entry->path().string()) == "json" && !entry->is_directory(error)) {
                inside.push_back(entry->path());
            }
        }
        std::ranges::sort(inside);
        if (inside.empty()) {
            throw InputError(name, "", "has no .json files in it");
        }
        files.insert(files.end(), inside.begin(), inside.end());
    }
    return files;
}

Scene scene_to_judge_by(const Arguments& arguments) {
    if (arguments.scene.file.empty() == arguments.reference.empty()) {
        throw Misuse("give either --scene SCENE or --reference TREE (see raytree check --help)");
    }
    if (!arguments.scene.file.empty()) {
        return arguments.scene.load().scene;
    }
    ReadTree read = read_tree_json(read_input(arguments.reference), arguments.reference);
    if (!read.scene) {
        throw InputError(arguments.reference, "/scene/document",
                         "is missing: a reference needs its scene inside, as trace --embed-scene "
                         "writes it; or give --scene");
    }
    return *std::move(read.scene);
}

std::string written(const std::vector<check::Report>& reports, std::size_t as) {
    switch (as) {
        case 1:
            return write_report_json(reports);
        case 2:
            return write_report_gradescope(reports);
        case 3:
            return write_report_junit(reports);
        case 4:
            return write_report_csv(reports);
        default:
            return write_report_text(reports);
    }
}

int check_all(const Arguments& arguments) {
    expect_writable(arguments.output, arguments.scene.file);
    if (arguments.options.profile) {
        check::profile_named(*arguments.options.profile);
    }
    const Scene scene = scene_to_judge_by(arguments);
    const std::vector<fs::path> files = files_of(arguments.submissions);
    const check::Checker checker(scene, arguments.options);
    std::vector<check::Report> reports(files.size());
    const int threads = arguments.scene.threads;
    const tbb::global_control limit(
        tbb::global_control::max_allowed_parallelism,
        threads > 0
            ? static_cast<std::size_t>(threads)
            : tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
    tbb::parallel_for(std::size_t{0}, files.size(),
                      [&](std::size_t k) { reports[k] = checker.check_file(files[k]); });
    write_output(arguments.output, written(reports, arguments.as));
    const bool all_pass = std::ranges::all_of(reports, [](const check::Report& report) {
        return report.verdict == check::Verdict::pass;
    });
    return all_pass ? done : found_wrong;
}

Given fields_named(const std::string& text) {
    Given fields;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t comma = std::min(text.find(',', from), text.size());
        fields.set(one_of("--require", text.substr(from, comma - from), field_words));
        from = comma + 1;
    }
    return fields;
}

void add_judging(CLI::App& app, const std::shared_ptr<Arguments>& arguments) {
    add_value(app, "--reference", "TREE", "a tree with its scene inside, instead of --scene",
              [arguments](const std::string& text) { arguments->reference = text; });
    add_value(app, "--rtol", "R", "relative tolerance (default: 1e-5)",
              [arguments](const std::string& text) {
                  const auto rtol = real_number(text);
                  if (!rtol || !(*rtol > 0) || *rtol >= 1) {
                      throw wrong_value("--rtol", text, "a number over 0 and under 1");
                  }
                  arguments->options.rtol = *rtol;
              });
    add_value(
        app, "--require", "FIELDS", "what every ray must give, such as direction,t,intensity",
        [arguments](const std::string& text) { arguments->options.required = fields_named(text); });
    add_value(app, "--profile", "NAME",
              "the course's conventions (default: those that fit\nbest): lecture, ucla, ...",
              [arguments](const std::string& text) { arguments->options.profile = text; });
}

}  // namespace

Command check_command(CLI::App& program) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* const app =
        program.add_subcommand("check", "Is a ray tree from another tracer right?");
    app->footer(examples);
    app->add_option("SUBMISSION", arguments->submissions, "ray trees, or folders of them")
        ->option_text(" ")
        ->required();
    add_value(*app, "--scene", "SCENE", "the scene that the trees are of",
              [arguments](const std::string& text) { arguments->scene.file = text; });
    add_judging(*app, arguments);
    add_value(*app, "-o,--output", "FILE", "where to write; - is standard output, the default",
              [arguments](const std::string& text) { arguments->output = text; });
    add_value(*app, "--as", "text|json|gradescope|junit|csv", "what to write (default: text)",
              [arguments](const std::string& text) {
                  arguments->as = one_of("--as", text, format_words);
              });
    add_scene_options(*app, arguments->scene);
    return {app, [arguments] { return check_all(*arguments); }};
}

}  // namespace raytree::cli
