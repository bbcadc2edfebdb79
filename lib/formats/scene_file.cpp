#include "formats/scene_file.h"

#include <nettle/sha2.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "formats/course_text.h"
#include "formats/nff.h"
#include "formats/obj.h"
#include "formats/output_file.h"
#include "formats/scene_json.h"
#include "scene/input_error.h"
#include "scene/range_check.h"
#include "scene/validate.h"

namespace raytree {
namespace {

namespace fs = std::filesystem;

std::string sha256_of(std::string_view bytes) {
    sha256_ctx context;
    sha256_init(&context);
    sha256_update(&context, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
    std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest;
    sha256_digest(&context, digest.size(), digest.data());
    std::string text;
    for (const std::uint8_t byte : digest) {
        constexpr std::string_view digits = "0123456789abcdef";
        text += digits[byte >> 4];
        text += digits[byte & 15];
    }
    return text;
}

SceneFormat format_of(const fs::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension == ".json") {
        return SceneFormat::json;
    }
    if (extension == ".nff") {
        return SceneFormat::nff;
    }
    if (extension == ".txt") {
        return SceneFormat::course_text;
    }
    if (extension == ".obj") {
        return SceneFormat::obj;
    }
    std::error_code error;
    if (fs::is_directory(file, error)) {
        throw InputError(file.string(), "", "is a folder, not a file");
    }
    throw InputError(file.string(), "",
                     "the name does not say which scene format it is; it must end in .json, .nff, "
                     ".txt or .obj, or the format must be given");
}

void check_option(bool good, const char* option, const std::string& found, const char* allowed,
                  std::vector<Mistake>& mistakes) {
    if (!good) {
        mistakes.push_back({"", option, "found " + found + ", must be " + allowed});
    }
}

/// Before the file is read: what is wrong here is wrong for every scene.
void check_options(const SceneOptions& options) {
    std::vector<Mistake> mistakes;
    if (options.size) {
        const auto [width, height] = *options.size;
        const auto is_side = [](int n) { return n >= 1 && n <= kLargestSide; };
        const bool good = is_side(width) && is_side(height) &&
                          static_cast<long long>(width) * height <= kMostPixels;
        check_option(good, "--size", std::to_string(width) + "x" + std::to_string(height),
                     "WxH with each from 1 to 65535 and at most 2^28 = 268435456 pixels", mistakes);
    }
    if (options.max_depth) {
        check_option(*options.max_depth >= 1 && *options.max_depth <= kDeepest, "--max-depth",
                     std::to_string(*options.max_depth), "a whole number from 1 to 64", mistakes);
    }
    if (options.min_weight) {
        check_option(*options.min_weight >= 0 && isfinite(*options.min_weight), "--min-weight",
                     shown_number(*options.min_weight), "a finite number, 0 or more", mistakes);
    }
    if (options.max_distance) {
        check_option(*options.max_distance > 0 && isfinite(*options.max_distance), "--max-distance",
                     shown_number(*options.max_distance), "a finite number over 0", mistakes);
    }
    if (!mistakes.empty()) {
        throw InputError(std::move(mistakes));
    }
}

void apply_options(const SceneOptions& options, Scene& scene) {
    if (options.size) {
        scene.camera.width = options.size->first;
        scene.camera.height = options.size->second;
    }
    scene.settings.max_depth = options.max_depth.value_or(scene.settings.max_depth);
    scene.settings.min_weight = options.min_weight.value_or(scene.settings.min_weight);
    if (options.max_distance) {
        scene.settings.max_distance = options.max_distance;
    }
}

void read_scene(const std::string& text, const fs::path& file, const SceneOptions& options,
                LoadedScene& loaded) {
    switch (loaded.format) {
        case SceneFormat::json:
            loaded.scene = read_scene_json(text, file, loaded.warnings);
            return;
        case SceneFormat::nff:
            loaded.scene = read_nff(text, file, options.size, loaded.warnings);
            return;
        case SceneFormat::course_text: {
            CourseScene course = read_course_text(text, file);
            loaded.scene = std::move(course.scene);
            loaded.output = std::move(course.output);
            return;
        }
        case SceneFormat::obj: {
            const auto [width, height] = options.size.value_or(std::pair(640, 480));
            loaded.scene = scene_around(read_obj(text, file, loaded.warnings), file.stem().string(),
                                        width, height);
            return;
        }
    }
}

/// Of the formats whose readers leave it to this; read_scene_json has validated already.
void validate_foreign(const Scene& scene, const fs::path& file) {
    std::vector<Mistake> mistakes = validate(scene);
    for (Mistake& mistake : mistakes) {
        mistake.file = file.string();
    }
    if (!mistakes.empty()) {
        throw InputError(std::move(mistakes));
    }
}

void add_missing_meshes(const Scene& scene, const fs::path& file, std::vector<std::string>& lost) {
    for (const Object& object : scene.objects) {
        const auto* mesh = std::get_if<Mesh>(&object.shape);
        if (mesh != nullptr && !fs::exists(file.parent_path() / mesh->file)) {
            lost.push_back("The mesh " + object.name + " is written by its file's name, and from " +
                           file.string() + " there is no " + mesh->file + ".");
        }
    }
}

}  // namespace

LoadedScene load_scene(const fs::path& file, const SceneOptions& options) {
    check_options(options);
    LoadedScene loaded;
    loaded.format = options.format ? *options.format : format_of(file);
    const std::string text = read_input(file);
    loaded.sha256 = sha256_of(text);
    read_scene(text, file, options, loaded);
    if (loaded.format != SceneFormat::json) {
        validate_foreign(loaded.scene, file);
    }
    apply_options(options, loaded.scene);
    return loaded;
}

void relocate_meshes(Scene& scene, const fs::path& from, const fs::path& to) {
    // The folder of a plain file name is empty, which stands for the current one.
    const auto folder = [](const fs::path& path) {
        return fs::absolute(path.empty() ? "." : path);
    };
    for (Object& object : scene.objects) {
        if (auto* mesh = std::get_if<Mesh>(&object.shape)) {
            mesh->file = fs::proximate(folder(from) / mesh->file, folder(to)).string();
        }
    }
}

std::vector<std::string> save_scene(const Scene& scene, const fs::path& file) {
    std::vector<std::string> lost;
    std::string text;
    switch (format_of(file)) {
        case SceneFormat::json:
            text = write_scene_json(scene);
            add_missing_meshes(scene, file, lost);
            break;
        case SceneFormat::nff:
            text = write_nff(scene, lost);
            break;
        case SceneFormat::course_text:
            text = write_course_text(scene, file.stem().string() + ".ppm", lost);
            break;
        case SceneFormat::obj:
            throw InputError(file.string(), "",
                             "scenes are not written as .obj; .json, .nff and .txt are");
    }
    write_output(file.string(), text);
    return lost;
}

}  // namespace raytree
