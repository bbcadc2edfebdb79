#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <charconv>
#include <filesystem>
#include <memory>

#include "check/assignment.h"
#include "check/forge.h"
#include "check/telling_pixels.h"
#include "command.h"
#include "formats/json_text.h"
#include "formats/output_file.h"
#include "formats/scene_json.h"
#include "formats/tree_json.h"
#include "formats/tree_text.h"
#include "scene/input_error.h"
#include "scene_arguments.h"
#include "tree/record.h"
#include "values.h"

namespace raytree::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* examples =
    "Examples:\n"
    "  raytree assign data/assignments/mirrors.json --seed 7 --count 30 -o week5\n"
    "      week5/handout/01/ to 30/: a scene and the pixels to trace, for the students\n"
    "      week5/key/01/ to 30/: the trees, and which mistakes each pixel exposes";

struct Arguments {
    std::string file, output;
    std::uint64_t seed = 1;
    std::size_t count = 1;
    int threads = 0;
};

std::string two_digits(std::size_t number, std::size_t of) {
    const std::string digits = std::to_string(number);
    const std::size_t width = std::max<std::size_t>(2, std::to_string(of).size());
    return std::string(width - std::min(width, digits.size()), '0') + digits;
}

std::vector<const check::MistakeRow*> mistakes_to_expose(const check::Assignment& assignment) {
    std::vector<const check::MistakeRow*> rows;
    for (const check::MistakeRow& row : check::catalogue()) {
        bool wanted = assignment.exposes.empty();
        for (const std::string& begin : assignment.exposes) {
            wanted = wanted || row.id.starts_with(begin);
        }
        if (wanted) {
            rows.push_back(&row);
        }
    }
    if (rows.empty()) {
        throw InputError(assignment.file, "/exposes", "no mistake's name begins like that");
    }
    return rows;
}

std::string pixel_name(const check::PixelPlace& at) {
    return std::to_string(at.i) + ',' + std::to_string(at.j);
}

std::string pixels_json(const std::string& name, std::size_t number,
                        const std::vector<check::TellingPixel>& pixels) {
    JsonWriter json;
    json.begin_object(JsonWriter::Layout::block);
    json.member("assignment", name);
    json.member("variant", number);
    json.member("scene", "scene.json");
    json.key("pixels").begin_array();
    for (const check::TellingPixel& pixel : pixels) {
        json.numbers({pixel.at.i, pixel.at.j});
    }
    json.end_array().end_object();
    return json.take();
}

std::string task_text(const std::string& name, std::size_t number,
                      const std::vector<check::TellingPixel>& pixels) {
    std::string text = "# " + name + ", variant " + std::to_string(number) +
                       "\n\nThe scene is `scene.json`. Trace these pixels (column, row, from 0 at "
                       "the upper left) with your\nown tracer and hand in the ray tree of each as "
                       "`raytree/1.0`:\n\n";
    for (const check::TellingPixel& pixel : pixels) {
        text += "- pixel " + pixel_name(pixel.at) + ": as `" + pixel_name(pixel.at) + ".json`\n";
    }
    return text;
}

std::string key_json(std::uint64_t seed, std::size_t number,
                     const std::vector<const check::MistakeRow*>& mistakes,
                     const std::vector<check::TellingPixel>& pixels) {
    std::vector<std::string_view> hidden;
    for (const check::MistakeRow* row : mistakes) {
        const bool seen = std::ranges::any_of(pixels, [&](const check::TellingPixel& pixel) {
            return std::ranges::find(pixel.exposes, row) != pixel.exposes.end();
        });
        if (!seen) {
            hidden.push_back(row->id);
        }
    }
    JsonWriter json;
    json.begin_object(JsonWriter::Layout::block);
    json.member("seed", seed);
    json.member("variant", number);
    json.member("mistakes", mistakes.size());
    json.member("exposed", mistakes.size() - hidden.size());
    json.key("pixels").begin_array(JsonWriter::Layout::block);
    for (const check::TellingPixel& pixel : pixels) {
        json.begin_object();
        json.key("pixel").numbers({pixel.at.i, pixel.at.j});
        json.member("rays", pixel.rays);
        json.key("exposes").begin_array();
        for (const check::MistakeRow* row : pixel.exposes) {
            json.value(row->id);
        }
        json.end_array().end_object();
    }
    json.end_array();
    json.key("hidden").begin_array();
    for (const std::string_view id : hidden) {
        json.value(id);
    }
    json.end_array().end_object();
    return json.take();
}

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) {
        throw InputError(folder.string(), "", "cannot be made: " + error.message());
    }
}

/// Mesh files lie beside the scene.
void copy_meshes(const Scene& scene, const fs::path& from, const fs::path& to) {
    for (const Object& object : scene.objects) {
        if (const auto* mesh = std::get_if<Mesh>(&object.shape)) {
            const fs::path target = to / mesh->file;
            make_folder(target.parent_path());
            write_output(target.string(), read_input(from / mesh->file));
        }
    }
}

