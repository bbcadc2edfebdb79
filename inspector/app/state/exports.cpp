#include "state/exports.h"

#include <algorithm>
#include <initializer_list>
#include <regex>

#include "check/submission.h"
#include "formats/image.h"
#include "formats/output_file.h"
#include "formats/tree_dot.h"
#include "formats/tree_json.h"
#include "formats/tree_svg.h"
#include "formats/tree_text.h"
#include "formats/tree_vtp.h"
#include "state/commands.h"

namespace raytree::inspector {
namespace {

namespace fs = std::filesystem;

std::string written(const RayTree<double>& tree, const Scene& scene, TreeExport as) {
    switch (as) {
        case TreeExport::text:
            return write_tree_text(tree);
        case TreeExport::dot:
            return write_tree_dot(tree);
        case TreeExport::svg:
            return write_tree_svg(tree);
        case TreeExport::vtp:
            return write_tree_vtp(tree);
        default:
            return write_tree_json(tree, as == TreeExport::json_with_scene ? &scene : nullptr);
    }
}

std::string extension_of(const std::string& file) {
    std::string extension = fs::path(file).extension().string();
    std::ranges::transform(extension, extension.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return extension;
}

/// Whether a recorded tree says all that a tree's file of ours says: else a copy would make it up.
bool says_all(const check::Submission& recorded) {
    const auto gives_all = [&](std::size_t ray, std::initializer_list<Field> fields) {
        return std::ranges::all_of(fields, [&](Field f) { return recorded.gives(ray, f); });
    };
    using enum Field;
    return recorded.has_camera && recorded.has_settings &&
           std::ranges::all_of(recorded.tree.rays, [&](const TreeRay<double>& ray) {
               if (ray.shadow) {
                   return gives_all(ray.id,
                                    {origin, direction, light, transmittance, diffuse, specular});
               }
               return gives_all(ray.id, {origin, direction, weight, attenuation, intensity}) &&
                      (!ray.hit || gives_all(ray.id, {object, t, point, normal, side, cos_incident,
                                                      ambient, diffuse, specular}));
           });
}

}  // namespace

void export_tree(State& state, TreeExport as, const std::string& file) {
    if (const auto& recorded = state.tree()->recorded; recorded && !says_all(*recorded)) {
        throw InputError(recorded->file, "",
                         "this tree does not say all that an exported one says; raytree's own, "
                         "which O shows, can be exported");
    }
    expect_writable(state, file);
    state.do_beside("Writing " + fs::path(file).filename().string(), [&] {
        write_output(file, written(own_tree(*state.tree()), state.document()->scene(), as));
    });
    state.say("Written: " + file);
}

void export_scene(State& state, const std::string& file) {
    expect_writable(state, file);
    std::string message = "Written: " + file;
    state.do_beside("Writing " + fs::path(file).filename().string(), [&] {
        Scene scene = state.document()->scene();
        relocate_meshes(scene, state.document()->file().parent_path(),
                        fs::path(file).parent_path());
        for (const std::string& lost : save_scene(scene, file)) {
            message += "\nNot said in it: " + lost;
        }
    });
    state.say(std::move(message));
}

void export_picture(State& state, const Picture& picture, const std::string& file) {
    const std::string extension = extension_of(file);
    if (extension == ".pfm") {
        write_output(file, encode_pfm(picture));
        state.say("Written: " + file);
        return;
    }
    const QuantizedPicture bytes = quantized(picture, state.document()->scene().settings.quantize);
    write_output(file, extension == ".ppm" ? encode_ppm(bytes.image) : encode_png(bytes.image));
    std::string message = "Written: " + file;
    if (bytes.clamped > 0) {
        message += "\n" + std::to_string(bytes.clamped) + " of " +
                   std::to_string(bytes.image.pixels()) +
                   " pixels are brighter or darker than 8 bits can show and were clamped; a .pfm "
                   "keeps them as they are.";
    }
    state.say(std::move(message));
}

void expect_writable(const State& state, const std::string& file) {
    const std::string why = why_not_writable(file, state.document()->file().string());
    if (!why.empty()) {
        throw InputError(file, "", why);
    }
}

void expect_picture(const State& state, const std::string& file) {
    const std::string extension = extension_of(file);
    if (extension != ".png" && extension != ".ppm" && extension != ".pfm") {
        throw InputError(file, "", "a picture's name ends in .png, .ppm or .pfm");
    }
    expect_writable(state, file);
}

ViewExport view_export_from(const std::string& text) {
    constexpr int least = 64, most = 8192;
    ViewExport wish{text, std::nullopt};
    std::smatch parts;
    if (std::regex_match(text, parts, std::regex("(.*) ([0-9]{1,6})x([0-9]{1,6})"))) {
        wish.file = parts[1];
        wish.size = {std::stoi(parts[2]), std::stoi(parts[3])};
        if (std::min(wish.size->first, wish.size->second) < least ||
            std::max(wish.size->first, wish.size->second) > most) {
            throw InputError(wish.file, "",
                             "an image of the 3D view is 64 to 8192 pixels wide and high; found " +
                                 parts[2].str() + "x" + parts[3].str());
        }
    }
    if (extension_of(wish.file) != ".png") {
        throw InputError(wish.file, "", "the 3D view is written as .png");
    }
    return wish;
}

std::string suggested_name(const State& state, const Command& command) {
    std::string name = state.document()->file().stem().string();
    const Pixel pixel = state.pixel();
    if (command.id == "export.scene" || command.id == "file.save_as") {
        name += "-copy";
    } else if (command.id != "export.picture") {
        name += "-" + std::to_string(pixel.i) + "-" + std::to_string(pixel.j);
    }
    return name + "." + std::string(command.suffixes.substr(0, command.suffixes.find(' ')));
}

}  // namespace raytree::inspector
