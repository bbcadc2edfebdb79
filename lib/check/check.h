#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "check/finding.h"
#include "check/laws.h"
#include "check/names.h"
#include "check/replay.h"

/// Holds ray trees from someone else's tracer against the truth.
namespace raytree::check {

enum class Verdict { pass, fail, unreadable };

struct CheckOptions {
    double rtol = 1e-5;                  ///< relative, of every quantity
    Given required;                      ///< fields that every ray which can have them must give
    std::optional<std::string> profile;  ///< conventions to judge by; none: those that fit best
    bool name_mistakes = true;
};

/// A mistake that would give the submission's numbers.
struct NamedMistake {
    std::string id;
    bool sure = false;              ///< it explains everything, and nothing else does
    std::size_t rays = 0;           ///< that it explains and that are wrong without it
    std::vector<std::string> ties;  ///< others that explain as much
    std::string text;
    std::string topic;  ///< of the lecture
};

struct Report {
    std::string file;
    Verdict verdict = Verdict::unreadable;
    std::string profile;
    double score = 0;  ///< the share of quantities that are right
    std::vector<Finding> findings;
    std::vector<NamedMistake> mistakes;  ///< the likeliest first
    std::vector<std::string> remarks;    ///< what is said but not held against it
    std::vector<std::string> ids;        ///< the submission's names of its rays
    std::size_t rays = 0, compared = 0;
    std::string precision;

    std::size_t causes() const;
};

/// Judges submissions for pixels of one scene, from several threads at once. The scene given must
/// outlive it.
class Checker {
  public:
    Checker(const Scene& scene, CheckOptions options);

    Report check(const Submission& submission) const;
    /// Never throws: what cannot be read is reported so.
    Report check_file(const std::filesystem::path& file) const;
    Report check_text(const std::string& text, const std::string& file) const;

    const Place& place() const { return place_; }

  private:
    using Truth = std::shared_ptr<const RayTree<double>>;
    Truth truth_at(const Laws& laws, const std::string& profile, int i, int j) const;
    bool check_whole(const Submission& submission, Report& report) const;
    void check_fields(const Submission& submission, Report& report) const;
    void judge(const Submission& submission, const Laws& laws, Report& report) const;

    Place place_;
    Names names_;
    CheckOptions options_;
    mutable std::mutex mutex_;
    mutable std::unordered_map<std::string, Truth> truths_;
};

}  // namespace raytree::check
