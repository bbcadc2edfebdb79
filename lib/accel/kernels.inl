// The kernels, written over eight floats side by side (F8). Included by one file for each
// instruction set, inside a namespace of its own.

namespace {

using Ref = WideBvh::Ref;

/// A ray on its way: what the boxes and the leaves are tested with, and what it has met.
struct Traveller {
    WideBvh::BoxRay box;
    std::array<std::uint32_t, 3> near_row, far_row;  ///< where a node has the planes, in floats
    unsigned order_shift = 0;                        ///< where its octant's order of children is
    float limit = 0;                                 ///< boxes beyond are of no use

    RayFrame<double> frame;  ///< for the triangles

    // For the filter, on the axes of the frame: the last is the direction's largest.
    std::array<std::size_t, 3> axis;
    std::array<float, 3> origin;
    std::array<float, 3> direction;
    float shear_x = 0, shear_y = 0;
    float error = 0;         ///< bound on a coordinate's after the shear
    float origin_error = 0;  ///< bound on that of a corner minus the origin, before it is rounded

    const Query<double>* query = nullptr;
    double end = 0;  ///< hits are looked for at t <= end
    Hit<double> best{Real<double>::infinity, no_primitive};
};

inline void set_out(const Searched& searched, const Query<double>& query, Traveller& ray) {
    const Vec3<double>& d = query.ray.direction;
    searched.bvh.prepare(query.ray.origin, d, ray.box);
    unsigned octant = 0;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
        const std::uint32_t backwards = ray.box.inverse[axis] < 0 ? 1 : 0;
        octant |= backwards << axis;
        ray.near_row[axis] = 8 * (axis + 3 * backwards);
        ray.far_row[axis] = 8 * (axis + 3 * (1 - backwards));
    }
    ray.order_shift = 3 * octant;
    ray.query = &query;
    ray.end = query.interval.to;
    ray.best = {Real<double>::infinity, no_primitive};
    ray.limit = ray.box.upper(ray.end);

    std::construct_at(&ray.frame, d);
    ray.axis = {static_cast<std::size_t>(ray.frame.x), static_cast<std::size_t>(ray.frame.y),
                static_cast<std::size_t>(ray.frame.z)};
    const Vec3<double> o = searched.filter.origin_of(ray.box);
    constexpr double farthest = 1e18;  // products stay finite; the error is far larger there
    for (std::size_t k = 0; k < 3; ++k) {
        const int a = static_cast<int>(ray.axis[k]);
        ray.origin[k] = static_cast<float>(std::min(std::max(o[a], -farthest), farthest));
        ray.direction[k] = static_cast<float>(d[a]);
    }
    ray.shear_x = static_cast<float>(ray.frame.shear_x);
    ray.shear_y = static_cast<float>(ray.frame.shear_y);
    // With R = |v| + |o|: 2 u R for the copies and their difference, as much again through the
    // shear, 3 u R for the shear's own rounding, 3 u R for the product and the sum; and twice what
    // double has lost of a far origin, before and after the shear.
    constexpr float roundoff = 0x1p-24F;
    const float away =
        std::abs(ray.origin[0]) + std::abs(ray.origin[1]) + std::abs(ray.origin[2]);
    const auto lost = static_cast<float>(ray.box.error);
    ray.error = 12 * roundoff * (static_cast<float>(searched.filter.reach()) + away) + 2 * lost;
    ray.origin_error = roundoff * away + searched.filter.edge_error() + 2 * lost;
}

/// Where the ray enters the eight children, and which of them it meets.
inline unsigned enter_children(const WideBvh::Node& node, const Traveller& ray, F8& near) {
    const float* const planes = node.min[0].data();
    const auto enter = [&](std::size_t axis) {
        return multiply_subtract(F8::load(planes + ray.near_row[axis]),
                                 F8::all(ray.box.inverse[axis]), F8::all(ray.box.near_bias[axis]));
    };
    const auto leave = [&](std::size_t axis) {
        return multiply_subtract(F8::load(planes + ray.far_row[axis]),
                                 F8::all(ray.box.inverse[axis]), F8::all(ray.box.far_bias[axis]));
    };
    near = max(max(enter(0), enter(1)), max(enter(2), F8::all(0)));
    const F8 far = min(min(leave(0), leave(1)), min(leave(2), F8::all(ray.limit)));
    return less_equal(near, far);
}

