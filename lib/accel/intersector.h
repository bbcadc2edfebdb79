#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "accel/wide_bvh.h"
#include "geometry/shape_set.h"

namespace raytree {

/// Where a ray meets a shape.
template <class T> struct Hit {
    T t{};
    PrimitiveId primitive = no_primitive;

    /// The order in which hits are met: by t, of equal t the first shape in the scene.
    friend bool operator<(const Hit& a, const Hit& b) {
        return a.t < b.t || (a.t == b.t && a.primitive < b.primitive);
    }
};

/// Counts how often a ray was tested against a shape; `NoTestCount` compiles to nothing.
struct TestCount {
    std::size_t tests = 0;
    void add() { ++tests; }
};
struct NoTestCount {
    void add() {}
};

/// The part of a ray in which hits are looked for: `from <= t < to`, and t > 0 in any case.
template <class T> struct Interval {
    T from = 0;
    T to = Real<T>::infinity;
};

/// A ray with what else is asked of it, for answers to many at a time.
template <class T> struct Query {
    Ray<T> ray;
    PrimitiveId leaving = no_primitive;
    Interval<T> interval;
};

/// What is known of rays that are handed over together. It decides how they are followed and
/// never what they meet.
enum class Together {
    any_order,  ///< nothing
    coherent,   ///< sixteen in a row start near each other and go much the same way
};

/// Answers what a ray meets among all shapes of a scene. The answers depend on the shapes alone,
/// not on the hierarchy that spares testing them.
template <class T> class Intersector {
  public:
    explicit Intersector(const Scene& scene);

    const ShapeSet<T>& shapes() const { return shapes_; }
    const WideBvh& hierarchy() const { return bvh_; }

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
    /// Calls `found(hit)` for the hits of the shapes whose boxes the ray meets; it returns the new
    /// upper end of the interval, or a negative number to stop.
    template <class Count, class Found> void visit_hits(const Ray<T>& ray, PrimitiveId leaving,
                                                        Interval<T> interval, Count& count,
                                                        Found&& found) const;

    ShapeSet<T> shapes_;
    WideBvh bvh_;
};

template <class T> Intersector<T>::Intersector(const Scene& scene) : shapes_(scene) {
    std::vector<Box> boxes(shapes_.size());
    for (std::size_t k = 0; k < boxes.size(); ++k) {
        boxes[k] = shapes_.bounds(static_cast<PrimitiveId>(k));
    }
    bvh_ = WideBvh(boxes);
}

template <class T> template <class Count, class Found>
void Intersector<T>::visit_hits(const Ray<T>& ray, PrimitiveId leaving, Interval<T> interval,
                                Count& count, Found&& found) const {
    const auto box_ray =
        bvh_.prepare(vector_cast<double>(ray.origin), vector_cast<double>(ray.direction));
    T end = interval.to;
    bvh_.traverse(box_ray, static_cast<double>(end),
                  [&](std::span<const std::uint32_t> items, double) -> double {
                      for (const PrimitiveId id : items) {
                          count.add();
                          const Roots<T> roots = shapes_.intersect(id, ray, leaving);
                          for (int k = 0; k < roots.count; ++k) {
                              const T t = roots.t[static_cast<std::size_t>(k)];
                              if (t >= interval.from && t <= end && t < interval.to) {
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
    visit_hits(ray, leaving, interval, count, [&](const Hit<T>& hit) {
        if (!best || hit < *best) {
            best = hit;
        }
        return best->t;
    });
    return best;
}

template <class T> template <class Count>
bool Intersector<T>::any(const Ray<T>& ray, PrimitiveId leaving, Interval<T> interval,
                         Count& count) const {
    bool met = false;
    visit_hits(ray, leaving, interval, count, [&](const Hit<T>&) {
        met = true;
        return T(-1);
    });
    return met;
}

template <class T> void Intersector<T>::closest(std::span<const Query<T>> queries,
                                                std::span<Hit<T>> hits, Together) const {
    NoTestCount count;
    for (std::size_t k = 0; k < queries.size(); ++k) {
        const Query<T>& query = queries[k];
        hits[k] = closest(query.ray, query.leaving, query.interval, count).value_or(Hit<T>{});
    }
}

template <class T> void Intersector<T>::any(std::span<const Query<T>> queries,
                                            std::span<std::uint8_t> met, Together) const {
    NoTestCount count;
    for (std::size_t k = 0; k < queries.size(); ++k) {
        const Query<T>& query = queries[k];
        met[k] = any(query.ray, query.leaving, query.interval, count) ? 1 : 0;
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
