#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "check/submission.h"
#include "formats/scene_file.h"
#include "scene/input_error.h"
#include "state/knobs.h"
#include "trace/world.h"

namespace raytree::inspector {

/// Column from the left and row from the top, both from 0.
struct Pixel {
    int i = 0;
    int j = 0;
    friend bool operator==(const Pixel&, const Pixel&) = default;
};

/// "320,240": what the command line and commands take. Throws InputError for anything else.
Pixel pixel_from(std::string_view text);
std::string text_of(Pixel pixel);

/// A scene that is open, prepared for tracing. It never changes.
class Document {
  public:
    Document(std::filesystem::path file, LoadedScene loaded);
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;

    const std::filesystem::path& file() const { return file_; }
    const LoadedScene& loaded() const { return loaded_; }
    const Scene& scene() const { return loaded_.scene; }
    const World<double>& world() const { return world_; }
    /// The same world in the arithmetic that errors are measured by; made when it is first asked
    /// for, from any thread.
    const World<Quad>& reference() const;

    bool contains(Pixel pixel) const;

  private:
    std::filesystem::path file_;
    LoadedScene loaded_;
    World<double> world_;
    mutable std::once_flag reference_asked_;
    mutable std::optional<World<Quad>> reference_;
};

/// The same scene with other values.
std::shared_ptr<const Document> with_values(const std::shared_ptr<const Document>& document,
                                            const Values& values);

/// What opening a file gave.
struct Opened {
    std::shared_ptr<const Document> document;
    std::optional<Pixel> pixel;      ///< the one of a tree's file
    std::vector<std::string> notes;  ///< for people, a sentence each
    /// Of a tree's file: the tree as it says.
    std::shared_ptr<const check::Submission> recorded = nullptr;
    bool scene_inside = false;  ///< the scene is part of the tree's file
};

/// A tree's file that does not hold its scene, opened without one.
class SceneWanted : public InputError {
  public:
    explicit SceneWanted(std::string file);
};

/// Opens a scene in any format, or a ray tree (raytree/1.0) as it is recorded, with its scene.
/// `scene_of_tree` is where the scene is when the tree's file does not hold it. Throws InputError.
Opened open_file(const std::filesystem::path& file,
                 const std::optional<std::filesystem::path>& scene_of_tree = {});

/// A tree as somebody has recorded it. Throws InputError.
std::shared_ptr<const check::Submission> read_recorded(const std::filesystem::path& file);

}  // namespace raytree::inspector
