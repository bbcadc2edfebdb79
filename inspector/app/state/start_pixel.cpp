#include "state/start_pixel.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "trace/counting.h"
#include "trace/tracer.h"

namespace raytree::inspector {
namespace {

constexpr int columns = 23;  // odd: the centre is one of them
constexpr int rows = 17;
constexpr auto longest_search = std::chrono::milliseconds(100);

struct Candidate {
    Pixel pixel;
    double off_centre = 0;  ///< 0 at the centre, 1 in the middle of an edge
};

std::vector<Candidate> candidates(const Camera& camera) {
    std::vector<Candidate> all;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const double x = (column + 0.5) / columns, y = (row + 0.5) / rows;
            all.push_back(
                {{static_cast<int>(x * camera.width), static_cast<int>(y * camera.height)},
                 std::hypot(2 * x - 1, 2 * y - 1)});
        }
    }
    std::ranges::stable_sort(all, {}, &Candidate::off_centre);
    return all;
}

/// How much there is to see in a tree. Beyond about forty rays a tree does not get clearer.
double worth(const CountingRecorder<double>& recorder, double off_centre) {
    const RayCounts& counts = recorder.counts;
    const auto& shadow = counts[RayKind::shadow];
    double kinds = 0;
    kinds += counts[RayKind::reflected].rays > 0;
    kinds += 1.5 * (counts[RayKind::refracted].rays > 0);
    kinds += shadow.rays > shadow.hits;
    kinds += 0.5 * (shadow.hits > 0);
    const auto reasons = std::ranges::count_if(counts.skipped, [](auto n) { return n > 0; });
    const double rays = static_cast<double>(std::min<std::size_t>(counts.rays(), 40));
    const double thicket = std::max(0.0, std::log2(static_cast<double>(counts.rays()) / 60.0));
    return 8 * kinds + static_cast<double>(reasons) + 0.8 * rays - 6 * thicket - 8 * off_centre;
}

}  // namespace

Pixel start_pixel(const Document& document) {
    const auto begin = std::chrono::steady_clock::now();
    Pixel best{document.scene().camera.width / 2, document.scene().camera.height / 2};
    double most = -1e9;
    for (const Candidate& candidate : candidates(document.scene().camera)) {
        if (std::chrono::steady_clock::now() - begin > longest_search) {
            break;
        }
        CountingRecorder<double> recorder;
        try {
            Tracer<double, CountingRecorder<double>>(document.world(), recorder)
                .trace_pixel(candidate.pixel.i, candidate.pixel.j);
        } catch (const InputError&) {
            continue;  // its intensity is not finite
        }
        const double value = worth(recorder, candidate.off_centre);
        if (value > most) {
            most = value;
            best = candidate.pixel;
        }
    }
    return best;
}

}  // namespace raytree::inspector
