#pragma once

#include <doctest/doctest.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "scene/input_error.h"

/// What tests of file formats share.
namespace raytree::test {

/// The mistakes that `action` reports; none if it reports none.
template <class Action> std::vector<Mistake> mistakes_of(Action action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.mistakes();
    }
    return {};
}

/// All that `action` says in its refusal; empty if it does not refuse.
template <class Action> std::string refusal_of(Action action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

inline bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

#define CHECK_CONTAINS(text, part) \
    CHECK_MESSAGE(::raytree::test::contains(text, part), "in: ", text)

/// A folder of its own for each test, gone afterwards.
class ScratchFolder {
  public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    std::filesystem::path path(std::string_view name) const { return folder_ / name; }
    std::filesystem::path write(std::string_view name, std::string_view text) const;
    std::vector<std::string> files() const;

  private:
    std::filesystem::path folder_;
};

/// All bytes of a file.
std::string text_of(const std::filesystem::path& file);

/// Files of `folder` whose names end in `extension`, sorted; none where the folder is missing.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder,
                                            std::string_view extension);

inline ScratchFolder::ScratchFolder() {
    static int count = 0;
    folder_ = std::filesystem::temp_directory_path() /
              ("raytree-test-" + std::to_string(::getpid()) + "-" + std::to_string(++count));
    std::filesystem::create_directories(folder_);
}

inline ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

inline std::filesystem::path ScratchFolder::write(std::string_view name,
                                                  std::string_view text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
}

inline std::vector<std::string> ScratchFolder::files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
        names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

inline std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

inline std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder,
                                                   std::string_view extension) {
    std::vector<std::filesystem::path> files;
    std::error_code missing;
    for (const auto& entry : std::filesystem::directory_iterator(folder, missing)) {
        if (entry.path().string().ends_with(extension)) {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace raytree::test
