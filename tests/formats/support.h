#pragma once

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/input_error.h"
#include "scene/scene.h"

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

/// Whether two scenes are the same but for the order of their materials; `why` says where not.
bool same_scene(const Scene& a, const Scene& b, std::string& why);

}  // namespace raytree::test
