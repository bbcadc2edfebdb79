#include <array>
#include <filesystem>
#include <memory>

#include "check/catalogue_text.h"
#include "check/check.h"
#include "check/conventions.h"
#include "check_run.h"
#include "command.h"
#include "formats/output_file.h"
#include "formats/tree_json.h"
#include "scene/input_error.h"
#include "scene_arguments.h"
#include "values.h"

namespace raytree::cli {
namespace {

constexpr const char* examples =
    "Examples:\n"
    "  raytree check tree.json --scene scene.json              is the tree right?\n"
    "  raytree check class.zip --scene scene.json --as csv     a row for each of a class's\n"
    "  raytree check tree.json --reference truth.json          against a tree with its scene\n"
    "                                                          inside (trace --embed-scene)\n"
    "  raytree check --merge a.json b.json -o all.json         one report of several";

constexpr std::array<std::string_view, 5> format_words = {"text", "json", "gradescope", "junit",
                                                          "csv"};

constexpr std::array<std::string_view, 4> telling_words = {"where", "quantity", "formula", "all"};

struct Arguments {
    CheckRun run;
    SceneArguments scene;
    std::string reference;
    std::vector<std::string> other_scenes;
    bool merge = false;
    bool catalogue = false;
};

/// Leaves the scene in the run.
void load_scene_to_judge_by(Arguments& arguments) {
    CheckRun& run = arguments.run;
    if (arguments.scene.file.empty() == arguments.reference.empty()) {
        throw Misuse("give either --scene SCENE or --reference TREE (see raytree check --help)");
    }
    if (!arguments.scene.file.empty()) {
        LoadedScene loaded = arguments.scene.load();
        run.options.scene_sha256 = std::move(loaded.sha256);
        run.options.course_text = loaded.format == SceneFormat::course_text;
        run.scene = std::move(loaded.scene);
        return;
    }
    ReadTree read = read_tree_json(read_input(arguments.reference), arguments.reference);
    if (!read.scene) {
        throw InputError(arguments.reference, "/scene/document",
                         "is missing: a reference needs its scene inside, as trace --embed-scene "
                         "writes it; or give --scene");
    }
    run.scene = *std::move(read.scene);
}

int check(Arguments& arguments) {
    CheckRun& run = arguments.run;
    run.threads = arguments.scene.threads;
    expect_writable(run.output, arguments.scene.file);
    if (arguments.catalogue) {
        write_output(run.output, check::catalogue_markdown());
        return done;
    }
    if (run.submissions.empty()) {
        throw Misuse("SUBMISSION is required (see raytree check --help)");
    }
    if (arguments.merge) {
        const bool judges = !arguments.scene.file.empty() || !arguments.reference.empty() ||
                            run.rubric || run.options.profile || !run.pictures.empty();
        if (judges) {
            throw Misuse(
                "--merge joins finished reports: it takes no scene, profile, rubric or pictures");
        }
        return merge_reports(run);
    }
    if (run.options.profile) {
        check::profile_named(*run.options.profile);
    }
    load_scene_to_judge_by(arguments);
    for (const std::string& file : arguments.other_scenes) {
        run.other_scenes.push_back(raytree::load_scene(file).scene);
    }
    for (std::size_t k = 0; k < run.other_scenes.size(); ++k) {
        run.options.suggested_scenes.push_back({arguments.other_scenes[k], &run.other_scenes[k]});
    }
    return check_submissions(run);
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
    check::CheckOptions& options = arguments->run.options;
    add_value(app, "--reference", "TREE", "a tree with its scene inside, instead of --scene",
              [arguments](const std::string& text) { arguments->reference = text; });
    add_value(app, "--rtol", "R", "relative tolerance (default: 1e-5)",
              [&options](const std::string& text) {
                  const auto rtol = real_number(text);
                  if (!rtol || !(*rtol > 0) || *rtol >= 1) {
                      throw wrong_value("--rtol", text, "a number over 0 and under 1");
                  }
                  options.rtol = *rtol;
              });
    add_value(app, "--require", "FIELDS", "what every ray must give, such as direction,t,intensity",
              [&options](const std::string& text) { options.required = fields_named(text); });
    add_value(app, "--profile", "NAME",
              "the course's conventions (default: those that fit\nbest): lecture, ucla, ...",
              [&options](const std::string& text) { options.profile = text; });
    app.add_flag("--suggest-pixels", options.suggest_pixels,
                 "where several mistakes fit: pixels that would tell\nwhich it is");
    add_value(app, "--suggest-from", "SCENE", "another scene to look for such pixels in",
              [arguments](const std::string& text) {
                  arguments->run.options.suggest_pixels = true;
                  arguments->other_scenes.push_back(text);
              })
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    add_value(app, "--rubric", "FILE", "points for quantities, levels and kinds of rays",
              [arguments](const std::string& text) {
                  arguments->run.rubric = check::read_rubric(read_input(text), text);
              });
}

void add_reporting(CLI::App& app, const std::shared_ptr<Arguments>& arguments) {
    CheckRun& run = arguments->run;
    add_value(app, "-o,--output", "FILE", "where to write; - is standard output, the default",
              [&run](const std::string& text) { run.output = text; });
    add_value(app, "--as", "text|json|gradescope|junit|csv", "what to write (default: text)",
              [&run](const std::string& text) {
                  run.as = static_cast<check::ReportFormat>(one_of("--as", text, format_words));
              });
    add_value(app, "--tell", "where|quantity|formula|all",
              "how much the text gives away: where to look, also\nwhat is wrong there, also its "
              "formula, or also the\nnumbers and the mistake (default: all)",
              [&run](const std::string& text) {
                  run.telling = static_cast<check::Telling>(one_of("--tell", text, telling_words));
              });
    add_value(app, "--picture", "FOLDER",
              "draw each tree over the true one, as SVG; each\npicture beside the true one, as PNG",
              [&run](const std::string& text) { run.pictures = text; });
    app.add_flag("--anonymous", run.anonymous, "numbers instead of the files' names");
    app.add_flag("--catalogue", arguments->catalogue,
                 "all mistakes, conventions and profiles as Markdown");
    app.add_flag("--merge", arguments->merge,
                 "the files, or the files of a folder, are reports\n(--as json) of other runs; "
                 "join them into one");
}

}  // namespace

Command check_command(CLI::App& program) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* const app =
        program.add_subcommand("check", "Is a ray tree from another tracer right?");
    app->footer(examples);
    app->add_option("SUBMISSION", arguments->run.submissions,
                    "ray trees; folders or archives (zip, tar, tar.gz) of them")
        ->option_text(" ");
    add_value(*app, "--scene", "SCENE", "the scene that the trees are of",
              [arguments](const std::string& text) { arguments->scene.file = text; });
    add_judging(*app, arguments);
    add_reporting(*app, arguments);
    add_scene_options(*app, arguments->scene);
    return {app, [arguments] { return check(*arguments); }};
}

}  // namespace raytree::cli
