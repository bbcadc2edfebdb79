// What a ray meets in a leaf: filtered in float, met in double. Part of kernels.inl.

/// Where the origin may be in the triangle of the points (x, y), an edge function counting as 0
/// where rounding may have made its sign. The points are those of a triangle of extent D, sheared
/// along a line: if the line passes through it they are at most 2 D, and with E the bound on a
/// coordinate's error an edge function's is under 10 E D + 3 E^2.
inline unsigned may_enclose_origin(const F8 (&x)[3], const F8 (&y)[3], const F8& extent, float e) {
    const F8 e0 = multiply_subtract(x[2], y[1], y[2] * x[1]);
    const F8 e1 = multiply_subtract(x[0], y[2], y[0] * x[2]);
    const F8 e2 = multiply_subtract(x[1], y[0], y[1] * x[0]);
    const F8 error = multiply_add(extent, F8::all(16 * e), F8::all(4 * e * e));
    return less_equal(max(max(e0, e1), e2), error) |
           less_equal(F8::all(0) - error, min(min(e0, e1), e2));
}

/// The triangles of a leaf that the ray may meet between its start and its limit: its line may pass
/// through them by Woop's test, and it may meet their planes there. A plane is met at t =
/// (n . a) / (n . d), with n the unit normal and a the way to a vertex. With u the roundoff and |a|
/// the sum of three sizes, n . a has an error under 8 u |a| and twice that of a, n . d one under
/// 16 u. What is edge-on within this error may be met anywhere, and so may a sliver, whose normal
/// is 0.
inline unsigned filter_triangles(const LeafFilter& filter, Ref leaf, const Traveller& ray) {
    constexpr float roundoff = 0x1p-24F;
    const std::size_t n = leaf.count();
    const auto row = [rows = filter.of_leaf(leaf), n](std::size_t k) {
        return F8::load(rows + k * n);
    };
    F8 x[3], y[3];
    F8 distance = F8::all(0), speed = F8::all(0), away = F8::all(0);
    for (std::size_t k = 0; k < 3; ++k) {
        F8 corner[3];
        for (std::size_t a = 0; a < 3; ++a) {
            corner[a] = row(3 * k + ray.axis[a]) - F8::all(ray.origin[a]);
        }
        x[k] = subtract_product(corner[0], F8::all(ray.shear_x), corner[2]);
        y[k] = subtract_product(corner[1], F8::all(ray.shear_y), corner[2]);
        for (std::size_t a = 0; k == 0 && a < 3; ++a) {
            const F8 normal = row(9 + ray.axis[a]);
            distance = multiply_add(normal, corner[a], distance);
            speed = multiply_add(normal, F8::all(ray.direction[a]), speed);
            away = away + abs(corner[a]);
        }
    }
    const F8 q = F8::all(16 * roundoff);
    const F8 error = multiply_add(away, F8::all(8 * roundoff), F8::all(2 * ray.origin_error));
    const F8 ahead = with_sign_of(speed, distance);
    const unsigned in_time =
        less_equal(F8::all(0) - error, ahead) &
        less_equal(ahead, multiply_add(F8::all(ray.limit), abs(speed) + q, error));
    return may_enclose_origin(x, y, row(12), ray.error) & (in_time | less_equal(abs(speed), q));
}

/// Whether the ray may pass spheres about `from`, seen from its origin, within their radii. The
/// distance of a centre has an error of some roundings of |c - o|, the bound taken is twice a
/// coordinate's.
inline unsigned pass_within(const F8 (&from)[3], const F8& radius, const Traveller& ray) {
    F8 along = F8::all(0);
    for (std::size_t k = 0; k < 3; ++k) {
        along = multiply_add(from[k], F8::all(ray.direction[k]), along);
    }
    F8 square = F8::all(0);
    for (std::size_t k = 0; k < 3; ++k) {
        const F8 across = subtract_product(from[k], along, F8::all(ray.direction[k]));
        square = multiply_add(across, across, square);
    }
    const F8 reach = multiply_add(radius, F8::all(1 + 0x1p-20F), F8::all(3 * ray.error));
    return less_equal(square, reach * reach) & less_equal(F8::all(0) - reach, along) &
           less_equal(along - reach, F8::all(ray.limit));
}

