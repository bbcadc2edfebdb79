#include "accuracy/scene_files.h"

#include <algorithm>

#include "folders.h"

namespace raytree::bench {

std::vector<std::pair<std::string, std::filesystem::path>> accuracy_scenes(
    const std::string& shared_data) {
    std::vector<std::pair<std::string, std::filesystem::path>> files;
    const std::filesystem::path lessons = RAYTREE_LESSONS_DIR;
    const std::filesystem::path folders[] = {lessons,
                                             std::filesystem::path(RAYTREE_DATA_DIR) / "scenes",
                                             std::filesystem::path(shared_data) / "nff"};
    for (const std::filesystem::path& folder : folders) {
        std::error_code none;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, none)) {
            const std::string name = entry.path().filename().string();
            const bool is_scene =
                entry.path().extension() == ".json" || entry.path().extension() == ".nff";
            if (is_scene && name != "lesson.json" && !name.ends_with(".tree.json")) {
                const bool of_lesson = folder == lessons;
                files.emplace_back(
                    (of_lesson ? entry.path().parent_path().filename().string() + "-" : "") +
                        entry.path().stem().string(),
                    entry.path());
            }
        }
    }
    std::ranges::sort(files);
    return files;
}

}  // namespace raytree::bench
