#pragma once

#include <filesystem>

namespace raytree::inspector::test {

/// A folder of two lessons, 01-ball and 02-again, gone when the test is over. Both have five steps,
/// which ask for a number, a pixel, a ray, a value and a choice.
struct Lessons {
    std::filesystem::path folder;
    /// `name`: of the folder, so that tests running beside each other have one each.
    explicit Lessons(const char* name = "raytree-app-test-lessons");
    ~Lessons();
    Lessons(const Lessons&) = delete;
    Lessons& operator=(const Lessons&) = delete;
};

}  // namespace raytree::inspector::test
