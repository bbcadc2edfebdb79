#include "trace/render.h"

#include <array>
#include <filesystem>
#include <memory>

#include "command.h"
#include "counts.h"
#include "formats/image.h"
#include "formats/output_file.h"
#include "map_picture.h"
#include "progress.h"
#include "scene_arguments.h"
#include "values.h"

namespace raytree::cli {
namespace {

constexpr const char* examples =
    "Examples:\n"
    "  raytree render scene.json -o picture.png                     the picture\n"
    "  raytree render scene.json -o picture.png --size 1920x1080    larger\n"
    "  raytree render scene.json -o rays.png --map rays             how many rays each pixel took\n"
    "  raytree render scene.json -o e.png --map error --size 97x61  what rounding does to each\n"
    "  raytree render scene.json -o picture.pfm --counts rays.json  exact numbers, and all counts";

constexpr std::array<std::string_view, 3> image_words = {"png", "ppm", "pfm"};

struct Arguments {
    SceneArguments scene;
    std::string output;
    std::string counts;
    MapChoice map;
    Precision precision = Precision::twice;
};

/// Whether an image can be written there, said before the work is done and not after.
std::string image_kind(const std::string& file) {
    if (file == "-") {
        return "png";
    }
    const std::string extension = extension_of(file);
    for (const std::string_view word : image_words) {
        if (extension == word) {
            return extension;
        }
    }
    throw wrong_value("the picture's name", file, "one that ends in .png, .ppm or .pfm; see -o");
}

/// A course text file names its picture; only the last part counts, beside the scene.
std::string output_of(const Arguments& arguments, const LoadedScene& loaded) {
    if (!arguments.output.empty()) {
        return arguments.output;
    }
    if (!loaded.output) {
        throw Misuse("-o IMAGE is required: " + arguments.scene.file +
                     " does not name a picture itself");
    }
    const std::filesystem::path name = std::filesystem::path(*loaded.output).filename();
    return (std::filesystem::path(arguments.scene.file).parent_path() / name).string();
}

void expect_outputs(const std::string& output, const Arguments& arguments) {
    expect_writable(output, arguments.scene.file);
    if (!arguments.counts.empty()) {
        expect_writable(arguments.counts, arguments.scene.file);
    }
    if (arguments.map.error && !arguments.counts.empty()) {
        throw Misuse(
            "--counts goes with the other maps, not with --map error, which traces "
            "every pixel in two arithmetics");
    }
    if (arguments.counts == output) {
        throw Misuse("-o and --counts both name " + output + "; they need a file each");
    }
}

std::string encoded(const Image& image, const std::string& kind) {
    return kind == "ppm" ? encode_ppm(image) : encode_png(image);
}

void say_all(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
        say(line);
    }
}

std::string picture_bytes(const Picture& picture, const Scene& scene, const std::string& kind) {
    if (kind == "pfm") {
        return encode_pfm(picture);
    }
    const QuantizedPicture eight_bit = quantized(picture, scene.settings.quantize);
    if (eight_bit.clamped > 0) {
        say(std::to_string(eight_bit.clamped) + " of " + std::to_string(eight_bit.image.pixels()) +
            " pixels are brighter or darker than 8 bits can show and were clamped; a .pfm keeps "
            "them as they are");
    }
    return encoded(eight_bit.image, kind);
}

std::string map_bytes(const Measurement& measured, Measure measure, const std::string& kind) {
    if (kind == "pfm") {
        say_all(map_values(measured, measure));
        return encode_pfm(measured.picture.width, measured.picture.height, measured.map);
    }
    const MapPicture map = map_picture(measured, measure);
    say_all(map.legend);
    return encoded(map.image, kind);
}

std::string error_bytes(const ErrorMap& map, const std::string& kind) {
    if (kind == "pfm") {
        say(error_values(map));
        return encode_pfm(map.picture.width, map.picture.height, map.errors);
    }
    const MapPicture picture = error_picture(map);
    say_all(picture.legend);
    return encoded(picture.image, kind);
}

ErrorMap traced_twice(const Arguments& arguments, const Scene& scene) {
    Progress progress("rendering");
    const RenderOptions options{arguments.scene.threads, progress.callback()};
    const World<Quad> reference(scene);
    return with_arithmetic(arguments.precision, [&]<class T>() {
        const World<T> world(scene);
        return render_error(world, reference, options);
    });
}

Measurement traced(const Arguments& arguments, const Scene& scene) {
    Progress progress("rendering");
    const RenderOptions options{arguments.scene.threads, progress.callback()};
    return with_arithmetic(arguments.precision, [&]<class T>() {
        const World<T> world(scene);
        if (arguments.map.measure || !arguments.counts.empty()) {
            return render_measured(world, arguments.map.measure.value_or(Measure::rays), options);
        }
        return Measurement{render(world, options), {}, {}};
    });
}

int render_scene(const Arguments& arguments) {
    const LoadedScene loaded = arguments.scene.load();
    const Scene& scene = loaded.scene;
    const std::string output = output_of(arguments, loaded);
    const std::string kind = image_kind(output);
    expect_outputs(output, arguments);
    if (arguments.map.error) {
        write_output(output, error_bytes(traced_twice(arguments, scene), kind));
        return done;
    }
    const Measurement measured = traced(arguments, scene);
    const std::string bytes = arguments.map.measure
                                  ? map_bytes(measured, *arguments.map.measure, kind)
                                  : picture_bytes(measured.picture, scene, kind);
    if (!arguments.counts.empty()) {
        write_output(arguments.counts, counts_json(measured.counts));
    }
    write_output(output, bytes);
    return done;
}

}  // namespace

Command render_command(CLI::App& program) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* const app = program.add_subcommand("render", "The picture, or a map of its cost.");
    app->footer(examples);
    add_value(*app, "-o,--output", "IMAGE",
              ".png, .ppm, or .pfm with unclamped floats; - is PNG on\nstandard output "
              "(required, unless SCENE names its picture)",
              [arguments](const std::string& text) { arguments->output = text; });
    add_value(*app, "--map", "color|rays|levels|tests|time|ended|error",
              "instead of the picture, what each pixel cost, why its\ntree ended, or how far "
              "rounding has moved it from the\nreference arithmetic (slow: every pixel is traced "
              "in\nit too)",
              [arguments](const std::string& text) { arguments->map = map_named(text); });
    add_value(*app, "--counts", "FILE.json", "write how many rays of each kind there were",
              [arguments](const std::string& text) { arguments->counts = text; });
    add_precision(*app, arguments->precision);
    add_scene_arguments(*app, arguments->scene);
    return {app, [arguments] { return render_scene(*arguments); }};
}

}  // namespace raytree::cli
