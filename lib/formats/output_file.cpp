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

/// A pipe or a device, such as /dev/stdout, is written to: it cannot be replaced by a file.
bool is_special(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
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

void OutputFile::Close::operator()(std::FILE* file) const { std::fclose(file); }

OutputFile::OutputFile(std::string path) : path_(std::move(path)) {
    if (path_ == "-") {
        return;
    }
    if (fs::is_directory(path_)) {
        throw InputError(path_, "", "is a folder, not a file to write to");
    }
    std::string name = path_;
    if (!is_special(path_)) {
        target_ = resolved(path_);
        name = target_.string() + ".part" + std::to_string(::getpid());
    }
    file_.reset(std::fopen(name.c_str(), "wb"));
    if (!file_) {
        fail(path_, "cannot be written", errno);
    }
    temporary_ = target_.empty() ? fs::path() : fs::path(name);
}

OutputFile::~OutputFile() {
    std::error_code ignored;
    if (!temporary_.empty()) {
        fs::remove(temporary_, ignored);
    }
}

void OutputFile::add(std::string_view bytes) {
    std::FILE* const file = file_ ? file_.get() : stdout;
    errno = 0;
    if (std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size()) {
        fail(file_ ? path_ : "standard output", "cannot be written", errno != 0 ? errno : EIO);
    }
}

void OutputFile::finish() {
    std::FILE* const file = file_ ? file_.get() : stdout;
    errno = 0;
    if (std::fflush(file) != 0) {
        fail(file_ ? path_ : "standard output", "cannot be written", errno != 0 ? errno : EIO);
    }
    file_.reset();
    if (temporary_.empty()) {
        return;
    }
    std::error_code error;
    fs::rename(temporary_, target_, error);
    if (error) {
        fail(path_, "cannot be written", error.value());
    }
    temporary_.clear();
}

void write_output(const std::string& path, std::string_view bytes) {
    OutputFile file(path);
    file.add(bytes);
    file.finish();
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
