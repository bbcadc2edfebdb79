#include "accuracy/scene_files.h"

#include <algorithm>

#include "folders.h"

namespace raytree::bench {

std::vector<std::pair<std::string, std::filesystem::path>> accuracy_scenes(
    const std::string& shared_data) {
    std::vector<std::pair<std::string, std::filesystem::path>> files;
    const std::filesystem::path lessons = RAYTREE_LESSONS_DIR;
    const std::filesystem::path others = std::filesystem::path(shared_data) / "nff";
    const std::filesystem::path own = std::filesystem::path(RAYTREE_DATA_DIR) / "scenes";
    for (const std::filesystem::path& folder : {lessons, own, others}) {
        std::error_code none;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, none)) {
            const std::filesystem::path& file = entry.path();
            const std::string name = file.filename().string();
            const bool is_scene = file.extension() == ".json" || file.extension() == ".nff";
            if (is_scene && name != "lesson.json" && !name.ends_with(".tree.json")) {
                const std::string prefix = folder == lessons
                                               ? file.parent_path().filename().string() + "-"
                                           : folder == others ? "spd-"
                                                              : "";
                files.emplace_back(prefix + file.stem().string(), file);
            }
        }
    }
    std::ranges::sort(files);
    return files;
}

}  // namespace raytree::bench
