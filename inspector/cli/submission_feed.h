#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "archive_reader.h"

namespace raytree::cli {

/// A submission as it was handed in: a file that is still to be read, or the text of one.
struct Handed {
    std::string name;  ///< in the report
    std::filesystem::path file;
    std::optional<std::string> text;
    std::string refusal;  ///< why it is not judged; empty where it is
    bool is_picture = false;
};

/// "submission-00007"
std::string anonymous_name(std::size_t number);

/// Hands out the submissions of files, folders and archives one by one, in the order of their names
/// whatever order they are given in.
class SubmissionFeed {
  public:
    /// `anonymous`: numbers instead of names. Throws InputError for a folder without submissions.
    SubmissionFeed(const std::vector<std::string>& named, bool anonymous);
    std::optional<Handed> next();

  private:
    Handed named(Handed handed);
    std::optional<Handed> from_archive();

    std::vector<std::string> files_;              ///< not paths, which take ten times the memory
    std::map<std::string, std::string> refused_;  ///< of these: why
    std::size_t at_ = 0;
    bool anonymous_;
    std::size_t handed_out_ = 0;
    std::unique_ptr<ArchiveReader> archive_;
    std::string archive_name_;
    bool any_in_archive_ = false;
};

}  // namespace raytree::cli
