#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <set>
#include <vector>

#include "check/catalogue.h"
#include "check/check.h"

namespace raytree::check {

/// What one mistake, or two, would leave of a submission's differences.
struct Candidate {
    std::vector<const MistakeRow*> rows;
    LawChange way = nullptr;  ///< of a single one: how it is made
    std::size_t left = 0;     ///< causes that it does not explain
    bool explains_first = false;
    std::set<std::size_t> rays;  ///< that are wrong still
};

/// Works through a submission under changed laws and counts the causes of differences that are
/// left.
class MistakeSearch {
  public:
    /// `report` has the causes to be explained. All but it must outlive the search.
    MistakeSearch(const Place& place, const Names& names, const Laws& laws,
                  const Submission& submission, const ReplayOptions& options, const Report& report);

    bool any() const { return first_.has_value(); }
    std::size_t all() const { return all_; }                     ///< causes; at least 1
    const std::set<std::size_t>& rays() const { return rays_; }  ///< where they are

    Laws under(std::initializer_list<LawChange> changes) const;
    /// Of one mistake alone: what it leaves, counted up to `enough`.
    Candidate attempt(LawChange way, std::size_t enough) const;
    /// Of two, which are to leave nothing.
    Candidate attempt(const Laws& both) const;

  private:
    using Key = std::uint64_t;  // of a finding

    struct Left {
        Key cause;
        double error;
    };

    bool is_rounded() const;
    Candidate attempt(const Laws& changed, std::size_t enough, std::size_t close) const;
    Candidate left_by(const std::vector<Left>& causes) const;
    std::vector<Left> left_under(const Laws& laws, std::size_t enough,
                                 const Slacks* slacks = nullptr) const;

    const Place& place_;
    const Names& names_;
    const Laws& laws_;
    const Submission& submission_;
    ReplayOptions options_;
    mutable MetBefore met_before_;
    std::set<Key> held_, excused_;
    std::set<std::size_t> rays_;
    std::optional<Key> first_;
    double first_error_ = 0;
    std::size_t all_ = 1;
};

}  // namespace raytree::check
