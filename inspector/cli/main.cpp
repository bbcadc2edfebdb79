#include <array>
#include <exception>
#include <memory>
#include <new>

#include "command.h"
#include "help.h"
#include "scene/input_error.h"
#include "scene_arguments.h"
#include "values.h"

namespace {

using namespace raytree::cli;

constexpr const char* examples =
    "Examples:\n"
    "  raytree info scene.json                              what a scene holds\n"
    "  raytree render scene.json -o picture.png             its picture\n"
    "  raytree trace scene.json --pixel 320,240 --as text   one pixel's ray tree, to read\n"
    "  raytree trace scene.json --pixel 320,240 -o t.json   the same as data\n"
    "  raytree check tree.json --scene scene.json           is someone else's tree right?\n"
    "  raytree lesson list                                  the lessons that teach all this\n"
    "  raytree trace --help                                 all about one subcommand";

int run(int argc, char** argv) {
    CLI::App program("Traces the tree of rays behind each pixel of a picture, and shows it.",
                     "raytree");
    const auto help = std::make_shared<ExamplesFirst>();
    help->column_width(44);
    program.formatter(help);
    program.footer(examples);
    program.set_help_flag("-h,--help", "print this help");
    program.set_version_flag("--version", "raytree " RAYTREE_VERSION, "print the version");
    program.require_subcommand(1);
    const std::array commands = {
        trace_command(program),  render_command(program), info_command(program),
        check_command(program),  assign_command(program), convert_command(program),
        lesson_command(program), study_command(program),  bench_command(program)};
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& asked) {
        return program.exit(asked);
    } catch (const CLI::ParseError& error) {
        say(refusal(program, error));
        return misuse_or_bad_input;
    }
    for (const Command& command : commands) {
        if (command.app->parsed()) {
            return command.run();
        }
    }
    return misuse_or_bad_input;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const Misuse& misuse) {
        say(misuse.what());
    } catch (const raytree::InputError& error) {
        for (const raytree::Mistake& mistake : error.mistakes()) {
            say(mistake.message());
        }
    } catch (const std::bad_alloc&) {
        say("there is not enough memory for this; a smaller picture (--size), or a smaller "
            "ray_budget in the scene, needs less");
    } catch (const std::exception& error) {
        say(error.what());
    }
    return misuse_or_bad_input;
}
