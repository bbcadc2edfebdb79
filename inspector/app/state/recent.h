#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace raytree::inspector {

/// Files that were open, the last one first, each once.
class RecentFiles {
  public:
    static constexpr std::size_t most = 10;

    RecentFiles() = default;
    explicit RecentFiles(std::vector<std::string> files);
    void add(const std::string& file);
    void clear() { files_.clear(); }
    const std::vector<std::string>& files() const { return files_; }

  private:
    std::vector<std::string> files_;
};

/// Whether the file can be opened still.
bool is_there(const std::string& file);

}  // namespace raytree::inspector
