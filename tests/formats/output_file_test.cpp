#include "formats/output_file.h"

#include <fstream>

#include "formats/support.h"

namespace raytree {
namespace {

using test::refusal_of;
using test::ScratchFolder;
using test::text_of;

TEST_CASE("a file is written and read back byte for byte") {
    const ScratchFolder folder;
    const std::string bytes("a\0\r\n\xFF", 5);
    write_output(folder.path("x.bin").string(), bytes);
    CHECK(read_input(folder.path("x.bin")) == bytes);
    write_output(folder.path("x.bin").string(), "shorter");
    CHECK(read_input(folder.path("x.bin")) == "shorter");
    CHECK(folder.files() == std::vector<std::string>{"x.bin"});
}

TEST_CASE("where nothing can be written, nothing is") {
    const ScratchFolder folder;
    const auto missing = folder.path("missing") / "x.json";
    const std::string text = refusal_of([&] { write_output(missing.string(), "x"); });
    CHECK_CONTAINS(text, missing.string());
    CHECK_CONTAINS(text, "cannot be written: No such file or directory");
    std::filesystem::create_directory(folder.path("sub"));
    CHECK_CONTAINS(refusal_of([&] { write_output(folder.path("sub").string(), "x"); }),
                   "is a folder");
    CHECK(folder.files() == std::vector<std::string>{"sub"});
}

TEST_CASE("a link stays a link") {
    const ScratchFolder folder;
    folder.write("target", "old");
    std::filesystem::create_symlink(folder.path("target"), folder.path("link"));
    write_output(folder.path("link").string(), "new");
    CHECK(std::filesystem::is_symlink(folder.path("link")));
    CHECK(text_of(folder.path("target")) == "new");
}

TEST_CASE("a device is written to, not replaced") {
    write_output("/dev/null", "x");
    CHECK(std::filesystem::is_character_file("/dev/null"));
    CHECK_CONTAINS(refusal_of([] { write_output("/dev/full", "x"); }),
                   "/dev/full: cannot be written: No space left on device");
}

TEST_CASE("a missing file, a folder and an unreadable file each have their sentence") {
    const ScratchFolder folder;
    CHECK_CONTAINS(refusal_of([&] { read_input(folder.path("none.json")); }),
                   "none.json: there is no such file");
    CHECK_CONTAINS(refusal_of([&] { read_input(folder.path("")); }), "is a folder, not a file");
    const auto locked = folder.write("locked.json", "{}");
    std::filesystem::permissions(locked, std::filesystem::perms::none);
    if (!std::ifstream(locked).good()) {  // root reads everything
        CHECK_CONTAINS(refusal_of([&] { read_input(locked); }),
                       "cannot be read: Permission denied");
    }
}

}  // namespace
}  // namespace raytree
