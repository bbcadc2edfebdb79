#include "archive_reader.h"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>

#include "formats/output_file.h"
#include "scene/input_error.h"
#include "values.h"

namespace raytree::cli {
namespace {

std::string megabytes(std::size_t bytes) { return std::to_string(bytes >> 20) + " MB"; }

bool leads_out(const std::filesystem::path& name) {
    return name.is_absolute() || std::ranges::find(name, "..") != name.end();
}

}  // namespace

struct ArchiveReader::Handle {
    archive* of = archive_read_new();
    archive_entry* entry = nullptr;
    Handle() = default;
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() { archive_read_free(of); }

    std::string error() const {
        const char* const text = archive_error_string(of);
        return text ? text : "it is damaged";
    }
};

bool ArchiveReader::is_archive(const std::string& file) {
    const std::string extension = extension_of(file);
    return extension == "zip" || extension == "tar" || extension == "tgz" ||
           (extension == "gz" && extension_of(file.substr(0, file.size() - 3)) == "tar");
}

ArchiveReader::ArchiveReader(const std::filesystem::path& file, const ArchiveLimits& limits)
    : handle_(std::make_unique<Handle>()), limits_(limits) {
    archive_read_support_format_zip(handle_->of);
    archive_read_support_format_tar(handle_->of);
    archive_read_support_filter_gzip(handle_->of);
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) {
        throw InputError(
            file.string(), "",
            std::filesystem::exists(file, error) ? "is not a file" : "there is no such file");
    }
    const std::size_t size = std::filesystem::file_size(file, error);
    limits_.most_large_bytes =
        std::min(limits_.most_large_bytes, limits_.large_bytes + limits_.ratio * size);
    if (archive_read_open_filename(handle_->of, file.c_str(), 1 << 16) != ARCHIVE_OK) {
        throw InputError(file.string(), "",
                         "cannot be read as a zip, tar or tar.gz: " + handle_->error());
    }
}

ArchiveReader::~ArchiveReader() = default;

ArchiveEntry ArchiveReader::last(const std::string& refusal) {
    done_ = true;
    return {"", "", refusal};
}

/// Whether an entry of that size may be unpacked too; counts it.
bool ArchiveReader::has_room(std::size_t size) {
    bytes_ += size;
    large_bytes_ += size > limits_.small_entry ? size : 0;
    return bytes_ <= limits_.all_bytes && large_bytes_ <= limits_.most_large_bytes;
}

/// The next entry that is not a folder, unread.
std::optional<ArchiveEntry> ArchiveReader::step() {
    while (!done_) {
        const int status = archive_read_next_header(handle_->of, &handle_->entry);
        if (status == ARCHIVE_EOF) {
            return std::nullopt;
        }
        if (status < ARCHIVE_WARN) {
            return last("cannot be read any further: " + handle_->error());
        }
        if (++entries_ > limits_.entries) {
            return last("has more than " + std::to_string(limits_.entries) +
                        " entries; the rest is not read");
        }
        const char* const name = archive_entry_pathname(handle_->entry);
        ArchiveEntry entry{name && *name ? name : "(nameless)", "", ""};
        const bool link =
            archive_entry_symlink(handle_->entry) || archive_entry_hardlink(handle_->entry);
        const bool sized = archive_entry_size_is_set(handle_->entry) != 0;
        const auto size = sized ? static_cast<std::size_t>(
                                      std::max<la_int64_t>(0, archive_entry_size(handle_->entry)))
                                : 0;
        if (archive_entry_filetype(handle_->entry) == AE_IFDIR) {
            continue;
        }
        // To pass over an entry of a packed tar is to unpack it: after a large one nothing is read.
        if (!has_room(size)) {
            return last("unpacks to more than " +
                        megabytes(bytes_ > limits_.all_bytes ? limits_.all_bytes
                                                             : limits_.most_large_bytes) +
                        "; the rest is not read");
        }
        if (link || archive_entry_filetype(handle_->entry) != AE_IFREG) {
            entry.refusal = "is a link or a device, not a file";
        } else if (leads_out(entry.name)) {
            entry.refusal = "its name leads out of the archive";
        } else if (size > limits_.entry_bytes) {
            entry.refusal = "is " + megabytes(size) + " large; a submission may have " +
                            megabytes(limits_.entry_bytes);
        }
        return entry;
    }
    return std::nullopt;
}

void ArchiveReader::read(ArchiveEntry& entry) {
    const bool sized = archive_entry_size_is_set(handle_->entry) != 0;
    std::string buffer(1 << 16, '\0');
    for (;;) {
        const la_ssize_t count = archive_read_data(handle_->of, buffer.data(), buffer.size());
        if (count < 0) {
            entry.refusal = "cannot be unpacked: " + handle_->error();
        } else if (entry.bytes.size() + static_cast<std::size_t>(count) > limits_.entry_bytes) {
            entry.refusal = "unpacks to more than the " + megabytes(limits_.entry_bytes) +
                            " that a submission may have";
        }
        if (count <= 0 || !entry.refusal.empty()) {
            break;
        }
        entry.bytes.append(buffer, 0, static_cast<std::size_t>(count));
    }
    if (!sized && !has_room(entry.bytes.size())) {
        entry.refusal = "unpacks to more than the archive may";
    }
    if (!entry.refusal.empty()) {
        entry.bytes.clear();
    }
}

}  // namespace raytree::cli
