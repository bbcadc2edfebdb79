#pragma once

#include <algorithm>
#include <atomic>
#include <concepts>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "accel/growing_hierarchy.h"
#include "accel/kernels.h"

namespace raytree {

/// Counts how often a ray was tested against a shape; `NoTestCount` compiles to nothing.
struct TestCount {
    std::size_t tests = 0;
    void add(std::size_t more = 1) { tests += more; }
    std::size_t* total() { return &tests; }
};
struct NoTestCount {
    void add(std::size_t = 1) {}
    std::size_t* total() { return nullptr; }
};

/// What is built before a ray is sent.
enum class Build {
    whole,          ///< the hierarchy over all shapes
    where_rays_go,  ///< what a pixel's rays need; the whole when many rays come at once
};

/// The hierarchy over all shapes of a set.
template <class T> WideBvh hierarchy_of(const ShapeSet<T>& shapes);

/// All shapes, or some of them, for the kernels. The shapes must outlive it.
Searched searched_of(const ShapeSet<double>& shapes);
Searched searched_among(const ShapeSet<double>& shapes, std::span<const PrimitiveId> some);

/// What shapes in double are searched with: all that there is once it is whole, and until then a
/// hierarchy that grows with its rays.
class DoubleSearch {
  public:
    DoubleSearch(const ShapeSet<double>& shapes, Build build);

    /// Built now where it is not yet. May be called by several threads at a time.
    const Searched& whole() const {
        if (!is_whole()) {
            build_whole();
        }
        return whole_;
    }
    bool is_whole() const { return is_whole_.load(std::memory_order_acquire); }

    Hit<double> closest(const Query<double>& query, std::size_t* tests) const {
        return is_whole() ? kernels().closest(whole_, query, tests)
                          : growing_->closest(query, tests);
    }
    PrimitiveId any(const Query<double>& query, std::size_t* tests) const {
        return is_whole() ? kernels().any(whole_, query, tests) : growing_->any(query, tests);
    }
    template <class Visit>
    void traverse(const Ray<double>& ray, double t_max, Visit&& visit) const {
        if (is_whole()) {
            const WideBvh& bvh = whole_.bvh;
            bvh.traverse(bvh.prepare(ray.origin, ray.direction), t_max, visit);
        } else {
            growing_->traverse(ray.origin, ray.direction, t_max, visit);
        }
    }

  private:
    /// Fewer are soon built upon.
    static constexpr std::size_t fewest_to_grow = 10'000;

    void build_whole() const;