/// The triangles of a leaf that the ray's line may pass through: Woop's test in float, an edge
/// function counting as 0 where rounding may have made its sign. With E the bound on a coordinate's
/// error and S the sum of the six coordinates' sizes, an edge function's is under 2 E S + 4 E^2.
inline unsigned filter_lines(const LeafFilter& filter, Ref leaf, const Traveller& ray) {
    const std::size_t n = leaf.count();
    const float* const rows = filter.of_leaf(leaf);
    F8 x[3], y[3];
    F8 size = F8::all(0);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto coordinate = [&](std::size_t a) {
            return F8::load(rows + (3 * k + ray.axis[a]) * n) - F8::all(ray.origin[a]);
        };
        const F8 z = coordinate(2);
        x[k] = subtract_product(coordinate(0), F8::all(ray.shear_x), z);
        y[k] = subtract_product(coordinate(1), F8::all(ray.shear_y), z);
        size = size + (abs(x[k]) + abs(y[k]));
    }
    const F8 e0 = multiply_subtract(x[2], y[1], y[2] * x[1]);
    const F8 e1 = multiply_subtract(x[0], y[2], y[0] * x[2]);
    const F8 e2 = multiply_subtract(x[1], y[0], y[1] * x[0]);
    const F8 error = multiply_add(size, F8::all(2 * ray.error),
                                  F8::all(4 * ray.error * ray.error));
    const F8 zero = F8::all(0);
    return less_equal(max(max(e0, e1), e2), error) |
           less_equal(zero - error, min(min(e0, e1), e2));
}

/// The triangles of a leaf whose planes the ray may meet between its start and its limit: the
/// plane is met at t = (n . a) / (n . d), with n the product of the edges e and f. With u the
/// roundoff, h the copies' part in an edge's error and | | the sum of three sizes, n . x has an
/// error under q |x|, q = 12 u |e||f| + 3 h (|e| + |f| + h), and a one of its own. What is edge-on
/// within this error may be met anywhere.
inline unsigned filter_planes(const LeafFilter& filter, Ref leaf, const Traveller& ray) {
    constexpr float roundoff = 0x1p-24F;
    const std::size_t n = leaf.count();
    const float* const rows = filter.of_leaf(leaf);
    F8 a[3], e[3], f[3];
    for (std::size_t k = 0; k < 3; ++k) {
        const F8 corner = F8::load(rows + ray.axis[k] * n);
        a[k] = corner - F8::all(ray.origin[k]);
        e[k] = F8::load(rows + (3 + ray.axis[k]) * n) - corner;
        f[k] = F8::load(rows + (6 + ray.axis[k]) * n) - corner;
    }
    F8 distance = F8::all(0), speed = F8::all(0);
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        const F8 normal = multiply_subtract(e[i], f[j], e[j] * f[i]);
        distance = multiply_add(normal, a[k], distance);
        speed = multiply_add(normal, F8::all(ray.direction[k]), speed);
    }
    const auto size = [](const F8(&v)[3]) { return abs(v[0]) + abs(v[1]) + abs(v[2]); };
    const F8 size_e = size(e), size_f = size(f);
    const F8 area = size_e * size_f;
    const F8 h = F8::all(filter.edge_error());
    const F8 q = multiply_add(area, F8::all(12 * roundoff),
                              F8::all(3) * (h * (size_e + size_f + h)));
    const F8 error = multiply_add(q, size(a), area * F8::all(2 * ray.origin_error));
    const F8 ahead = with_sign_of(speed, distance);
    return less_equal(abs(speed), q) |
           (less_equal(F8::all(0) - error, ahead) &
            less_equal(ahead, multiply_add(F8::all(ray.limit), abs(speed) + q, error)));
}

