#include <unistd.h>

#include <array>
#include <cstdlib>
#include <memory>

#include "command.h"
#include "formats/output_file.h"
#include "formats/tree_dot.h"
#include "formats/tree_json.h"
#include "formats/tree_svg.h"
#include "formats/tree_template.h"
#include "formats/tree_text.h"
#include "formats/tree_vtp.h"
#include "scene_arguments.h"
#include "tree/error_bounds.h"
#include "tree/record.h"
#include "tree/tree_cast.h"
#include "values.h"

namespace raytree::cli {
namespace {

constexpr const char* examples =
    "Examples:\n"
    "  raytree trace scene.json --pixel 320,240 --as text      to read in the terminal\n"
    "  raytree trace scene.json --pixel 320,240 -o tree.json   to compare or open\n"
    "  raytree trace scene.json --pixel 320,240 -o tree.svg    as a drawing\n"
    "  raytree trace scene.json --pixel 320,240 --template --as text   an exercise on paper";

enum class TreeFormat { json, text, dot, svg, vtp };
constexpr std::array<std::string_view, 5> format_words = {"json", "text", "dot", "svg", "vtp"};

struct Arguments {
    SceneArguments scene;
    std::pair<int, int> pixel;
    std::string output = "-";
    std::optional<TreeFormat> as;
    bool embed_scene = false;
    bool empty = false;         ///< the tree without its numbers
    bool error_bounds = false;  ///< the numbers with how far off they may be
    Precision precision = Precision::twice;
};

TreeFormat format_of(const Arguments& arguments) {
    if (arguments.as) {
        return *arguments.as;
    }
    const std::string extension = extension_of(arguments.output);
    if (extension == "txt") {
        return TreeFormat::text;
    }
    for (std::size_t k = 0; k < format_words.size(); ++k) {
        if (extension == format_words[k]) {
            return static_cast<TreeFormat>(k);
        }
    }
    return TreeFormat::json;
}

/// Colours are for people: a terminal, and no wish to be without (no-color.org).
bool wants_colour(const std::string& output) {
    const char* const no_colour = std::getenv("NO_COLOR");
    return output == "-" && isatty(STDOUT_FILENO) == 1 && (!no_colour || *no_colour == '\0');
}

/// The tree to be filled in by hand.
template <class T> std::string to_fill_in(const RayTree<T>& tree, const Arguments& arguments) {
    return format_of(arguments) == TreeFormat::text
               ? write_tree_template_text(tree_cast<double>(tree))
               : write_tree_template_json(tree_cast<double>(tree));
}

/// The tree with how far off its numbers may be: of those computed in double.
template <class T>
std::string with_bounds(const RayTree<T>& tree, const Scene& scene, const Arguments& arguments) {
    const auto in_double = tree_cast<double>(tree);
    const World<double> world(scene);
    const World<Quad> reference(scene);
    const auto bounds = error_bounds(world, reference, in_double, Real<double>::unit_roundoff);
    if (format_of(arguments) == TreeFormat::text) {
        return write_tree_text(in_double,
                               {.colour = wants_colour(arguments.output), .bounds = &bounds});
    }
    return write_tree_json(in_double, arguments.embed_scene ? &scene : nullptr, &bounds);
}

template <class T>
std::string written(const RayTree<T>& tree, const Scene& scene, const Arguments& arguments) {
    if (arguments.empty) {
        return to_fill_in(tree, arguments);
    }
    if (arguments.error_bounds) {
        return with_bounds(tree, scene, arguments);
    }
    switch (format_of(arguments)) {
        case TreeFormat::text:
            return write_tree_text(tree_cast<double>(tree),
                                   {.colour = wants_colour(arguments.output)});
        case TreeFormat::dot:
            return write_tree_dot(tree_cast<double>(tree));
        case TreeFormat::svg:
            return write_tree_svg(tree_cast<double>(tree));
        case TreeFormat::vtp:
            return write_tree_vtp(tree_cast<double>(tree));
        default:
            return write_tree_json(tree, arguments.embed_scene ? &scene : nullptr);
    }
}

void expect_sense(const Arguments& arguments) {
    const TreeFormat as = format_of(arguments);
    if (arguments.empty && as != TreeFormat::json && as != TreeFormat::text) {
        throw Misuse("--template is written as json or as text only");
    }
    if (arguments.empty && arguments.embed_scene) {
        throw Misuse("--template and --embed-scene do not go together");
    }
    if (!arguments.error_bounds) {
        return;
    }
    if (arguments.empty) {
        throw Misuse("--template and --error-bounds do not go together");
    }
    if (as != TreeFormat::json && as != TreeFormat::text) {
        throw Misuse("--error-bounds is written as json or as text only");
    }
    if (arguments.precision != Precision::twice) {
        throw Misuse("--error-bounds are those of --precision double");
    }
}

int trace(const Arguments& arguments) {
    expect_sense(arguments);
    expect_writable(arguments.output, arguments.scene.file);
    const LoadedScene loaded = arguments.scene.load();
    const std::string text = with_arithmetic(arguments.precision, [&]<class T>() {
        const World<T> world(loaded.scene, Build::where_rays_go);
        RayTree<T> tree = record_tree(world, arguments.pixel.first, arguments.pixel.second);
        tree.scene_sha256 = loaded.sha256;
        return written(tree, loaded.scene, arguments);
    });
    write_output(arguments.output, text);
    return done;
}

}  // namespace

Command trace_command(CLI::App& program) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* const app = program.add_subcommand("trace", "One pixel's ray tree.");
    app->footer(examples);
    add_value(*app, "--pixel", "I,J",
              "column from the left and row from the top, from 0\n(required)",
              [arguments](const std::string& text) {
                  const auto pixel = pair_of_numbers(text, ',');
                  if (!pixel) {
                      throw wrong_value("--pixel", text,
                                        "COLUMN,ROW, two whole numbers from 0, such as 320,240");
                  }
                  arguments->pixel = *pixel;
              })
        ->required();
    add_value(*app, "-o,--output", "FILE", "where to write; - is standard output, the default",
              [arguments](const std::string& text) { arguments->output = text; });
    add_value(*app, "--as", "json|text|dot|svg|vtp",
              "what to write (default: what FILE's extension says,\nelse json)",
              [arguments](const std::string& text) {
                  arguments->as = static_cast<TreeFormat>(one_of("--as", text, format_words));
              });
    app->add_flag("--embed-scene", arguments->embed_scene, "put the whole scene into the json");
    app->add_flag("--template", arguments->empty,
                  "the rays without their numbers, to be filled in by hand\n(json or text)");
    app->add_flag("--error-bounds", arguments->error_bounds,
                  "with each number how far off it may be, and which rays\ncould have gone either "
                  "way (json or text)");
    add_precision(*app, arguments->precision);
    add_scene_arguments(*app, arguments->scene);
    return {app, [arguments] { return trace(*arguments); }};
}

}  // namespace raytree::cli
