#pragma once

#include <string>
#include <vector>

/// Programs print numbers that are none: 0 / 0, the root of a negative number, a direction of
/// length 0 made unit. JSON has no word for them; what a submission has instead (NaN, "inf", a
/// null among three numbers) tells where its program went wrong.
namespace raytree::check {

struct NotNumber {
    std::string place;  ///< "line 3, column 7"
    std::string key;    ///< that has it, such as "direction"
};

/// Puts `null`, which says nothing, where a number or one of a list of numbers is none, and gives
/// the places in the order of the text. Names (of rays, objects, lights) are left alone. Never
/// throws: of what is no JSON it changes what it can read.
std::vector<NotNumber> take_out_not_numbers(std::string& text);

}  // namespace raytree::check
