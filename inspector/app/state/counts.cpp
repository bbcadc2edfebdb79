#include "state/counts.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace raytree::inspector {
namespace {

using Statistics = TreeStatistics;

std::array<Statistics::Kind, 4> kinds_of(const RayTree<double>& tree) {
    const TreeCounts& n = tree.counts;
    const double hits = std::exp2(tree.settings.max_depth) - 1;
    const double branches = (hits - 1) / 2;
    return {{{RayKind::primary, n.primary, 1},
             {RayKind::reflected, n.reflected, branches},
             {RayKind::refracted, n.refracted, branches},
             {RayKind::shadow, n.shadow, static_cast<double>(n.lights) * hits}}};
}

using OwnRays = std::span<const TreeRay<double>>;

std::vector<Statistics::NotSent> not_sent_of(OwnRays rays) {
    std::vector<Statistics::NotSent> rows;
    for (const ReasonText& text : reason_texts()) {
        rows.push_back({text.reason, 0});
    }
    for (const TreeRay<double>& ray : rays) {
        for (const Skipped& skipped : ray.skipped) {
            ++rows[static_cast<std::size_t>(skipped.reason)].count;
        }
    }
    std::erase_if(rows, [](const Statistics::NotSent& row) { return row.count == 0; });
    std::ranges::stable_sort(rows, std::ranges::greater{}, &Statistics::NotSent::count);
    return rows;
}

Statistics::Lost lost_to(OwnRays rays, Reason limit) {
    Statistics::Lost lost{0, Rgb<double>(0)};
    for (const TreeRay<double>& ray : rays) {
        for (const Skipped& skipped : ray.skipped) {
            if (skipped.reason == limit && ray.hit) {
                const Rgb<double>& k =
                    skipped.kind == RayKind::reflected ? ray.hit->kr : ray.hit->kt;
                ++lost.branches;
                lost.weight = *lost.weight + ray.attenuation * (k * ray.weight);
            }
        }
    }
    return lost;
}

}  // namespace

TreeStatistics statistics_of(const Document& document, const PixelTree& shown) {
    const RayTree<double>& tree = shown.tree;
    const OwnRays rays(tree.rays.data(), shown.own());
    TreeStatistics all;
    all.kinds = kinds_of(tree);
    all.not_sent = not_sent_of(rays);
    all.to_depth = lost_to(rays, Reason::max_depth);
    all.to_weight = lost_to(rays, Reason::low_intensity);
    all.tests = tree.counts.intersection_tests;
    all.shapes = document.world().shapes.shapes().size();
    all.all_tests = static_cast<double>(tree.counts.all()) * static_cast<double>(all.shapes);
    if (shown.recorded) {
        all.to_depth.weight = all.to_weight.weight = std::nullopt;
        all.tells_skipped = !all.not_sent.empty();
        if (all.tests == 0) {
            all.tests.reset();
        }
    }
    return all;
}

}  // namespace raytree::inspector
