#include "formats/output_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include "scene/input_error.h"

namespace raytree {
namespace {

namespace fs = std::filesystem;

struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

[[noreturn]] void fail(const std::string& path, const std::string& what, int error) {
    throw InputError(path, "", what + ": " + std::strerror(error));
}

void write_all(std::FILE* file, std::string_view bytes, const std::string& path) {
    errno = 0;
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    if (!written || std::fflush(file) != 0) {
        fail(path, "cannot be written", errno != 0 ? errno : EIO);
    }
}

/// Removes the file when it goes out of scope, unless it was kept.
struct Temporary {
    fs::path path;
    bool kept = false;
    ~Temporary() {
        std::error_code ignored;
        if (!kept) {
            fs::remove(path, ignored);
        }
    }
};

/// A pipe or a device, such as /dev/stdout, is written to: it cannot be replaced by a file.
bool is_special(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

void write_directly(const std::string& path, std::string_view bytes) {
    const File file(std::fopen(path.c_str(), "wb"));
    if (!file) {
        fail(path, "cannot be written", errno);
    }
    write_all(file.get(), bytes, path);
}

/// The file that a link leads to, so that it is the target that is replaced and not the link.
fs::path resolved(const fs::path& path) {
    std::error_code error;
    const fs::path target = fs::weakly_canonical(path, error);
    return error ? path : target;
}

}  // namespace

std::string why_not_writable(const std::string& path, const std::string& input) {
    std::error_code error;
    if (path == "-") {
        return {};
    }
    if (fs::is_directory(path, error)) {
        return "is a folder, not a file to write to";
    }
    if (fs::equivalent(path, input, error)) {
        return "is the scene itself, which would be lost; give another name";
    }
    const fs::path folder = fs::path(path).parent_path();
    if (!folder.empty() && !fs::is_directory(folder, error)) {
        return "cannot be written: there is no folder " + folder.string();
    }
    return {};
}

void write_output(const std::string& path, std::string_view bytes) {
    if (path == "-") {
        write_all(stdout, bytes, "standard output");
        return;
    }
    if (is_special(path)) {
        write_directly(path, bytes);
        return;
    }
    if (fs::is_directory(path)) {
        throw InputError(path, "", "is a folder, not a file to write to");
    }
    const fs::path target = resolved(path);
    Temporary temporary{target.string() + ".part" + std::to_string(::getpid())};
    {
        const File file(std::fopen(temporary.path.c_str(), "wb"));
        if (!file) {
            const int error = errno;
            temporary.kept = true;  // there is none
            fail(path, "cannot be written", error);
        }
        write_all(file.get(), bytes, path);
    }
    std::error_code error;
    fs::rename(temporary.path, target, error);
    if (error) {
        fail(path, "cannot be written", error.value());
    }
    temporary.kept = true;
}

std::string read_input(const fs::path& path) {
    std::error_code error;
    if (fs::is_directory(path, error)) {
        throw InputError(path.string(), "", "is a folder, not a file");
    }
    const File file(std::fopen(path.c_str(), "rb"));
    if (!file) {
        throw InputError(path.string(), "",
                         errno == ENOENT ? "there is no such file"
                                         : std::string("cannot be read: ") + std::strerror(errno));
    }
    std::string bytes;
    const auto size = fs::file_size(path, error);
    bytes.reserve(error ? 0 : size + 1);
    std::string buffer(1 << 16, '\0');
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file.get())) {
        bytes.append(buffer, 0, count);
    }
    if (std::ferror(file.get()) != 0) {
        throw InputError(path.string(), "", std::string("cannot be read: ") + std::strerror(errno));
    }
    return bytes;
}

}  // namespace raytree
