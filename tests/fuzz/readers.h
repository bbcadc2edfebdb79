#pragma once

#include <string>
#include <string_view>
#include <vector>

/// The readers of the library, each with files that it reads, and what must be true of a text that
/// it accepts.
namespace raytree::fuzz {

struct Reader {
    std::string_view name;
    std::vector<std::string> seeds;
    /// Reads `text` as the file `name_of_file`. Throws InputError where the text is refused, and
    /// std::logic_error where it is accepted and what came of it is not sound.
    void (*read)(const std::string& text);
};

inline constexpr const char* name_of_file = "fuzzed.file";

std::vector<Reader> all_readers();

}  // namespace raytree::fuzz
