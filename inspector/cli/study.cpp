#include <algorithm>
#include <memory>

#include "command.h"
#include "formats/image.h"
#include "formats/output_file.h"
#include "lesson/features.h"
#include "scene_arguments.h"
#include "trace/depth_picture.h"
#include "values.h"

namespace raytree::cli {
namespace {

constexpr const char* examples =
    "Examples:\n"
    "  raytree study scene.json time                        the share of intersection\n"
    "  raytree study scene.json hierarchies --pixel 320,240\n"
    "  raytree study scene.json shower --light key --rays 100000\n"
    "  raytree study scene.json volumes --light key --pixel 320,240\n"
    "  raytree study scene.json depth --light key --depth-size 256 --depth-picture d.png\n"
    "  raytree study scene.json z_buffer primary.eye.point --pixel 320,240\n"
    "What can be asked is what lessons can refer to: see lessons/README.md.";

constexpr std::array<std::string_view, 4> hierarchy_words = {"spheres", "boxes", "octree",
                                                             "production"};

struct Arguments {
    SceneArguments scene;
    std::vector<std::string> asked;
    lesson::Pixel pixel;
    int ray = 0;
    std::string light;
    lesson::ShowerShown shower;
    lesson::DepthShown depth;
    lesson::TraversalShown traversal;
    std::string depth_picture;
};

lesson::Show shown(const Arguments& arguments) {
    lesson::Show show;
    show.pixel = arguments.pixel;
    show.ray = lesson::Expression(std::to_string(arguments.ray));
    show.traversal = arguments.traversal;
    if (!arguments.light.empty()) {
        show.shower = arguments.shower;
        show.shower->light = arguments.light;
        show.volumes = lesson::VolumesShown{arguments.light};
        show.depth = arguments.depth;
        show.depth->light = arguments.light;
    }
    return show;
}

/// Near is bright; what the light does not see is black. The sides of a cube one below the other.
void write_depth_picture(const lesson::StageWorld& world, const Arguments& arguments) {
    if (arguments.light.empty()) {
        throw Misuse("--depth-picture needs --light NAME");
    }
    const DepthPicture picture(world.world(), lesson::light_named(world.scene(), arguments.light),
                               arguments.depth.size);
    const int size = picture.size();
    const int sides = static_cast<int>(picture.sides().size());
    double nearest = Real<double>::infinity, farthest = 0;
    const auto each = [&](auto&& look) {
        for (int row = 0; row < sides * size; ++row) {
            for (int i = 0; i < size; ++i) {
                look(i, row, picture.depth({static_cast<std::size_t>(row / size), i, row % size}));
            }
        }
    };
    each([&](int, int, double depth) {
        nearest = std::min(nearest, depth);
        farthest = isfinite(depth) ? std::max(farthest, depth) : farthest;
    });
    Image image(size, sides * size);
    each([&](int i, int row, double depth) {
        const double share = farthest > nearest ? (depth - nearest) / (farthest - nearest) : 0;
        const auto grey = static_cast<std::uint8_t>(isfinite(depth) ? 255 - 215 * share : 0);
        image.set(static_cast<std::size_t>(row * size + i), grey, grey, grey);
    });
    write_output(arguments.depth_picture, encode_png(image));
}

int study(const Arguments& arguments) {
    if (!arguments.depth_picture.empty()) {
        expect_writable(arguments.depth_picture, arguments.scene.file);
    }
    const auto world = std::make_shared<const lesson::StageWorld>(
        lesson::as_it_is(arguments.scene.file, arguments.scene.load()), lesson::the_tracer());
    try {
        const auto scope = lesson::pixel_scope(world, shown(arguments), {});
        Json answers = Json::object();
        for (const std::string& asked : arguments.asked) {
            answers[asked] = lesson::Expression(asked).data(*scope);
        }
        if (!arguments.depth_picture.empty()) {
            write_depth_picture(*world, arguments);
        }
        write_output("-", answers.dump(2) + "\n");
    } catch (const lesson::ExpressionError& error) {
        throw Misuse(error.what());
    }
    return done;
}

/// A whole number from `least` on.
void add_whole(CLI::App& app, const char* name, const char* help, int& out, int least, int most) {
    add_value(app, name, "N", help, [name, &out, least, most](const std::string& text) {
        const int number = whole_number(text).value_or(least - 1);
        if (number < least || number > most) {
            throw wrong_value(
                name, text,
                "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
        }
        out = number;
    });
}

void add_real(CLI::App& app, const char* name, const char* help, double& out) {
    add_value(app, name, "X", help, [name, &out](const std::string& text) {
        const auto number = real_number(text);
        if (!number || *number < 0) {
            throw wrong_value(name, text, "a number, 0 or more");
        }
        out = *number;
    });
}

}  // namespace

Command study_command(CLI::App& program) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* const app = program.add_subcommand(
        "study", "What lessons are made of, for any scene: ask and get JSON.");
    app->footer(examples);
    add_scene_arguments(*app, arguments->scene);
    app->add_option("WHAT", arguments->asked,
                    "time, hierarchies, traversal, shower, volumes, depth,\nz_buffer, self_hits, "
                    "picture, or any expression of lessons")
        ->option_text(" ")
        ->required();
    add_value(*app, "--pixel", "I,J", "the pixel that it is about (default: 0,0)",
              [arguments](const std::string& text) {
                  const auto pixel = pair_of_numbers(text, ',');
                  if (!pixel) {
                      throw wrong_value("--pixel", text, "COLUMN,ROW, such as 320,240");
                  }
                  arguments->pixel = {pixel->first, pixel->second};
              });
    add_whole(*app, "--ray", "the ray of its tree (default: 0)", arguments->ray, 0, 1 << 30);
    add_value(*app, "--light", "NAME", "for shower, volumes and depth",
              [arguments](const std::string& text) { arguments->light = text; });
    add_whole(*app, "--rays", "of the shower (default: 1000)", arguments->shower.rays, 1,
              10'000'000);
    add_real(*app, "--eye-radius", "what of the shower counts as the eye (default: 0.1)",
             arguments->shower.eye_radius);
    add_whole(*app, "--depth-size", "pixels of the depth picture's side (default: 64)",
              arguments->depth.size, 1, 4096);
    add_real(*app, "--bias", "of the comparison of depths (default: 0)", arguments->depth.bias);
    add_value(*app, "--depth-picture", "FILE.png", "writes the depth picture",
              [arguments](const std::string& text) { arguments->depth_picture = text; });
    add_value(*app, "--hierarchy", "spheres|boxes|octree|production",
              "of the traversal (default: boxes)", [arguments](const std::string& text) {
                  arguments->traversal.kind = static_cast<lesson::HierarchyKind>(
                      one_of("--hierarchy", text, hierarchy_words));
              });
    return {app, [arguments] { return study(*arguments); }};
}

}  // namespace raytree::cli
