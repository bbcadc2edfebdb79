#include "accel/lecture_hierarchy.h"

namespace raytree {
namespace {

LectureHierarchy hierarchy_over(LectureKind kind, const ShapeSet<double>& shapes) {
    std::vector<Box> boxes(shapes.size());
    for (std::size_t k = 0; k < boxes.size(); ++k) {
        boxes[k] = shapes.bounds(static_cast<PrimitiveId>(k));
    }
    return {kind, boxes};
}

/// Tests the shapes of opened leaves and passes hits on.
template <class Found, class Tell> struct Asking {
    const ShapeSet<double>& shapes;
    const Ray<double>& ray;
    PrimitiveId leaving;
    Interval<double> interval;
    LectureCount& count;
    Found found;  ///< gets a hit, returns the new end of the interval or a negative number to stop
    Tell tell;    ///< gets what is tested

    void volume(std::uint32_t node, const VolumePassage& passage, bool open) {
        ++count.volumes;
        tell.volume(node, passage, open);
    }
    double items(std::uint32_t node, std::span<const PrimitiveId> items, double end) {
        for (const PrimitiveId id : items) {
            ++count.shapes;
            const Roots<double> roots = shapes.intersect(id, ray, leaving);
            for (int k = 0; k < roots.count; ++k) {
                const double t = roots.t[static_cast<std::size_t>(k)];
                if (t >= interval.from && t <= end && t < interval.to) {
                    end = found(Hit<double>{t, id});
                    if (end < 0) {
                        return -1;
                    }
                }
            }
        }
        tell.items(node, items);
        return end;
    }
};

struct Silent {
    void volume(std::uint32_t, const VolumePassage&, bool) {}
    void items(std::uint32_t, std::span<const PrimitiveId>) {}
};

template <class Found, class Tell> void ask(const LectureHierarchy& hierarchy,
                                            const ShapeSet<double>& shapes, const Ray<double>& ray,
                                            PrimitiveId leaving, Interval<double> interval,
                                            LectureCount& count, Found found, Tell tell) {
    Asking<Found, Tell> asking{shapes, ray, leaving, interval, count, found, tell};
    hierarchy.traverse(ray.origin, ray.direction, interval.to, asking);
}

/// Keeps the first hit in the order of the model.
struct Nearest {
    std::optional<Hit<double>>& best;
    double operator()(const Hit<double>& hit) const {
        if (!best || hit < *best) {
            best = hit;
        }
        return best->t;
    }
};

/// Writes the steps down.
struct StepWriter {
    std::vector<LectureIntersector::Step>& steps;
    const std::optional<Hit<double>>& best;

    void volume(std::uint32_t node, const VolumePassage& passage, bool open) {
        steps.push_back({node, passage, open, {}, best});
    }
    void items(std::uint32_t node, std::span<const PrimitiveId> items) {
        // The leaf was told of when it was tested as a volume; it is opened now.
        steps.push_back({node, {}, true, {items.begin(), items.end()}, best});
    }
};

}  // namespace

LectureIntersector::LectureIntersector(LectureKind kind, const ShapeSet<double>& shapes)
    : shapes_(shapes), hierarchy_(hierarchy_over(kind, shapes)) {}

std::optional<Hit<double>> LectureIntersector::closest(const Ray<double>& ray, PrimitiveId leaving,
                                                       Interval<double> interval,
                                                       LectureCount& count) const {
    std::optional<Hit<double>> best;
    ask(hierarchy_, shapes_, ray, leaving, interval, count, Nearest{best}, Silent{});
    return best;
}

bool LectureIntersector::any(const Ray<double>& ray, PrimitiveId leaving, Interval<double> interval,
                             LectureCount& count) const {
    bool met = false;
    const auto stop = [&met](const Hit<double>&) {
        met = true;
        return -1.0;
    };
    ask(hierarchy_, shapes_, ray, leaving, interval, count, stop, Silent{});
    return met;
}

std::vector<Hit<double>> LectureIntersector::all(const Ray<double>& ray, PrimitiveId leaving,
                                                 Interval<double> interval,
                                                 LectureCount& count) const {
    std::vector<Hit<double>> hits;
    const auto collect = [&](const Hit<double>& hit) {
        hits.push_back(hit);
        return interval.to;
    };
    ask(hierarchy_, shapes_, ray, leaving, interval, count, collect, Silent{});
    std::sort(hits.begin(), hits.end());
    // An octree's cells may share a shape.
    const auto same = [](const Hit<double>& a, const Hit<double>& b) {
        return a.t == b.t && a.primitive == b.primitive;
    };
    const auto rest = std::ranges::unique(hits, same);
    hits.erase(rest.begin(), rest.end());
    return hits;
}

std::vector<LectureIntersector::Step> LectureIntersector::replay(const Ray<double>& ray,
                                                                 PrimitiveId leaving,
                                                                 Interval<double> interval) const {
    std::vector<Step> steps;
    std::optional<Hit<double>> best;
    LectureCount count;
    ask(hierarchy_, shapes_, ray, leaving, interval, count, Nearest{best}, StepWriter{steps, best});
    return steps;
}

}  // namespace raytree
