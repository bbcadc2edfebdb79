#pragma once

#include <string>
#include <string_view>

namespace raytree::check {

/// A lesson of the lecture, by its number; its folder is lessons/NN-....
struct Lesson {
    int number;
    std::string_view title;
    /// "09 The reflected direction"
    std::string name() const;
};

/// The lesson that shows what a mistake of the catalogue gets wrong.
const Lesson& lesson_of(std::string_view mistake);

}  // namespace raytree::check
