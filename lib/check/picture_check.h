#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "check/check.h"
#include "formats/picture_read.h"
#include "trace/render.h"

/// Holds pictures from someone else's tracer against the truth.
namespace raytree::check {

/// Pictures larger than this are refused unread.
inline constexpr std::size_t largest_picture = std::size_t{256} << 20;

/// Judges pictures of one scene, from several threads at once. The checker must outlive it.
class PictureChecker {
  public:
    explicit PictureChecker(const Checker& checker) : checker_(checker) {}

    /// Never throws: what cannot be read is reported so.
    Report check(std::string_view bytes, const std::string& name) const;
    /// The picture, the truth by the report's profile, and where they differ, side by side, as PNG;
    /// empty where it is no picture. The report is the one of these bytes.
    std::string overlay(std::string_view bytes, const Report& report) const;

  private:
    Report judge(const ReadPicture& picture, const std::string& name) const;
    Report judge_by(const Profile& profile, const ReadPicture& picture,
                    const std::string& name) const;
    const Profile& best_profile(const ReadPicture& picture) const;
    std::shared_ptr<const Picture> truth_by(const Rulebook& book) const;

    const Checker& checker_;
    mutable std::mutex mutex_;
    mutable std::map<std::string, std::shared_ptr<const Picture>> truths_;
};

}  // namespace raytree::check