/// The spheres of a leaf whose centre the ray may pass within a radius.
inline unsigned filter_spheres(const LeafFilter& filter, Ref leaf, const Traveller& ray) {
    const std::size_t n = leaf.count();
    const float* const rows = filter.of_leaf(leaf);
    F8 from[3];
    for (std::size_t k = 0; k < 3; ++k) {
        from[k] = F8::load(rows + ray.axis[k] * n) - F8::all(ray.origin[k]);
    }
    return pass_within(from, F8::load(rows + 3 * n), ray);
}

/// The cones of a leaf which the ray may pass within the sphere around them, and its line within
/// the larger radius of their axis. With w = d x a the lines' distance is |(b - o) . w| / |w|, its
/// numerator's error some roundings of |b - o|.
inline unsigned filter_cones(const LeafFilter& filter, Ref leaf, const Traveller& ray) {
    const std::size_t n = leaf.count();
    const float* const rows = filter.of_leaf(leaf);
    const F8 half = F8::load(rows + 7 * n) * F8::all(0.5F);
    F8 from[3], axis[3], middle[3];
    for (std::size_t k = 0; k < 3; ++k) {
        from[k] = F8::load(rows + ray.axis[k] * n) - F8::all(ray.origin[k]);
        axis[k] = F8::load(rows + (3 + ray.axis[k]) * n);
        middle[k] = multiply_add(axis[k], half, from[k]);
    }
    const unsigned near = pass_within(middle, F8::load(rows + 8 * n), ray);
    if (near == 0) {
        return 0;
    }
    F8 distance = F8::all(0), square = F8::all(0);
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        const F8 across = multiply_subtract(F8::all(ray.direction[i]), axis[j],
                                            F8::all(ray.direction[j]) * axis[i]);
        distance = multiply_add(from[k], across, distance);
        square = multiply_add(across, across, square);
    }
    const F8 radius = F8::load(rows + 6 * n) * F8::all(1 + 0x1p-20F);
    return near & less_equal(abs(distance),
                             multiply_add(radius, square_root(square), F8::all(4 * ray.error)));
}

/// Which shapes of a leaf are to be met in double, a bit for each.
inline unsigned filter_leaf(const LeafFilter& filter, Ref leaf, const Traveller& ray) {
    const unsigned all = (2U << (leaf.count() - 1)) - 1;
    switch (leaf.kind()) {
        case LeafFilter::triangle:
            return filter_triangles(filter, leaf, ray) & all;
        case LeafFilter::sphere:
            return filter_spheres(filter, leaf, ray) & all;
        case LeafFilter::cone:
            return filter_cones(filter, leaf, ray) & all;
        default:
            return all;
    }
}

/// The triangle at a lane of a leaf, met in double, as `intersect` does it. Flattened, so that its
/// fused multiply-adds are instructions where there are such.
[[gnu::flatten]] inline Roots<double> meet_triangle(const Searched& searched, Ref leaf,
                                                    std::size_t lane, const Traveller& ray,
                                                    Start start) {
    if (start == Start::on_this_shape) {
        return {};
    }
    const LeafFilter::Exact numbers(searched.filter, leaf, lane);
    const Ray<double>& line = ray.query->ray;
    const RayFrame<double>& frame = ray.frame;
    const double ox = component(line.origin, ray.axis[0]);
    const double oy = component(line.origin, ray.axis[1]);
    const double oz = component(line.origin, ray.axis[2]);
    std::array<double, 3> px, py, z;
    for (std::size_t k = 0; k < 3; ++k) {
        z[k] = numbers[3 * k + ray.axis[2]] - oz;
        px[k] = (numbers[3 * k + ray.axis[0]] - ox) - frame.shear_x * z[k];
        py[k] = (numbers[3 * k + ray.axis[1]] - oy) - frame.shear_y * z[k];
    }
    if (!encloses_origin(px, py)) {
        return {};
    }
    const auto passage =
        Passage<double>::between(min_of(z[0], min_of(z[1], z[2])), max_of(z[0], max_of(z[1], z[2])),
                                 component(line.direction, ray.axis[2]));
    return intersect_inside(searched.filter.triangle_of(leaf, lane), line, passage, start);
}

