#include "state/document.h"

#include <charconv>
#include <cmath>

#include "formats/output_file.h"
#include "formats/tree_json.h"
#include "scene/validate.h"
#include "tree/explain.h"
#include "tree/record.h"

namespace raytree::inspector {
namespace {

namespace fs = std::filesystem;

/// Whether JSON text says `"format": "raytree/…"` somewhere, as only ray trees do.
bool says_tree(std::string_view text) {
    constexpr std::string_view key = "\"format\"", value = "\"raytree/", blanks = " \t\r\n";
    for (std::size_t at = text.find(key); at != std::string_view::npos;
         at = text.find(key, at + 1)) {
        std::size_t next = text.find_first_not_of(blanks, at + key.size());
        if (next == std::string_view::npos || text[next] != ':') {
            continue;
        }
        next = text.find_first_not_of(blanks, next + 1);
        if (next != std::string_view::npos && text.substr(next).starts_with(value)) {
            return true;
        }
    }
    return false;
}

/// The scene that the tree was traced in, with the camera and settings that the tree says.
LoadedScene scene_of(ReadTree& read, const fs::path& file,
                     const std::optional<fs::path>& scene_of_tree) {
    LoadedScene loaded;
    if (read.scene) {
        loaded.scene = std::move(*read.scene);
        loaded.sha256 = read.tree.scene_sha256;
    } else if (scene_of_tree) {
        loaded = load_scene(*scene_of_tree);
    } else {
        throw SceneWanted(file.string());
    }
    if (read.has_camera) {
        loaded.scene.camera = read.tree.camera;
    }
    if (read.has_settings) {
        loaded.scene.settings = read.tree.settings;
    }
    std::vector<Mistake> mistakes = validate(loaded.scene);
    if (!mistakes.empty()) {
        for (Mistake& mistake : mistakes) {
            mistake.file = file.string();
        }
        throw InputError(std::move(mistakes));
    }
    return loaded;
}

Opened open_tree(const std::string& text, const fs::path& file,
                 const std::optional<fs::path>& scene_of_tree) {
    ReadTree read = read_tree_json(text, file);
    Opened opened;
    opened.pixel = Pixel{read.tree.pixel_i, read.tree.pixel_j};
    const bool embedded = read.scene.has_value();
    opened.document = std::make_shared<Document>(embedded ? file : scene_of_tree.value_or(file),
                                                 scene_of(read, file, scene_of_tree));
    if (!opened.document->contains(*opened.pixel)) {
        throw InputError(file.string(), "/pixel",
                         "pixel " + text_of(*opened.pixel) + " lies outside the scene's picture");
    }
    opened.recorded =
        std::make_shared<const check::Submission>(check::parse_submission(text, file.string()));
    opened.notes = opened.recorded->remarks;
    opened.scene_inside = embedded;
    return opened;
}

}  // namespace

Pixel pixel_from(std::string_view text) {
    Pixel pixel;
    const char* const end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, pixel.i);
    if (first.ec == std::errc() && first.ptr != end && *first.ptr == ',') {
        const auto second = std::from_chars(first.ptr + 1, end, pixel.j);
        if (second.ec == std::errc() && second.ptr == end) {
            return pixel;
        }
    }
    throw InputError("", "",
                     "a pixel is written I,J, column and row from 0, such as 320,240; found '" +
                         std::string(text) + "'");
}

std::string text_of(Pixel pixel) { return std::to_string(pixel.i) + "," + std::to_string(pixel.j); }

Document::Document(std::filesystem::path file, LoadedScene loaded)
    : file_(std::move(file)),
      loaded_(std::move(loaded)),
      world_(loaded_.scene, Build::where_rays_go) {}

const World<Quad>& Document::reference() const {
    std::call_once(reference_asked_, [this] { reference_.emplace(loaded_.scene); });
    return *reference_;
}

bool Document::contains(Pixel pixel) const {
    const Camera& camera = scene().camera;
    return pixel.i >= 0 && pixel.j >= 0 && pixel.i < camera.width && pixel.j < camera.height;
}

std::shared_ptr<const Document> with_values(const std::shared_ptr<const Document>& document,
                                            const Values& values) {
    const LoadedScene& old = document->loaded();
    LoadedScene loaded{old.scene, old.format, {}, old.warnings, old.output};
    put(values, loaded.scene);
    return std::make_shared<const Document>(document->file(), std::move(loaded));
}

SceneWanted::SceneWanted(std::string file)
    : InputError(std::move(file), "",
                 "this ray tree does not hold its scene (scene.document); the scene is wanted as "
                 "well") {}

Opened open_file(const fs::path& file, const std::optional<fs::path>& scene_of_tree) {
    if (file.extension() == ".json") {
        const std::string text = read_input(file);
        if (says_tree(text)) {
            return open_tree(text, file, scene_of_tree);
        }
    }
    LoadedScene loaded = load_scene(file);
    std::vector<std::string> notes = loaded.warnings;
    return {std::make_shared<Document>(file, std::move(loaded)), std::nullopt, std::move(notes)};
}

std::shared_ptr<const check::Submission> read_recorded(const fs::path& file) {
    return std::make_shared<const check::Submission>(
        check::parse_submission(check::load_submission_text(file), file.string()));
}

}  // namespace raytree::inspector
