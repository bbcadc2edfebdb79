#include "submission_feed.h"

#include <algorithm>
#include <array>

#include "scene/input_error.h"
#include "values.h"

namespace raytree::cli {
namespace {

namespace fs = std::filesystem;

bool is_picture(const std::string& file) {
    constexpr std::array<std::string_view, 3> extensions = {"png", "ppm", "pfm"};
    return std::ranges::find(extensions, extension_of(file)) != extensions.end();
}

bool is_tree(const std::string& file) { return extension_of(file) == "json"; }

/// What programs put beside files: ".x", and "__MACOSX/._x" in archives made on a Mac.
bool is_hidden(const std::string& file) {
    return fs::path(file).filename().string().starts_with('.') ||
           file.find("__MACOSX/") != std::string::npos;
}

/// A folder's trees and archives; where it has none, its pictures.
std::vector<std::string> files_inside(const std::string& folder) {
    std::vector<std::string> trees, pictures;
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, error), end; entry != end && !error;
         entry.increment(error)) {
        const std::string name = entry->path().string();
        if (entry->is_directory(error) || is_hidden(name)) {
            continue;
        }
        if (is_tree(name) || ArchiveReader::is_archive(name)) {
            trees.push_back(name);
        } else if (is_picture(name)) {
            pictures.push_back(name);
        }
    }
    if (trees.empty() && pictures.empty()) {
        throw InputError(folder, "", "has no .json files in it");
    }
    return trees.empty() ? pictures : trees;
}

}  // namespace

std::string anonymous_name(std::size_t number) {
    const std::string digits = std::to_string(number);
    return "submission-" + std::string(digits.size() < 5 ? 5 - digits.size() : 0, '0') + digits;
}

SubmissionFeed::SubmissionFeed(const std::vector<std::string>& named, bool anonymous)
    : anonymous_(anonymous) {
    for (const std::string& name : named) {
        std::error_code error;
        if (!fs::is_directory(name, error)) {
            files_.emplace_back(name);
            continue;
        }
        const std::vector<std::string> inside = files_inside(name);
        files_.insert(files_.end(), inside.begin(), inside.end());
    }
    std::ranges::sort(files_);
    files_.erase(std::unique(files_.begin(), files_.end()), files_.end());
}

Handed SubmissionFeed::named(Handed handed) {
    handed.is_picture = is_picture(handed.name);
    ++handed_out_;
    if (anonymous_) {
        handed.name = anonymous_name(handed_out_);
    }
    return handed;
}

std::optional<Handed> SubmissionFeed::from_archive() {
    auto entry = archive_->next([](const std::string& name) {
        return (is_tree(name) || is_picture(name)) && !is_hidden(name);
    });
    if (!entry) {
        archive_.reset();
        if (any_in_archive_) {
            return std::nullopt;
        }
        entry = ArchiveEntry{"", "", "has no trees or pictures in it"};
    }
    any_in_archive_ = true;
    Handed handed;
    handed.name = archive_name_ + (entry->name.empty() ? "" : '/' + entry->name);
    handed.text = std::move(entry->bytes);
    handed.refusal = std::move(entry->refusal);
    return named(std::move(handed));
}

std::optional<Handed> SubmissionFeed::next() {
    for (;;) {
        if (archive_) {
            if (auto handed = from_archive()) {
                return handed;
            }
        }
        if (at_ == files_.size()) {
            return std::nullopt;
        }
        const std::string& file = files_[at_++];
        Handed handed;
        handed.name = file;
        handed.file = file;
        if (!ArchiveReader::is_archive(handed.name)) {
            return named(std::move(handed));
        }
        archive_name_ = handed.name;
        try {
            archive_ = std::make_unique<ArchiveReader>(file);
            any_in_archive_ = false;
        } catch (const InputError& error) {
            handed.refusal = error.mistakes().front().text;
            return named(std::move(handed));
        }
    }
}

}  // namespace raytree::cli
