#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <optional>
#include <vector>

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

/// Answers what a ray meets among all shapes of a scene. The answers depend on the shapes alone,
/// not on the hierarchy that spares testing them, nor on how many rays are asked about at a time.
template <class T> class Intersector {
  public:
    /// The scene must outlive the intersector.
    explicit Intersector(const Scene& scene);

    const ShapeSet<T>& shapes() const { return searched_.shapes; }
    const WideBvh& hierarchy() const { return searched_.bvh; }
    /// What shapes and hierarchy take, the scene's own vertices left out.
    std::size_t bytes() const;

    /// The first hit. `leaving` is the shape that the ray starts on, no_primitive where on none.
    template <class Count> std::optional<Hit<T>> closest(const Ray<T>& ray, PrimitiveId leaving,
                                                         Interval<T> interval, Count& count) const;

    /// Whether there is a hit at all.
    template <class Count>
    bool any(const Ray<T>& ray, PrimitiveId leaving, Interval<T> interval, Count& count) const;

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
    /// Double has kernels of its own; the other arithmetics meet the shapes one by one.
    static constexpr bool in_double = std::same_as<T, double>;
    struct Plainly {
        ShapeSet<T> shapes;
        WideBvh bvh{};
    };

    /// Calls `found(hit)` for the hits of the shapes whose boxes the ray meets; it returns the new
    /// upper end of the interval, or a negative number to stop.
    template <class Count, class Found> void visit_hits(const Ray<T>& ray, PrimitiveId leaving,
                                                        Interval<T> interval, Count& count,
                                                        Found&& found) const;

    std::conditional_t<in_double, Searched, Plainly> searched_;
};

/// The hierarchy over all shapes.
template <class T> WideBvh hierarchy_of(const ShapeSet<T>& shapes);

template <class T> Intersector<T>::Intersector(const Scene& scene) : searched_{ShapeSet<T>(scene)} {
    searched_.bvh = hierarchy_of(searched_.shapes);
    if constexpr (in_double) {
        searched_.filter = LeafFilter(searched_.shapes, searched_.bvh);
    }
}

template <class T> std::size_t Intersector<T>::bytes() const {
    std::size_t bytes = shapes().bytes() + hierarchy().bytes();
    if constexpr (in_double) {
        bytes += searched_.filter.bytes();
    }
    return bytes;
}

template <class T> template <class Count, class Found>
void Intersector<T>::visit_hits(const Ray<T>& ray, PrimitiveId leaving, Interval<T> interval,
                                Count& count, Found&& found) const {
    const auto box_ray =
        hierarchy().prepare(vector_cast<double>(ray.origin), vector_cast<double>(ray.direction));
    T end = interval.to;
    hierarchy().traverse(box_ray, static_cast<double>(end),
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
    std::optional<Hit<T>> best;
    if constexpr (in_double) {
        const Hit<T> hit = kernels().closest(searched_, {ray, leaving, interval}, count.total());
        if (hit.primitive != no_primitive) {
            best = hit;
        }
    } else {
        visit_hits(ray, leaving, interval, count, [&](const Hit<T>& hit) {
            if (!best || hit < *best) {
                best = hit;
            }
            return best->t;
        });
    }
    return best;
}

template <class T> template <class Count>
bool Intersector<T>::any(const Ray<T>& ray, PrimitiveId leaving, Interval<T> interval,
                         Count& count) const {
    if constexpr (in_double) {
        return kernels().any(searched_, {ray, leaving, interval}, count.total());
    } else {
        bool met = false;
        visit_hits(ray, leaving, interval, count, [&](const Hit<T>&) {
            met = true;
            return T(-1);
        });
        return met;
    }
}

template <class T> void Intersector<T>::closest(std::span<const Query<T>> queries,
                                                std::span<Hit<T>> hits, Together together) const {
    if constexpr (in_double) {
        (together == Together::coherent ? kernels().closest_in_packets : kernels().closest_of_each)(
            searched_, queries, hits);
    } else {
        NoTestCount count;
        for (std::size_t k = 0; k < queries.size(); ++k) {
            const Query<T>& query = queries[k];
            hits[k] = closest(query.ray, query.leaving, query.interval, count).value_or(Hit<T>{});
        }
    }
}

template <class T> void Intersector<T>::any(std::span<const Query<T>> queries,
                                            std::span<std::uint8_t> met, Together together) const {
    if constexpr (in_double) {
        (together == Together::coherent ? kernels().any_in_packets : kernels().any_of_each)(
            searched_, queries, met);
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