/// The spheres of a leaf whose centre the ray may pass within a radius. The centre's distance has
/// an error of some roundings of |c - o|, the bound taken is twice a coordinate's.
inline unsigned filter_spheres(const LeafFilter& filter, Ref leaf, const Traveller& ray) {
    const std::size_t n = leaf.count();
    const float* const rows = filter.of_leaf(leaf);
    F8 from[3];
    F8 along = F8::all(0);
    for (std::size_t k = 0; k < 3; ++k) {
        from[k] = F8::load(rows + ray.axis[k] * n) - F8::all(ray.origin[k]);
        along = multiply_add(from[k], F8::all(ray.direction[k]), along);
    }
    F8 square = F8::all(0);
    for (std::size_t k = 0; k < 3; ++k) {
        const F8 across = subtract_product(from[k], along, F8::all(ray.direction[k]));
        square = multiply_add(across, across, square);
    }
    const F8 reach = F8::load(rows + 3 * n) * F8::all(1 + 0x1p-20F) + F8::all(3 * ray.error);
    return less_equal(square, reach * reach) & less_equal(F8::all(0) - reach, along) &
           less_equal(along - reach, F8::all(ray.limit));
}

/// The cones of a leaf whose axis the ray's line may pass within the larger radius. With w = d x a
/// the lines' distance is |(b - o) . w| / |w|, its numerator's error some roundings of |b - o|.
inline unsigned filter_cones(const LeafFilter& filter, Ref leaf, const Traveller& ray) {
    const std::size_t n = leaf.count();
    const float* const rows = filter.of_leaf(leaf);
    F8 from[3], axis[3];
    for (std::size_t k = 0; k < 3; ++k) {
        from[k] = F8::load(rows + ray.axis[k] * n) - F8::all(ray.origin[k]);
        axis[k] = F8::load(rows + (3 + ray.axis[k]) * n);
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
    return less_equal(abs(distance),
                      multiply_add(radius, square_root(square), F8::all(4 * ray.error)));
}

/// Which shapes of a leaf are to be met in double, a bit for each.
inline unsigned filter_leaf(const LeafFilter& filter, Ref leaf, const Traveller& ray) {
    const unsigned all = (2U << (leaf.count() - 1)) - 1;
    if (leaf.kind() == LeafFilter::triangle) {
        const unsigned passed = filter_lines(filter, leaf, ray) & all;
        return passed == 0 ? 0 : filter_planes(filter, leaf, ray) & passed;
    }
    return leaf.kind() == LeafFilter::sphere ? filter_spheres(filter, leaf, ray) & all
           : leaf.kind() == LeafFilter::cone ? filter_cones(filter, leaf, ray) & all
                                             : all;
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
    const double ox = line.origin[frame.x], oy = line.origin[frame.y], oz = line.origin[frame.z];
    std::array<double, 3> px, py;
    for (std::size_t k = 0; k < 3; ++k) {
        const double z = numbers[3 * k + ray.axis[2]] - oz;
        px[k] = (numbers[3 * k + ray.axis[0]] - ox) - frame.shear_x * z;
        py[k] = (numbers[3 * k + ray.axis[1]] - oy) - frame.shear_y * z;
    }
    return encloses_origin(px, py)
               ? intersect_inside(searched.filter.triangle_of(leaf, lane), line, frame, start)
               : Roots<double>{};
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

/// The shape at a lane of a leaf, met in double.
inline Roots<double> meet(const Searched& searched, Ref leaf, std::size_t lane,
                          const Traveller& ray) {
    const auto id = [&] { return searched.bvh.items()[leaf.first() + lane]; };
    const PrimitiveId leaving = ray.query->leaving;
    const Start start =
        leaving == no_primitive ? Start::anywhere : start_on(id(), leaving);
    switch (leaf.kind()) {
        case LeafFilter::triangle:
            return meet_triangle(searched, leaf, lane, ray, start);
        case LeafFilter::sphere:
            return meet_sphere(searched, leaf, lane, ray, start);
        case LeafFilter::cone:
            return meet_cone(searched, leaf, lane, ray, start);
        default:
            return searched.shapes->intersect(id(), ray.query->ray, leaving);
    }
}

/// Meets the shapes of a leaf; true where nothing more is to be looked for.
template <bool any_will_do>
inline bool meet_leaf(const Searched& searched, Ref leaf, Traveller& ray) {
    const Query<double>& query = *ray.query;
    for (unsigned left = filter_leaf(searched.filter, leaf, ray); left != 0; left &= left - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(left));
        const Roots<double> roots = meet(searched, leaf, lane, ray);
        for (std::size_t k = 0; k < static_cast<std::size_t>(roots.count); ++k) {
            if (!query.interval.contains(roots.t[k]) || roots.t[k] > ray.best.t) {
                continue;
            }
            const Hit<double> hit{roots.t[k], searched.bvh.items()[leaf.first() + lane]};
            if (hit < ray.best) {
                ray.best = hit;
                if constexpr (any_will_do) {
                    return true;
                }
                ray.end = hit.t;
                ray.limit = ray.box.upper(hit.t);
            }
        }
    }
    return false;
}

/// What is yet to be visited: places are written in eights, so some more than are used. Where any
/// hit will do, the limit stays as it is: then the order does not matter, and where a child is
/// entered is not kept.
template <bool any_will_do> struct Waiting {
    static constexpr std::size_t places = WideBvh::stack_size + 8;
    std::array<float, places> near;
    std::array<std::uint32_t, places> ref;
    std::size_t top = 0;

    void push(float entered, Ref child) {
        near[top] = entered;
        ref[top++] = std::bit_cast<std::uint32_t>(child);
    }
    void push_children(const WideBvh::Node& node, const Traveller& ray) {
        F8 entered;
        const unsigned met = enter_children(node, ray, entered);
        append_children(node, ray, entered, met);
    }
    void append_children(const WideBvh::Node& node, const Traveller& ray, const F8& entered,
                         unsigned met) {
        const auto* const children = reinterpret_cast<const std::uint32_t*>(node.child.data());
        if constexpr (any_will_do) {
            top += append_unordered(children, met, &ref[top]);
        } else {
            top += append(entered, children, met, node.order.data(), ray.order_shift, &near[top],
                          &ref[top]);
        }
    }
    /// Takes out the next that is worth a visit; false where there is none.
    bool pop(float limit, Ref& next) {
        while (top > 0) {
            --top;
            if (any_will_do || near[top] <= limit) {
                next = Ref::of(ref[top]);
                return true;
            }
        }
        return false;
    }
};

/// The node or leaf to go on with among the children of a node, the others left waiting; false
/// where there is none. What most often happens, one child or two, has branches of its own, which
/// the processor guesses and so goes on before it knows.
template <bool any_will_do>
inline bool choose_child(const WideBvh::Node& node, const Traveller& ray,
                         Waiting<any_will_do>& waiting, Ref& next) {
    F8 entered;
    unsigned met = enter_children(node, ray, entered);
    if (met == 0) {
        return false;
    }
    const auto first = static_cast<std::size_t>(std::countr_zero(met));
    next = node.child[first];
    if ((met & (met - 1)) == 0) {
        return true;
    }
    std::array<float, 8> near;
    entered.store(near.data());
    const unsigned others = met & (met - 1);
    const auto second = static_cast<std::size_t>(std::countr_zero(others));
    if ((others & (others - 1)) == 0) {
        if (near[second] < near[first]) {
            waiting.push(near[first], next);
            next = node.child[second];
        } else {
            waiting.push(near[second], node.child[second]);
        }
        return true;
    }
    waiting.append_children(node, ray, entered, met);
    next = Ref::of(waiting.ref[--waiting.top]);
    return true;
}

/// One ray, from a node or leaf on, to its end. True where it has met what is looked for.
template <bool any_will_do, bool counted>
inline bool travel(const Searched& searched, Traveller& ray, Waiting<any_will_do>& waiting,
                   Ref next, std::size_t* tests) {
    const WideBvh::Node* const nodes = searched.bvh.nodes().data();
    for (;;) {
        bool here = true;
        while (!next.is_leaf() && here) {
            here = choose_child(nodes[next.node()], ray, waiting, next);
        }
        if (here) {
            if constexpr (counted) {
                *tests += next.count();
            }
            if (meet_leaf<any_will_do>(searched, next, ray)) {
                return true;
            }
        }
        if (!waiting.pop(ray.limit, next)) {
            return ray.best.primitive != no_primitive;
        }
    }
}

template <bool any_will_do>
Traveller follow_one(const Searched& searched, const Query<double>& query, std::size_t* tests) {
    Traveller ray;
    set_out(searched, query, ray);
    Waiting<any_will_do> waiting;
    if (tests) {
        travel<any_will_do, true>(searched, ray, waiting, Ref::to_node(0), tests);
    } else {
        travel<any_will_do, false>(searched, ray, waiting, Ref::to_node(0), nullptr);
    }
    return ray;
}

Hit<double> closest(const Searched& searched, const Query<double>& query, std::size_t* tests) {
    return searched.bvh.empty() ? Hit<double>{} : follow_one<false>(searched, query, tests).best;
}

PrimitiveId any(const Searched& searched, const Query<double>& query, std::size_t* tests) {
    return searched.bvh.empty() ? no_primitive
                                : follow_one<true>(searched, query, tests).best.primitive;
}

/// Where the answers go.
inline void answer(std::span<Hit<double>> hits, std::size_t k, const Hit<double>& best) {
    hits[k] = best.primitive == no_primitive ? Hit<double>{} : best;
}
inline void answer(std::span<std::uint8_t> met, std::size_t k, const Hit<double>& best) {
    met[k] = best.primitive == no_primitive ? 0 : 1;
}

inline void prefetch(const Searched& searched, Ref next) {
    const char* const at = next.is_leaf()
                               ? reinterpret_cast<const char*>(searched.filter.of_leaf(next))
                               : reinterpret_cast<const char*>(&searched.bvh.nodes()[next.node()]);
    for (int line = 0; line < 4; ++line) {
        __builtin_prefetch(at + 64 * line);
    }
}

/// Several rays on their way at a time: while one waits for memory another is worked on, and what
/// a ray does next, which no processor can guess, is decided by the list it is put on.
template <bool any_will_do, class Answers> class Flight {
  public:
    Flight(const Searched& searched, Kernels::Queries queries, Answers answers)
        : searched_(searched), queries_(queries), answers_(answers) {}

    void run() {
        for (std::uint32_t seat = 0; seat < seats && next_ < queries_.size(); ++seat) {
            board(seat);
        }
        std::array<std::uint32_t, seats> now;
        while (counts_[0] + counts_[1] > 0) {
            for (std::uint32_t list = 0; list < 2; ++list) {
                const std::size_t count = counts_[list];
                std::copy_n(lists_[list].begin(), count, now.begin());
                counts_[list] = 0;
                for (std::size_t k = 0; k < count; ++k) {
                    list == 0 ? visit_node(now[k]) : visit_leaf(now[k]);
                }
            }
        }
    }

  private:
    static constexpr std::uint32_t seats = 16;

    struct Seat {
        Traveller ray;
        Waiting<any_will_do> waiting;
        std::size_t query = 0;
        Ref next;
    };

    void board(std::uint32_t seat) {
        Seat& s = seats_[seat];
        s.query = next_++;
        set_out(searched_, queries_[s.query], s.ray);
        s.next = Ref::to_node(0);
        s.waiting.top = 0;
        lists_[0][counts_[0]++] = seat;
    }

    void leave(std::uint32_t seat) {
        answer(answers_, seats_[seat].query, seats_[seat].ray.best);
        if (next_ < queries_.size()) {
            board(seat);
        }
    }

    void go_on(std::uint32_t seat) {
        Seat& s = seats_[seat];
        if (!s.waiting.pop(s.ray.limit, s.next)) {
            leave(seat);
            return;
        }
        prefetch(searched_, s.next);
        const std::size_t list = s.next.is_leaf() ? 1 : 0;
        lists_[list][counts_[list]++] = seat;
    }

    void visit_node(std::uint32_t seat) {
        Seat& s = seats_[seat];
        s.waiting.push_children(searched_.bvh.nodes()[s.next.node()], s.ray);
        go_on(seat);
    }

    void visit_leaf(std::uint32_t seat) {
        Seat& s = seats_[seat];
        if (meet_leaf<any_will_do>(searched_, s.next, s.ray)) {
            leave(seat);
        } else {
            go_on(seat);
        }
    }

    const Searched& searched_;
    Kernels::Queries queries_;
    Answers answers_;
    std::size_t next_ = 0;
    std::array<std::size_t, 2> counts_{};  ///< of those that visit a node next, and a leaf
    std::array<std::array<std::uint32_t, seats>, 2> lists_;
    std::array<Seat, seats> seats_;
};

/// Sixteen rays side by side. A node's children are first tested with bounds on all of them at
/// once, then each that may be met with every ray.
template <bool any_will_do> class Packet {
  public:
    static constexpr std::size_t most = 16;

    explicit Packet(const Searched& searched) : searched_(searched) {}

    template <class Answers>
    void run(Kernels::Queries queries, Answers answers, std::size_t first) {
        const std::size_t count = std::min(most, queries.size() - first);
        for (std::size_t k = 0; k < count; ++k) {
            set_out(searched_, queries[first + k], rays_[k]);
        }
        for (unsigned left = (1U << count) - 1; left != 0;) {
            const Traveller& one = rays_[static_cast<std::size_t>(std::countr_zero(left))];
            unsigned alike = 0;
            for (std::size_t k = 0; k < count; ++k) {
                alike |= (rays_[k].order_shift == one.order_shift ? 1U : 0U) << k;
            }
            travel_together(alike & left, one);
            left &= ~alike;
        }
        for (std::size_t k = 0; k < count; ++k) {
            answer(answers, first + k, rays_[k].best);
        }
    }

  private:
    /// Below so many rays each goes alone.
    static constexpr int fewest = 3;

    /// Bounds on the rays' origins and directions on an axis, for the near and the far planes.
    struct Bounds {
        float near_origin, far_origin, low_inverse, high_inverse, error;
    };

    void gather(unsigned group, const Traveller& one) {
        near_row_ = one.near_row;
        far_row_ = one.far_row;
        order_shift_ = one.order_shift;
        std::array<std::array<float, most>, 3> origin;
        for (std::size_t k = 0; k < most; ++k) {
            const bool in_group = (group >> k & 1) != 0;
            const WideBvh::BoxRay& box = (in_group ? rays_[k] : one).box;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                inverse_[axis][k] = box.inverse[axis];
                near_bias_[axis][k] = box.near_bias[axis];
                far_bias_[axis][k] = box.far_bias[axis];
                origin[axis][k] = static_cast<float>(box.origin[static_cast<int>(axis)]);
            }
            limit_[k] = in_group ? rays_[k].limit : -1.0F;
        }
        find_farthest();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const float low = smallest(origin[axis]), high = largest(origin[axis]);
            const F8 error = max(F8::load(&near_bias_[axis][0]) - F8::load(&far_bias_[axis][0]),
                                 F8::load(&near_bias_[axis][8]) - F8::load(&far_bias_[axis][8]));
            Bounds& b = bounds_[axis];
            b.low_inverse = smallest(inverse_[axis]);
            b.high_inverse = largest(inverse_[axis]);
            b.error = largest_of(error);
            const bool backwards = b.low_inverse < 0;
            b.near_origin = backwards ? low : high;
            b.far_origin = backwards ? high : low;
        }
    }

    static float smallest(const std::array<float, most>& row) {
        return smallest_of(min(F8::load(&row[0]), F8::load(&row[8])));
    }
    static float largest(const std::array<float, most>& row) {
        return largest_of(max(F8::load(&row[0]), F8::load(&row[8])));
    }
    void find_farthest() { farthest_ = largest(limit_); }

    /// The children that any of the rays may meet, and where the first may enter them.
    unsigned enter_children_together(const WideBvh::Node& node, F8& near) const {
        const float* const planes = node.min[0].data();
        near = F8::all(0);
        F8 far = F8::all(farthest_);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Bounds& b = bounds_[axis];
            const F8 low = F8::all(b.low_inverse), high = F8::all(b.high_inverse);
            const F8 first = F8::load(planes + near_row_[axis]) - F8::all(b.near_origin);
            const F8 last = F8::load(planes + far_row_[axis]) - F8::all(b.far_origin);
            near = max(near, min(first * low, first * high) - F8::all(b.error));
            far = min(far, max(last * low, last * high) + F8::all(b.error));
        }
        return less_equal(near, far);
    }

    /// Which rays meet child k.
    unsigned enter_child(const WideBvh::Node& node, std::size_t k) const {
        const float* const planes = node.min[0].data() + k;
        unsigned met = 0;
        for (std::size_t half = 0; half < most; half += 8) {
            F8 near = F8::all(0);
            F8 far = F8::load(&limit_[half]);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const F8 inverse = F8::load(&inverse_[axis][half]);
                near = max(near, multiply_subtract(F8::all(planes[near_row_[axis]]), inverse,
                                                   F8::load(&near_bias_[axis][half])));
                far = min(far, multiply_subtract(F8::all(planes[far_row_[axis]]), inverse,
                                                 F8::load(&far_bias_[axis][half])));
            }
            met |= less_equal(near, far) << half;
        }
        return met;
    }

    void travel_together(unsigned group, const Traveller& one) {
        gather(group, one);
        active_ = group;
        waiting_.top = 0;
        waiting_.push(0, Ref::to_node(0));
        groups_[0] = group;
        while (waiting_.top > 0 && active_ != 0) {
            const std::size_t place = --waiting_.top;
            const Ref next = Ref::of(waiting_.ref[place]);
            const unsigned here = groups_[place] & active_ & still_before(waiting_.near[place]);
            if (here == 0) {
                continue;
            }
            if (next.is_leaf()) {
                visit_leaf(next, here);
            } else if (std::popcount(here) < fewest) {
                travel_alone(next, here);
            } else {
                visit_node(next, here);
            }
        }
    }

    unsigned still_before(float near) const {
        return less_equal(F8::all(near), F8::load(&limit_[0])) |
               less_equal(F8::all(near), F8::load(&limit_[8])) << 8;
    }

    void visit_node(Ref next, unsigned here) {
        const WideBvh::Node& node = searched_.bvh.nodes()[next.node()];
        F8 near;
        const unsigned met = enter_children_together(node, near);
        std::array<float, 8> nears;
        near.store(nears.data());
        for (std::size_t place = 0; place < 8; ++place) {
            const std::size_t k = node.order[place] >> order_shift_ & 7;
            if ((met >> k & 1) == 0) {
                continue;
            }
            if (const unsigned group = enter_child(node, k) & here; group != 0) {
                groups_[waiting_.top] = group;
                waiting_.push(nears[k], node.child[k]);
            }
        }
    }

    void visit_leaf(Ref leaf, unsigned here) {
        for (; here != 0; here &= here - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(here));
            finish(k, meet_leaf<any_will_do>(searched_, leaf, rays_[k]));
        }
        find_farthest();
    }

    void travel_alone(Ref next, unsigned here) {
        for (; here != 0; here &= here - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(here));
            alone_.top = 0;
            const bool met =
                travel<any_will_do, false>(searched_, rays_[k], alone_, next, nullptr);
            finish(k, any_will_do && met);
        }
        find_farthest();
    }

    void finish(std::size_t k, bool at_its_end) {
        limit_[k] = rays_[k].limit;
        if (at_its_end) {
            active_ &= ~(1U << k);
            limit_[k] = -1;
        }
    }

    const Searched& searched_;
    std::array<Traveller, most> rays_;
    std::array<std::array<float, most>, 3> inverse_, near_bias_, far_bias_;
    std::array<float, most> limit_;
    float farthest_ = 0;  ///< the largest of them
    std::array<Bounds, 3> bounds_;
    std::array<std::uint32_t, 3> near_row_, far_row_;
    unsigned order_shift_ = 0;
    unsigned active_ = 0;
    Waiting<false> waiting_;  ///< of the packet, in order in any case
    Waiting<any_will_do> alone_;
    std::array<unsigned, Waiting<false>::places> groups_;
};

template <bool any_will_do, class Answers>
void follow_each(const Searched& searched, Kernels::Queries queries, Answers answers) {
    if (searched.bvh.empty()) {
        for (std::size_t k = 0; k < queries.size(); ++k) {
            answer(answers, k, Hit<double>{});
        }
        return;
    }
    Flight<any_will_do, Answers>(searched, queries, answers).run();
}

template <bool any_will_do, class Answers>
void follow_in_packets(const Searched& searched, Kernels::Queries queries, Answers answers) {
    if (searched.bvh.empty()) {
        follow_each<any_will_do>(searched, queries, answers);
        return;
    }
    Packet<any_will_do> packet(searched);
    for (std::size_t first = 0; first < queries.size(); first += Packet<any_will_do>::most) {
        packet.run(queries, answers, first);
    }
}

}  // namespace

inline constexpr Kernels all_kernels = {
    closest,
    any,
    follow_each<false, std::span<Hit<double>>>,
    follow_each<true, std::span<std::uint8_t>>,
    follow_in_packets<false, std::span<Hit<double>>>,
    follow_in_packets<true, std::span<std::uint8_t>>,
};
