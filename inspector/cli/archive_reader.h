#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace raytree::cli {

/// A file of an archive, or what is wrong with it or with the archive.
struct ArchiveEntry {
    std::string name;  ///< within the archive; empty for the archive as a whole
    std::string bytes;
    std::string refusal;  ///< why there are no bytes; empty where there are
};

/// What is read of an archive, so that a hostile one is soon done with. A class packs well, as its
/// trees are much alike: small files are counted by themselves.
struct ArchiveLimits {
    std::size_t entry_bytes = std::size_t{16} << 20;
    std::size_t all_bytes = std::size_t{2} << 30;  ///< unpacked, passed over or not
    std::size_t small_entry = std::size_t{1} << 20;
    /// Unpacked, of entries that are not small: so much, so many times the archive's own size more,
    /// and at most so much.
    std::size_t large_bytes = std::size_t{32} << 20, ratio = 50;
    std::size_t most_large_bytes = std::size_t{512} << 20;
    std::size_t entries = 20'000;
};

/// Reads the plain files of a zip, tar or tar.gz one after the other. Nothing is ever written to
/// disk; folders are passed over, links and names that lead out of the archive are refused.
class ArchiveReader {
  public:
    /// Throws InputError for what is no archive.
    explicit ArchiveReader(const std::filesystem::path& file, const ArchiveLimits& limits = {});
    ~ArchiveReader();

    /// The next file of which `wanted(name)` holds; none at the end. A limit that is reached is an
    /// entry without a name, and the last.
    template <class Wanted> std::optional<ArchiveEntry> next(Wanted&& wanted) {
        while (std::optional<ArchiveEntry> entry = step()) {
            if (entry->name.empty() || wanted(entry->name)) {
                if (entry->refusal.empty()) {
                    read(*entry);
                }
                return entry;
            }
        }
        return std::nullopt;
    }

    /// Whether the file's name is that of an archive.
    static bool is_archive(const std::string& file);

  private:
    struct Handle;
    std::optional<ArchiveEntry> step();
    bool has_room(std::size_t size);
    void read(ArchiveEntry& entry);
    ArchiveEntry last(const std::string& refusal);

    std::unique_ptr<Handle> handle_;
    ArchiveLimits limits_;
    std::size_t bytes_ = 0, large_bytes_ = 0, entries_ = 0;
    bool done_ = false;
};

}  // namespace raytree::cli
