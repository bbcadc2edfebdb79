#include <cmath>
#include <filesystem>
#include <memory>
#include <mutex>
#include <numeric>

#include "folders.h"
#include "formats/scene_file.h"
#include "stress.h"
#include "tree_comparison.h"

namespace raytree::stress {
namespace {

constexpr int width = 97;
constexpr int height = 61;
constexpr std::uint64_t pixels = std::uint64_t{width} * height;

/// A scene in both arithmetics, made when its first pixel is asked for.
struct Subject {
    std::string file;
    std::once_flag made;
    std::unique_ptr<LoadedScene> loaded;
    std::unique_ptr<World<double>> own;
    std::unique_ptr<World<Quad>> reference;

    void make() {
        std::call_once(made, [this] {
            SceneOptions options;
            options.size = {width, height};
            loaded = std::make_unique<LoadedScene>(load_scene(file, options));
            own = std::make_unique<World<double>>(loaded->scene);
            reference = std::make_unique<World<Quad>>(loaded->scene);
        });
    }
};

bool is_scene(const std::filesystem::path& file) {
    const std::string name = file.filename().string();
    if (name.find(".tree.") != std::string::npos || name == "lesson.json") {
        return false;
    }
    const auto extension = file.extension();
    return extension == ".json" || extension == ".nff" || extension == ".txt" ||
           extension == ".obj";  // a scene is made around a mesh
}

/// Every scene of the project, and those of others where they are.
std::vector<std::unique_ptr<Subject>>& subjects() {
    static std::vector<std::unique_ptr<Subject>> list = [] {
        std::vector<std::string> files;
        for (const char* folder : {RAYTREE_DATA_DIR "/scenes", RAYTREE_DATA_DIR "/meshes",
                                   RAYTREE_LESSONS_DIR, RAYTREE_SHARED_DATA_DIR}) {
            std::error_code error;
            for (std::filesystem::recursive_directory_iterator entry(folder, error), end;
                 entry != end && !error; entry.increment(error)) {
                if (is_scene(entry->path())) {
                    files.push_back(entry->path().string());
                }
            }
        }
        std::ranges::sort(files);
        std::vector<std::unique_ptr<Subject>> result;
        for (const std::string& file : files) {
            result.push_back(std::make_unique<Subject>());
            result.back()->file = file;
        }
        return result;
    }();
    return list;
}

void try_pixel(Subject& subject, int i, int j, Tally& tally) {
    subject.make();
    try_tree(*subject.own, *subject.reference, i, j, tally,
             [&](std::ostream& out) { out << subject.file << " at " << width << 'x' << height; });
}

/// The pixels of all scenes in an order in which the first few are of all scenes.
Tally run_range(std::uint64_t first, std::uint64_t trials) {
    const std::uint64_t all = subjects().size() * pixels;
    std::uint64_t stride = 1'000'003;
    while (std::gcd(stride, all) != 1) {
        ++stride;
    }
    Tally tally;
    for (; tally.trials < trials && first + tally.trials < all; ++tally.trials) {
        const std::uint64_t place = (first + tally.trials) % all * stride % all;
        const std::uint64_t pixel = place % pixels;
        try_pixel(*subjects()[place / pixels], static_cast<int>(pixel % width),
                  static_cast<int>(pixel / width), tally);
    }
    return tally;
}

}  // namespace

Row trees() {
    Row row{"trees",
            "the ray trees of every scene and mesh in `data/`, `lessons/` and, where it is, the "
            "shared data, at every pixel of 97 x 61",
            "trees",
            "the same shape as in the reference arithmetic, or marked as undecided there; every "
            "number within its bound",
            "its bound",
            100,
            subjects().size() * pixels,
            50,
            {},
            {}};
    row.run_range = run_range;
    row.in_float = false;
    return row;
}

}  // namespace raytree::stress
