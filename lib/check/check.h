#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "check/finding.h"
#include "check/replay.h"
#include "check/rulebook.h"
#include "check/telling_pixels.h"

/// Holds ray trees from someone else's tracer against the truth.
namespace raytree::check {

enum class Verdict { pass, fail, unreadable };

struct CheckOptions {
    double rtol = 1e-5;                  ///< relative, of every quantity
    Given required;                      ///< fields that every ray which can have them must give
    std::optional<std::string> profile;  ///< conventions to judge by; none: those that fit best
    std::string scene_sha256;            ///< of the scene's file, hexadecimal; may be empty
    bool course_text = false;  ///< the scene's settings are those of the course text format
    bool name_mistakes = true;
    bool suggest_pixels = false;               ///< that would tell apart what a mistake may be
    std::vector<NamedScene> suggested_scenes;  ///< others to look for such pixels in
};

/// A mistake that would give the submission's numbers.
struct NamedMistake {
    std::string id;
    bool sure = false;              ///< it explains everything, and nothing else does
    std::size_t rays = 0;           ///< that it explains and that are wrong without it
    std::vector<std::string> ties;  ///< others that explain as much
    std::string text;
    std::string topic;  ///< of the lecture
    std::string lesson;
};

struct Report {
    std::string file;
    Verdict verdict = Verdict::unreadable;
    std::string profile;
    /// In what the profile differs from the lecture, where it explains everything as far as the
    /// submission shows it. Of a profile that was asked for and does not fit: the conventions of
    /// other courses that explain everything; none where none do.
    Choices conventions;
    bool profile_asked_for = false;
    double score = 0;  ///< the share of quantities that are right
    std::vector<Finding> findings;
    std::vector<NamedMistake> mistakes;  ///< the likeliest first
    std::vector<std::string> remarks;    ///< what is said but not held against it
    std::vector<std::string> ids;        ///< the submission's names of its rays
    std::size_t rays = 0, compared = 0;
    Tally tally;
    std::string precision;
    std::string compares = "quantities";      ///< or "pixels"
    std::vector<std::string> telling_pixels;  ///< that would tell its mistakes apart

    std::size_t causes() const;
};

/// The report of a submission that is not even read.
Report refused(const std::string& name, const std::string& why);

/// Judges submissions for pixels of one scene, from several threads at once. The scene given must
/// outlive it.
class Checker {
  public:
    Checker(const Scene& scene, CheckOptions options);

    Report check(const Submission& submission) const;
    /// Never throws: what cannot be read is reported so.
    Report check_file(const std::filesystem::path& file, const std::string& name) const;
    Report check_text(const std::string& text, const std::string& name) const;
    /// The submission's tree drawn over the true one, as SVG; empty where there are not two. The
    /// report is the one of this text.
    std::string overlay(const std::string& text, const Report& report) const;

    /// The scene as the lecture has it.
    const Place& place() const { return books_.lecture().place; }
    const Scene& scene() const { return scene_; }
    const Rulebooks& rulebooks() const { return books_; }
    const CheckOptions& options() const { return options_; }

  private:
    using Truth = std::shared_ptr<const RayTree<double>>;
    Truth truth_at(const Rulebook& book, int i, int j) const;
    void judge_by_fitting(const Submission& submission, Report& report) const;
    void judge_by(const Profile& profile, const Submission& submission, Report& report) const;
    void judge(const Submission& submission, const Rulebook& book, Report& report) const;

    const Scene& scene_;
    Rulebooks books_;
    CheckOptions options_;
    mutable std::mutex mutex_;
    mutable std::unordered_map<std::string, Truth> truths_;
};

}  // namespace raytree::check