/// A mesh's file must not lead out of the folder that it is copied to.
void expect_inside(const Scene& scene, const std::string& file) {
    for (const Object& object : scene.objects) {
        const auto* mesh = std::get_if<Mesh>(&object.shape);
        const fs::path path = mesh ? fs::path(mesh->file) : fs::path();
        if (path.is_absolute() || std::ranges::find(path, "..") != path.end()) {
            throw InputError(file, "/scene/objects",
                             "the mesh file " + path.string() + " must lie beside the template");
        }
    }
}

struct Made {
    check::Variant variant;
    std::vector<check::TellingPixel> pixels;
};

Made make(const check::Assignment& assignment, const Arguments& arguments,
          const std::vector<const check::MistakeRow*>& mistakes, std::size_t number) {
    Made made{check::variant_of(assignment, arguments.seed, number), {}};
    expect_inside(made.variant.scene, assignment.file);
    const check::Place place(made.variant.scene);
    check::TellingOptions options;
    options.count = assignment.pixels;
    made.pixels = check::exposing_pixels(place, mistakes, options);
    return made;
}

void write(const Made& made, const check::Assignment& assignment, const Arguments& arguments,
           const std::vector<const check::MistakeRow*>& mistakes, std::size_t number) {
    const std::string name = two_digits(number, arguments.count);
    const fs::path handout = fs::path(arguments.output) / "handout" / name;
    const fs::path key = fs::path(arguments.output) / "key" / name;
    make_folder(handout);
    make_folder(key);
    const Scene& scene = made.variant.scene;
    copy_meshes(scene, assignment.folder, handout);
    write_output((handout / "scene.json").string(), write_scene_json(scene));
    write_output((handout / "pixels.json").string(),
                 pixels_json(assignment.name, number, made.pixels));
    write_output((handout / "task.md").string(), task_text(assignment.name, number, made.pixels));
    write_output((key / "key.json").string(),
                 key_json(arguments.seed, number, mistakes, made.pixels));
    const World<double> world(scene);
    for (const check::TellingPixel& pixel : made.pixels) {
        const RayTree<double> tree = record_tree(world, pixel.at.i, pixel.at.j);
        write_output((key / (pixel_name(pixel.at) + ".json")).string(),
                     write_tree_json(tree, &scene));
        write_output((key / (pixel_name(pixel.at) + ".txt")).string(), write_tree_text(tree));
    }
}

int assign(const Arguments& arguments) {
    const check::Assignment assignment =
        check::read_assignment(read_input(arguments.file), arguments.file);
    const auto mistakes = mistakes_to_expose(assignment);
    const std::size_t threads =
        arguments.threads > 0
            ? static_cast<std::size_t>(arguments.threads)
            : tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    std::vector<Made> all(arguments.count);
    tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t k) {
        all[k] = make(assignment, arguments, mistakes, k + 1);
    });
    for (const std::string& warning : all.front().variant.warnings) {
        say("warning: " + assignment.file + ": " + warning);
    }
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (all[k].pixels.empty()) {
            throw InputError(assignment.file, "",
                             "no pixel of variant " + std::to_string(k + 1) +
                                 " exposes any mistake; is there anything in view?");
        }
        write(all[k], assignment, arguments, mistakes, k + 1);
    }
    return done;
}

template <class Number>
Number whole(std::string_view option, const std::string& text, Number least, Number most) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < least || value > most) {
        throw wrong_value(
            option, text,
            "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
    }
    return value;
}

}  // namespace

Command assign_command(CLI::App& program) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* const app =
        program.add_subcommand("assign", "Homework: variants of a scene, pixels, and the answers.");
    app->footer(examples);
    app->add_option("TEMPLATE", arguments->file, "a scene with ranges (raytree-assignment)")
        ->option_text(" ")
        ->required();
    add_value(*app, "-o,--output", "FOLDER", "where to write (required)",
              [arguments](const std::string& text) { arguments->output = text; })
        ->required();
    add_value(*app, "--seed", "S", "the same seed gives the same bytes (default: 1)",
              [arguments](const std::string& text) {
                  arguments->seed = whole<std::uint64_t>("--seed", text, 0, (1ULL << 53));
              });
    add_value(*app, "--count", "N", "variants (default: 1)", [arguments](const std::string& text) {
        arguments->count = whole<std::size_t>("--count", text, 1, 10'000);
    });
    add_value(*app, "--threads", "N", "threads to work with (default: all cores)",
              [arguments](const std::string& text) {
                  arguments->threads = whole<int>("--threads", text, 1, 10'000);
              });
    return {app, [arguments] { return assign(*arguments); }};
}

}  // namespace raytree::cli
