#include "tree/schedule.h"

#include <algorithm>
#include <unordered_map>

#include "tree/explain.h"

namespace raytree {

/// What is done at a hit: a ray is sent from it, or is not.
struct Schedule::Action {
    std::optional<std::size_t> child;
    std::size_t skip = 0;
};

struct Schedule::Walk {
    const RayTree<double>& tree;
    std::vector<std::vector<Action>> actions;  ///< of each ray

    Walk(const RayTree<double>& of, std::span<const std::string> lights) : tree(of) {
        std::unordered_map<std::string_view, std::size_t> places;
        for (std::size_t k = 0; k < lights.size(); ++k) {
            places.emplace(lights[k], k);
        }
        const auto children = children_of(tree);
        actions.resize(tree.rays.size());
        for (const TreeRay<double>& ray : tree.rays) {
            actions[ray.id] = actions_of(ray, children[ray.id], places);
        }
    }

    std::vector<Action> actions_of(
        const TreeRay<double>& ray, const std::vector<std::size_t>& children,
        const std::unordered_map<std::string_view, std::size_t>& places) const {
        std::vector<std::pair<std::size_t, Action>> ranked;
        const std::size_t after_lights = places.size() + 1;
        const auto rank = [&](RayKind kind, const std::string& light) {
            if (kind == RayKind::shadow) {
                const auto place = places.find(light);
                return place == places.end() ? places.size() : place->second;
            }
            return after_lights + (kind == RayKind::refracted ? 1 : 0);
        };
        for (const std::size_t child : children) {
            const TreeRay<double>& to = tree.rays[child];
            ranked.push_back({rank(to.kind, to.shadow ? to.shadow->light : ""), {child, 0}});
        }
        for (std::size_t k = 0; k < ray.skipped.size(); ++k) {
            ranked.push_back({rank(ray.skipped[k].kind, ray.skipped[k].light), {std::nullopt, k}});
        }
        std::ranges::stable_sort(ranked, {}, &std::pair<std::size_t, Action>::first);
        std::vector<Action> sorted;
        for (const auto& [place, action] : ranked) {
            sorted.push_back(action);
        }
        return sorted;
    }
};

Schedule::Schedule(const RayTree<double>& tree, StepOrder order,
                   std::span<const std::string> lights)
    : order_(order), times_(tree.rays.size()) {
    std::size_t skips = 0;
    for (const TreeRay<double>& ray : tree.rays) {
        times_[ray.id].first_skip = skips;
        skips += ray.skipped.size();
    }
    skipped_at_.resize(skips);
    if (tree.rays.empty()) {
        return;
    }
    const Walk walk(tree, lights);
    order == StepOrder::depth_first ? go_deep(walk) : go_by_levels(walk);
}

void Schedule::add(TreeEvent event) {
    events_.push_back(event);
    Times& times = times_[event.ray];
    switch (event.kind) {
        case TreeEvent::Kind::sent:
            times.sent = events_.size();
            break;
        case TreeEvent::Kind::found:
            times.found = events_.size();
            break;
        case TreeEvent::Kind::skipped:
            skipped_at_[times.first_skip + event.skip] = events_.size();
            break;
        case TreeEvent::Kind::evaluated:
            times.evaluated = events_.size();
            break;
    }
}

/// Not recursive: a file may hold a tree of any depth.
void Schedule::go_deep(const Walk& walk) {
    using Kind = TreeEvent::Kind;
    std::vector<std::pair<std::size_t, std::size_t>>
        open;  // a ray and the place of its next action
    const auto enter = [&](std::size_t ray) {
        add({Kind::sent, ray, 0});
        add({Kind::found, ray, 0});
        open.emplace_back(ray, 0);
    };
    enter(0);
    while (!open.empty()) {
        const auto [ray, next] = open.back();
        if (next == walk.actions[ray].size()) {
            add({Kind::evaluated, ray, 0});
            open.pop_back();
            continue;
        }
        ++open.back().second;
        const Action& action = walk.actions[ray][next];
        action.child ? enter(*action.child) : add({Kind::skipped, ray, action.skip});
    }
    for (std::size_t happened = 1; happened <= events_.size(); ++happened) {
        stops_.push_back(happened);
    }
}

void Schedule::go_by_levels(const Walk& walk) {
    using Kind = TreeEvent::Kind;
    const auto stop = [this] { stops_.push_back(events_.size()); };
    std::vector<std::vector<std::size_t>> levels = {{0}};
    add({Kind::sent, 0, 0});
    stop();
    while (true) {
        std::vector<std::size_t> next;
        for (const std::size_t ray : levels.back()) {
            add({Kind::found, ray, 0});
        }
        for (const std::size_t ray : levels.back()) {
            for (const Action& action : walk.actions[ray]) {
                if (!action.child) {
                    add({Kind::skipped, ray, action.skip});
                } else if (walk.tree.rays[*action.child].kind == RayKind::shadow) {
                    add({Kind::sent, *action.child, 0});
                    add({Kind::found, *action.child, 0});
                    add({Kind::evaluated, *action.child, 0});
                } else {
                    next.push_back(*action.child);
                }
            }
        }
        stop();
        if (next.empty()) {
            break;
        }
        for (const std::size_t ray : next) {
            add({Kind::sent, ray, 0});
        }
        stop();
        levels.push_back(std::move(next));
    }
    for (auto level = levels.rbegin(); level != levels.rend(); ++level) {
        for (const std::size_t ray : *level) {
            add({Kind::evaluated, ray, 0});
        }
        stop();
    }
}

Stage Schedule::stage(std::size_t ray, std::size_t happened) const {
    if (ray >= times_.size() || happened < times_[ray].sent) {
        return Stage::unsent;
    }
    const Times& times = times_[ray];
    return happened < times.found       ? Stage::sent
           : happened < times.evaluated ? Stage::found
                                        : Stage::evaluated;
}

bool Schedule::decided(std::size_t ray, std::size_t skip, std::size_t happened) const {
    return ray < times_.size() && happened >= skipped_at_[times_[ray].first_skip + skip];
}

namespace {

/// What has come in of a ray's intensity.
Rgb<double> sum_so_far(const RayTree<double>& tree, const TreeRay<double>& ray,
                       const std::vector<std::size_t>& returned, bool has_shadow_rays) {
    Rgb<double> sum = ray.ambient;
    if (!has_shadow_rays) {  // lights shine without being asked for: shadows are off
        sum += ray.diffuse + ray.specular;
    }
    for (const std::size_t id : returned) {
        const TreeRay<double>& child = tree.rays[id];
        if (child.shadow) {
            sum += child.diffuse + child.specular;
        } else {
            const Rgb<double>& k = child.kind == RayKind::reflected ? ray.hit->kr : ray.hit->kt;
            sum += child.attenuation * (k * child.intensity);
        }
    }
    return sum;
}

}  // namespace

std::vector<OpenCall> open_calls(const RayTree<double>& tree, const Schedule& schedule,
                                 std::size_t happened) {
    struct Open {
        OpenCall call;
        std::vector<std::size_t> returned;
        bool has_shadow_rays = false;
    };
    std::vector<Open> open;
    std::unordered_map<std::size_t, std::size_t> places;
    for (const TreeRay<double>& ray : tree.rays) {
        const Stage stage = schedule.stage(ray.id, happened);
        const auto parent = ray.parent ? places.find(*ray.parent) : places.end();
        if (parent != places.end()) {
            Open& above = open[parent->second];
            above.has_shadow_rays |= ray.shadow.has_value();
            if (stage == Stage::evaluated) {
                above.returned.push_back(ray.id);
            } else if (stage != Stage::unsent && !above.call.child) {
                above.call.child = ray.id;
            }
        }
        if (stage == Stage::sent || stage == Stage::found) {
            places.emplace(ray.id, open.size());
            open.push_back({{ray.id, std::nullopt, {}}, {}, false});
        }
    }
    std::vector<OpenCall> calls;
    for (Open& one : open) {
        const TreeRay<double>& ray = tree.rays[one.call.ray];
        if (ray.hit && schedule.stage(ray.id, happened) == Stage::found) {
            one.call.sum = sum_so_far(tree, ray, one.returned, one.has_shadow_rays);
        }
        calls.push_back(one.call);
    }
    return calls;
}

}  // namespace raytree
