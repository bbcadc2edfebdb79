#pragma once

#include <array>
#include <optional>
#include <vector>

#include "check/laws.h"

namespace raytree::check {

/// What the rays of a submission met when it was worked through before. Under most changes of the
/// laws they are sent as they were, and meet the same; of laws by which they meet otherwise the
/// last are remembered. Of one place only; not from several threads.
class MetBefore {
  public:
    /// As `laws.meet`, for the submission's ray of that number.
    std::optional<Hit<double>> meet(const Place& place, const Laws& laws, const Step& step,
                                    const Interval<double>& interval, std::size_t ray);
    /// As `laws.shadow`, from the hit of the submission's ray of that number.
    Passage shadow(const Place& place, const Laws& laws, const Step& step, const Shine& shine,
                   std::size_t ray);

  private:
    struct Sent {
        std::array<double, 8> numbers{};     ///< origin, direction, from and to where
        PrimitiveId leaving = no_primitive;  ///< that it starts on
        PrimitiveId sender = no_primitive;   ///< that its parent hit
        bool is_primary = false;
        bool operator==(const Sent&) const = default;
    };
    template <class Met> struct Entry {
        bool known = false;
        Sent sent;
        Met met{};
    };
    template <class Met, class Find> static Met from(std::vector<Entry<Met>>& entries,
                                                     std::size_t place, const Sent& sent,
                                                     Find find);

    static constexpr std::size_t most_ = 4096;  // rays, and shadow rays, of which it is remembered
    std::vector<Entry<std::optional<Hit<double>>>> hits_, other_hits_;
    decltype(Laws::meet) other_meet_ = nullptr;  ///< by which those are met
    std::vector<Entry<Passage>> passages_;
};

}  // namespace raytree::check
