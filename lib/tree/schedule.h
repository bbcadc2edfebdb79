#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tree/ray_tree.h"

/// A recorded tree as something that happens, one event after the other.
namespace raytree {

enum class StepOrder {
    depth_first,    ///< as it is computed: each branch down to its end before the next
    level_by_level  ///< all rays of a level, then the next; then intensities, the deepest first
};

struct TreeEvent {
    enum class Kind {
        sent,      ///< the ray sets out
        found,     ///< what it meets is known, or that it meets nothing
        skipped,   ///< a ray is not sent from its hit: `skip` says which
        evaluated  ///< its intensity is known and returned; of a shadow ray, what the light adds
    };
    Kind kind = Kind::sent;
    std::size_t ray = 0;
    std::size_t skip = 0;  ///< place in the ray's `skipped`

    friend bool operator==(const TreeEvent&, const TreeEvent&) = default;
};

/// How much of a ray has happened.
enum class Stage { unsent, sent, found, evaluated };

/// The events of a tree. "After n events" below means after the first n of them.
class Schedule {
  public:
    Schedule() = default;
    /// `lights` are the scene's, in its order: at a hit they are asked in that order, those to
    /// which no shadow ray is sent included. Of a light that is not among them, rays come before
    /// those not sent. The tree's rays stand depth first (RayTree::rays).
    Schedule(const RayTree<double>& tree, StepOrder order,
             std::span<const std::string> lights = {});

    StepOrder order() const { return order_; }
    const std::vector<TreeEvent>& events() const { return events_; }
    /// Numbers of events after which one looks, ascending, the first 1 and the last all of them:
    /// after each event, or level by level down the tree and up again.
    const std::vector<std::size_t>& stops() const { return stops_; }

    /// Of a ray after `happened` events; one that is not in the tree is unsent.
    Stage stage(std::size_t ray, std::size_t happened) const;
    /// Whether by then it is known that the ray at this place of `skipped` is not sent.
    bool decided(std::size_t ray, std::size_t skip, std::size_t happened) const;

  private:
    struct Times {
        std::size_t sent = 0, found = 0, evaluated = 0;  ///< events with its own
        std::size_t first_skip = 0;                      ///< in skipped_at_
    };
    struct Action;
    struct Walk;
    void add(TreeEvent event);
    void go_deep(const Walk& walk);
    void go_by_levels(const Walk& walk);

    StepOrder order_ = StepOrder::depth_first;
    std::vector<TreeEvent> events_;
    std::vector<std::size_t> stops_;
    std::vector<Times> times_;
    std::vector<std::size_t> skipped_at_;
};

/// A ray whose intensity is being computed.
struct OpenCall {
    std::size_t ray = 0;
    std::optional<std::size_t> child;  ///< that it waits for; none: for its hit, or its sum
    Rgb<double> sum;  ///< of ambient light, lights and branches, as far as they are known
};

/// The rays sent and not evaluated after `happened` events, in the order of the tree: depth first,
/// the call stack, the primary ray first.
std::vector<OpenCall> open_calls(const RayTree<double>& tree, const Schedule& schedule,
                                 std::size_t happened);

}  // namespace raytree
