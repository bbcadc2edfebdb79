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

/// Whether a link inside `folder` leads out of it, or nowhere.
bool leads_out(const fs::path& link, const fs::path& folder) {
    std::error_code error;
    const fs::path target = fs::canonical(link, error);
    const fs::path inside = error ? fs::path() : fs::canonical(folder, error);
    return error || std::ranges::mismatch(inside, target).in1 != inside.end();
}

/// What a folder holds: trees and archives; where it has none, pictures. What cannot be read stands
/// with the reason among them.
struct FolderWalk {
    std::string top;
    std::vector<std::string> trees{}, pictures{};
    std::map<std::string, std::string> refused{};

    void walk(const std::string& folder) {
        std::error_code error;
        fs::directory_iterator entries(folder, error);
        for (; !error && entries != fs::directory_iterator(); entries.increment(error)) {
            see(*entries);
        }
        if (error) {
            refuse(folder, "cannot be read: " + error.message());
        }
    }

  private:
    void refuse(const std::string& name, const std::string& why) {
        trees.push_back(name);
        refused[name] = why;
    }
    void see(const fs::directory_entry& entry) {
        const std::string name = entry.path().string();
        std::error_code error;
        const bool is_link = entry.is_symlink(error);
        const bool is_folder = entry.is_directory(error);
        const bool tree = is_tree(name) || ArchiveReader::is_archive(name);
        if (is_hidden(name)) {
            return;
        }
        if (is_link && (is_folder || ((tree || is_picture(name)) && leads_out(name, top)))) {
            refuse(name, is_folder ? "is a link to a folder; it is not followed"
                                   : "is a link to what is not in the folder; it is not followed");
        } else if (is_folder) {
            walk(name);
        } else if (tree) {
            trees.push_back(name);
        } else if (is_picture(name)) {
            pictures.push_back(name);
        }
    }
};

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
        FolderWalk folder{name};
        folder.walk(name);
        const std::vector<std::string>& inside =
            folder.trees.empty() ? folder.pictures : folder.trees;
        if (inside.empty()) {
            throw InputError(name, "", "has no .json files in it");
        }
        files_.insert(files_.end(), inside.begin(), inside.end());
        refused_.merge(folder.refused);
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
        const auto refused = refused_.find(file);
        if (refused != refused_.end()) {
            handed.refusal = refused->second;
            return named(std::move(handed));
        }
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
