#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace raytree {

/// A file that is written piece by piece and is there whole once `finish` is called, else not at
/// all: what was there before stays until then. "-" is standard output. Throws InputError where it
/// cannot be written.
class OutputFile {
  public:
    explicit OutputFile(std::string path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void add(std::string_view bytes);
    void finish();

  private:
    struct Close {
        void operator()(std::FILE* file) const;
    };
    std::string path_;
    std::filesystem::path target_, temporary_;  ///< empty where there is nothing to rename
    std::unique_ptr<std::FILE, Close> file_;    ///< none: standard output
};

/// Puts `bytes` into the file of that name, whole or not at all: what was there before stays until
/// all is written. "-" is standard output. Throws InputError where it cannot be written.
void write_output(const std::string& path, std::string_view bytes);

/// Why nothing could be written to the file, or why it must not be: because it is `input`, the one
/// that is being read. Empty where nothing speaks against it; said before the work and not after.
std::string why_not_writable(const std::string& path, const std::string& input);

/// All bytes of a file. Throws InputError where there is none, where it is a folder, or where it
/// cannot be read.
std::string read_input(const std::filesystem::path& path);

}  // namespace raytree