[[gnu::flatten]] inline Roots<double> meet_sphere(const Searched& searched, Ref leaf,
                                                  std::size_t lane, const Traveller& ray,
                                                  Start start) {
    return intersect(searched.filter.sphere_of(leaf, lane), ray.query->ray, start);
}

[[gnu::flatten]] inline Roots<double> meet_cone(const Searched& searched, Ref leaf,
                                                std::size_t lane, const Traveller& ray,
                                                Start start) {
    return intersect(searched.filter.cone_of(leaf, lane), ray.query->ray, start);
}

/// A shape that has no copy.
[[gnu::flatten]] inline Roots<double> meet_other(const ShapeSet<double>& shapes, PrimitiveId id,
                                                 const Query<double>& query) {
    return shapes.intersect(id, query.ray, query.leaving);
}

inline PrimitiveId name_of(const Searched& searched, Ref leaf, std::size_t lane) {
    return leaf.kind() == LeafFilter::other ? searched.bvh.items()[leaf.first() + lane]
                                            : searched.filter.name_of(leaf, lane);
}

/// The shape at a lane of a leaf, met in double.
inline Roots<double> meet(const Searched& searched, Ref leaf, std::size_t lane,
                          const Traveller& ray) {
    const auto id = [&] { return name_of(searched, leaf, lane); };
    const PrimitiveId leaving = ray.query->leaving;
    const Start start = leaving == no_primitive ? Start::anywhere : start_on(id(), leaving);
    switch (leaf.kind()) {
        case LeafFilter::triangle:
            return meet_triangle(searched, leaf, lane, ray, start);
        case LeafFilter::sphere:
            return meet_sphere(searched, leaf, lane, ray, start);
        case LeafFilter::cone:
            return meet_cone(searched, leaf, lane, ray, start);
        default:
            return meet_other(*searched.shapes, id(), *ray.query);
    }
}

/// Meets the shape at a lane of a leaf; true where nothing more is to be looked for.
template <bool any_will_do>
inline bool meet_lane(const Searched& searched, Ref leaf, std::size_t lane, Traveller& ray) {
    const Query<double>& query = *ray.query;
    const Roots<double> roots = meet(searched, leaf, lane, ray);
    for (std::size_t k = 0; k < static_cast<std::size_t>(roots.count); ++k) {
        if (!query.interval.contains(roots.t[k]) || roots.t[k] > ray.best.t) {
            continue;
        }
        const Hit<double> hit{roots.t[k], name_of(searched, leaf, lane)};
        if (hit < ray.best) {
            ray.best = hit;
            if constexpr (any_will_do) {
                return true;
            }
            ray.end = hit.t;
            if (ray.ready_for_boxes) {
                ray.limit = ray.box.upper(hit.t);
            }
        }
    }
    return false;
}

/// Meets shapes of a leaf, a bit for each; true where nothing more is to be looked for.
template <bool any_will_do>
inline bool meet_lanes(const Searched& searched, Ref leaf, unsigned lanes, Traveller& ray) {
    for (; lanes != 0; lanes &= lanes - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
        if (meet_lane<any_will_do>(searched, leaf, lane, ray)) {
            return true;
        }
    }
    return false;
}

/// Meets the shapes of a leaf; true where nothing more is to be looked for.
template <bool any_will_do>
inline bool meet_leaf(const Searched& searched, Ref leaf, Traveller& ray) {
    return meet_lanes<any_will_do>(searched, leaf, filter_leaf(searched.filter, leaf, ray), ray);
}
