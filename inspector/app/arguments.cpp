#include "arguments.h"

#include <charconv>
#include <sstream>

#include "formats/output_file.h"

namespace raytree::inspector {
namespace {

[[noreturn]] void misuse(const std::string& text) {
    throw InputError("", "", text + " (see raytree-inspector --help)");
}

std::pair<int, int> size_from(const std::string& text) {
    std::pair<int, int> size;
    const char* const end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.first);
    if (width.ec == std::errc() && width.ptr != end && *width.ptr == 'x') {
        const auto height = std::from_chars(width.ptr + 1, end, size.second);
        const auto good = [](int n) { return n >= 640 && n <= 7680; };
        if (height.ec == std::errc() && height.ptr == end && good(size.first) &&
            good(size.second)) {
            return size;
        }
    }
    misuse("--size is WxH, each from 640 to 7680; found '" + text + "'");
}

int step_from(const std::string& text) {
    int step = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, step);
    if (read.ec != std::errc() || read.ptr != end || step < 1) {
        misuse("--step is a whole number from 1; found '" + text + "'");
    }
    return step;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    return lines;
}

Theme theme_from(const std::string& text) {
    if (text == "light" || text == "dark") {
        return text == "light" ? Theme::light : Theme::dark;
    }
    misuse("--theme is light or dark; found '" + text + "'");
}

void take_option(Arguments& arguments, const std::string& option, const std::string& value) {
    if (option == "--pixel") {
        arguments.pixel = pixel_from(value);
    } else if (option == "--scene") {
        arguments.scene = value;
    } else if (option == "--lesson") {
        arguments.lesson = value;
    } else if (option == "--lessons") {
        arguments.lessons = value;
    } else if (option == "--step") {
        arguments.step = step_from(value);
    } else if (option == "--compare") {
        arguments.compare = value;
    } else if (option == "--screenshot") {
        arguments.window.screenshot = value;
    } else if (option == "--contact-sheet") {
        arguments.window.contact_sheet = value;
    } else if (option == "--script") {
        arguments.window.script = lines_of(read_input(value));
        arguments.window.script_file = value;
    } else if (option == "--size") {
        std::tie(arguments.window.width, arguments.window.height) = size_from(value);
    } else if (option == "--theme") {
        arguments.theme = theme_from(value);
    } else {
        misuse("there is no option " + option);
    }
}

}  // namespace

Arguments parse_arguments(std::span<char* const> words) {
    Arguments arguments;
    for (std::size_t k = 0; k < words.size(); ++k) {
        const std::string word = words[k];
        if (word == "--help" || word == "-h") {
            arguments.help = true;
        } else if (word == "--version") {
            arguments.version = true;
        } else if (word.starts_with("--")) {
            const std::size_t equals = word.find('=');
            const std::string option = word.substr(0, equals);
            if (equals != std::string::npos) {
                take_option(arguments, option, word.substr(equals + 1));
            } else {
                take_option(arguments, option, k + 1 < words.size() ? words[k + 1] : "");
                ++k;
            }
        } else if (!arguments.file) {
            arguments.file = word;
        } else {
            misuse("one file at a time: " + arguments.file->string() + " or " + word);
        }
    }
    return arguments;
}

std::string help_text() {
    return R"(Examples:
  raytree-inspector                                       the first lesson
  raytree-inspector --lesson spheres --step 3             a step of a lesson
  raytree-inspector scene.json --pixel 320,240            a scene, at a pixel
  raytree-inspector tree.json --scene scene.json          a ray tree and its scene
  raytree-inspector scene.json --compare tree.json        a recorded tree against the true one
  raytree-inspector scene.nff --screenshot picture.png    draws the window once, into a file

Usage: raytree-inspector [SCENE | TREE.json | --lesson NAME] [OPTION...]

Shows the ray tree of a pixel: in the picture, in 3D, as an outline, and in numbers.

SCENE is a .json (raytree-scene), .nff, .txt (course text) or .obj file; TREE.json a ray tree
(raytree/1.0), which is shown as it is recorded, with raytree's own beside it.

  --compare TREE      marks what is different in a recorded tree (raytree/1.0)
  --pixel I,J         column and row of the pixel, from 0 at the top left
  --scene SCENE       the scene of a tree that does not hold it
  --lesson NAME       opens a lesson, by its name or number
  --step K            of the lesson, from 1
  --lessons FOLDER    where the lessons are (default: the program's own)
  --theme light|dark  the colours of the window
  --size WxH          the size of the window; 1280x800 unless said otherwise
  --script FILE       runs the commands in FILE, one to a line, such as: pixel.pick 320,240
  --contact-sheet FOLDER  draws every step of every lesson into files, and ends
  --screenshot FILE   draws the window, writes it as PNG, and ends
  --help, --version

In the window, ? lists all keys and commands.

Exit codes: 0 done, 2 misuse or a file that cannot be read, 3 no display to open.
)";
}

}  // namespace raytree::inspector
