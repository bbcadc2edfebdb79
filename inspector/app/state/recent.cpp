#include "state/recent.h"

#include <algorithm>
#include <filesystem>

namespace raytree::inspector {

RecentFiles::RecentFiles(std::vector<std::string> files) {
    for (auto file = files.rbegin(); file != files.rend(); ++file) {
        add(*file);
    }
}

void RecentFiles::add(const std::string& file) {
    std::erase(files_, file);
    files_.insert(files_.begin(), file);
    files_.resize(std::min(files_.size(), most));
}

bool is_there(const std::string& file) {
    std::error_code error;
    return std::filesystem::is_regular_file(file, error);
}

}  // namespace raytree::inspector