    const ShapeSet<double>& shapes_;
    std::unique_ptr<GrowingHierarchy> growing_;  ///< null where all was built at once
    mutable Searched whole_{};
    mutable std::once_flag once_;
    mutable std::atomic<bool> is_whole_{false};
};

/// The other arithmetics meet the shapes one by one.
template <class T> class PlainSearch {
  public:
    PlainSearch(const ShapeSet<T>& shapes, Build) : bvh_(hierarchy_of(shapes)) {}

    const WideBvh& bvh() const { return bvh_; }
    template <class Visit> void traverse(const Ray<T>& ray, double t_max, Visit&& visit) const {
        bvh_.traverse(
            bvh_.prepare(vector_cast<double>(ray.origin), vector_cast<double>(ray.direction)),
            t_max, visit);
    }

  private:
    WideBvh bvh_;
};

/// Answers what a ray meets among all shapes of a scene. The answers depend on the shapes alone,
/// not on the hierarchy that spares testing them, nor on how many rays are asked about at a time.
template <class T> class Intersector {
  public:
    /// The scene must outlive the intersector.
    explicit Intersector(const Scene& scene, Build build = Build::whole)
        : shapes_(scene), search_(shapes_, build) {}

    const ShapeSet<T>& shapes() const { return shapes_; }
    /// Builds now what has not been built yet: before many rays that come one by one.
    void complete() const { hierarchy(); }
    const WideBvh& hierarchy() const {
        if constexpr (in_double) {
            return search_.whole().bvh;
        } else {
            return search_.bvh();
        }
    }
    /// What shapes and hierarchy take, the scene's own vertices left out.
    std::size_t bytes() const;

    /// The first hit. `leaving` is the shape that the ray starts on, no_primitive where on none.
    template <class Count> std::optional<Hit<T>> closest(const Ray<T>& ray, PrimitiveId leaving,
                                                         Interval<T> interval, Count& count) const;

    template <class Count> std::optional<Hit<T>> closest(const Query<T>& query, Count& count) const;

    /// Whether there is a hit at all.
    template <class Count>
    bool any(const Ray<T>& ray, PrimitiveId leaving, Interval<T> interval, Count& count) const {
        return occluder({ray, leaving, interval}, count) != no_primitive;
    }

    /// Some shape that is hit, not always the first; no_primitive where there is none.
    template <class Count> PrimitiveId occluder(const Query<T>& query, Count& count) const;

    /// Whether this very shape is hit.
    bool meets(PrimitiveId shape, const Query<T>& query) const;

    /// The first hit of each query; its primitive is no_primitive where there is none.
    /// `hits` is as long as `queries`.
    void closest(std::span<const Query<T>> queries, std::span<Hit<T>> hits,
                 Together together) const;

    /// Whether each query has a hit at all: 1 or 0. `met` is as long as `queries`.
    void any(std::span<const Query<T>> queries, std::span<std::uint8_t> met,
             Together together) const;

    /// Every hit, in the order in which they are met.
    template <class Count> std::vector<Hit<T>> all(const Ray<T>& ray, PrimitiveId leaving,
                                                   Interval<T> interval, Count& count) const;

  private:
    static constexpr bool in_double = std::same_as<T, double>;

    /// Calls `found(hit)` for the hits of the shapes whose boxes the ray meets; it returns the new
    /// upper end of the interval, or a negative number to stop.
    template <class Count, class Found> void visit_hits(const Ray<T>& ray, PrimitiveId leaving,
                                                        Interval<T> interval, Count& count,
                                                        Found&& found) const;

    ShapeSet<T> shapes_;
    std::conditional_t<in_double, DoubleSearch, PlainSearch<T>> search_;
};

template <class T> std::size_t Intersector<T>::bytes() const {
    std::size_t bytes = shapes().bytes() + hierarchy().bytes();
    if constexpr (in_double) {
        bytes += search_.whole().filter.bytes();
    }
    return bytes;
}

template <class T> template <class Count, class Found>
void Intersector<T>::visit_hits(const Ray<T>& ray, PrimitiveId leaving, Interval<T> interval,
                                Count& count, Found&& found) const {
    T end = interval.to;
    search_.traverse(ray, static_cast<double>(end),
                     [&](std::span<const std::uint32_t> items, double) -> double {
                         for (const PrimitiveId id : items) {
                             count.add();
                             const Roots<T> roots = shapes().intersect(id, ray, leaving);
                             for (int k = 0; k < roots.count; ++k) {
                                 const T t = roots.t[static_cast<std::size_t>(k)];
                                 if (t <= end && interval.contains(t)) {
                                     end = found(Hit<T>{t, id});
                                     if (end < 0) {
                                         return -1;
                                     }
                                 }
                             }
                         }
                         return static_cast<double>(end);
                     });
}

template <class T> template <class Count>
std::optional<Hit<T>> Intersector<T>::closest(const Ray<T>& ray, PrimitiveId leaving,
                                              Interval<T> interval, Count& count) const {
    return closest({ray, leaving, interval}, count);
}

template <class T> template <class Count>
std::optional<Hit<T>> Intersector<T>::closest(const Query<T>& query, Count& count) const {
    std::optional<Hit<T>> best;
    if constexpr (in_double) {
        const Hit<T> hit = search_.closest(query, count.total());
        if (hit.primitive != no_primitive) {
            best = hit;
        }
    } else {
        visit_hits(query.ray, query.leaving, query.interval, count, [&](const Hit<T>& hit) {
            if (!best || hit < *best) {
                best = hit;
            }
            return best->t;
        });
    }
    return best;
}

template <class T> template <class Count>
PrimitiveId Intersector<T>::occluder(const Query<T>& query, Count& count) const {
    if constexpr (in_double) {
        return search_.any(query, count.total());
    } else {
        PrimitiveId met = no_primitive;
        visit_hits(query.ray, query.leaving, query.interval, count, [&](const Hit<T>& hit) {
            met = hit.primitive;
            return T(-1);
        });
        return met;
    }
}

template <class T> bool Intersector<T>::meets(PrimitiveId shape, const Query<T>& query) const {
    const Roots<T> roots = shapes().intersect(shape, query.ray, query.leaving);
    for (int k = 0; k < roots.count; ++k) {
        if (query.interval.contains(roots.t[static_cast<std::size_t>(k)])) {
            return true;
        }
    }
    return false;
}

template <class T> void Intersector<T>::closest(std::span<const Query<T>> queries,
                                                std::span<Hit<T>> hits, Together together) const {
    if constexpr (in_double) {
        (together == Together::coherent ? kernels().closest_in_packets : kernels().closest_of_each)(
            search_.whole(), queries, hits);
    } else {
        NoTestCount count;
        for (std::size_t k = 0; k < queries.size(); ++k) {
            const Query<T>& query = queries[k];
            hits[k] = closest(query, count).value_or(Hit<T>{});
        }
    }
}

template <class T> void Intersector<T>::any(std::span<const Query<T>> queries,
                                            std::span<std::uint8_t> met, Together together) const {
    if constexpr (in_double) {
        (together == Together::coherent ? kernels().any_in_packets : kernels().any_of_each)(
            search_.whole(), queries, met);
    } else {
        NoTestCount count;
        for (std::size_t k = 0; k < queries.size(); ++k) {
            const Query<T>& query = queries[k];
            met[k] = any(query.ray, query.leaving, query.interval, count) ? 1 : 0;
        }
    }
}

template <class T> template <class Count>
std::vector<Hit<T>> Intersector<T>::all(const Ray<T>& ray, PrimitiveId leaving,
                                        Interval<T> interval, Count& count) const {
    std::vector<Hit<T>> hits;
    visit_hits(ray, leaving, interval, count, [&](const Hit<T>& hit) {
        hits.push_back(hit);
        return interval.to;
    });
    std::sort(hits.begin(), hits.end());
    return hits;
}

}  // namespace raytree
