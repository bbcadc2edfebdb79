#include "state/ray_filter.h"

#include <algorithm>
#include <array>

#include "state/natural_order.h"
#include "state/thing.h"
#include "tree/explain.h"

namespace raytree::inspector {
namespace {

using By = RayGroup::By;

std::string plain(const RayGroup& group) {
    switch (group.by) {
        case By::kind:
            return group.name + " rays";
        case By::level:
            return "level " + group.name;
        case By::light:
            return "rays to " + group.name;
        default:
            return "rays that meet " + group.name;
    }
}

/// The groups of one ray: `visit(group)`.
template <class Visit> void for_groups(const TreeRay<double>& ray, Visit visit) {
    visit(group_of(ray.kind));
    visit(RayGroup{By::level, std::to_string(ray.level)});
    if (ray.shadow) {
        visit(RayGroup{By::light, ray.shadow->light});
    }
    if (const std::string object = met_by(ray); !object.empty()) {
        visit(RayGroup{By::object, object});
    }
}

}  // namespace

Shown RayFilter::of(const RayGroup& group) const {
    const auto found = groups.find(group);
    return found == groups.end() ? Shown::full : found->second;
}

void RayFilter::set(const RayGroup& group, Shown shown) {
    if (shown == Shown::full) {
        groups.erase(group);
    } else {
        groups[group] = shown;
    }
}

std::string_view word_of(By by) {
    constexpr std::array<std::string_view, 4> words = {"kind", "level", "light", "object"};
    return words[static_cast<std::size_t>(by)];
}

std::string_view word_of(Shown shown) {
    constexpr std::array<std::string_view, 3> words = {"full", "dimmed", "hidden"};
    return words[static_cast<std::size_t>(shown)];
}

double weight_of(const PixelTree& tree, const TreeRay<double>& ray) {
    const TreeRay<double>& bearer = ray.shadow ? tree.tree.rays[*ray.parent] : ray;
    return std::clamp(largest_component(bearer.weight), 0.0, 1.0);
}

Shown shown(const RayFilter& filter, const PixelTree& tree, const TreeRay<double>& ray) {
    Shown least = Shown::full;
    if (!filter.groups.empty()) {
        for_groups(ray, [&](const RayGroup& group) { least = std::max(least, filter.of(group)); });
    }
    if (filter.least_weight > 0 && weight_of(tree, ray) < filter.least_weight) {
        least = std::max(least, filter.lighter);
    }
    return least;
}

std::vector<CountedGroup> groups_of(const PixelTree& tree, const RayFilter& filter) {
    std::map<RayKind, std::size_t> kinds;
    std::map<int, std::size_t> levels;
    std::array<std::map<std::string, std::size_t, NaturalOrder>, 4> names;
    for (const TreeRay<double>& ray : tree.tree.rays) {
        // Rays of the tree that is compared with have their row, and are not counted.
        const std::size_t one = tree.is_own(ray.id) ? 1 : 0;
        kinds[ray.kind] += one;
        levels[ray.level] += one;
        if (ray.shadow) {
            names[static_cast<std::size_t>(By::light)][ray.shadow->light] += one;
        }
        if (const std::string object = met_by(ray); !object.empty()) {
            names[static_cast<std::size_t>(By::object)][object] += one;
        }
    }
    for (const auto& [level, count] : levels) {
        names[static_cast<std::size_t>(By::level)][std::to_string(level)] = count;
    }
    std::vector<CountedGroup> groups;
    for (const auto& [group, shown] : filter.groups) {
        if (group.by != By::kind) {
            names[static_cast<std::size_t>(group.by)].try_emplace(group.name, 0);
        } else if (const auto kind = ray_kind_from(group.name)) {
            kinds.try_emplace(*kind, 0);
        }
    }
    for (const auto& [kind, count] : kinds) {
        groups.push_back({group_of(kind), count});
    }
    for (const By by : {By::level, By::light, By::object}) {
        for (const auto& [name, count] : names[static_cast<std::size_t>(by)]) {
            groups.push_back({{by, name}, count});
        }
    }
    return groups;
}

std::string text_of(const RayFilter& filter) {
    std::string text;
    for (const Shown shown : {Shown::hidden, Shown::dimmed}) {
        std::string names;
        for (const auto& [group, how] : filter.groups) {
            if (how == shown) {
                names += (names.empty() ? "" : ", ") + plain(group);
            }
        }
        if (filter.least_weight > 0 && filter.lighter == shown) {
            names += (names.empty() ? "" : ", ") + std::string("less than ") +
                     number_text(filter.least_weight) + " of the pixel";
        }
        if (!names.empty()) {
            text += (text.empty() ? "" : "  ·  ") + std::string(word_of(shown)) + ": " + names;
        }
    }
    return text;
}

}  // namespace raytree::inspector
