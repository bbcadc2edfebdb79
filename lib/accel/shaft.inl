// What many rays may meet together, found before any of them is looked at by itself. Part of
// kernels.inl.

/// The space that some rays pass through: intervals of their origins and directions, in the
/// coordinates of the boxes (after Haines & Wallace, "Shaft culling for efficient ray-cast
/// radiosity", 1991). The rounding of origins, inverses and products here is within eight float
/// roundings of a position, by which the origins are set apart.
class Shaft {
  public:
    Shaft(const WideBvh& bvh, Kernels::Queries queries) {
        Vec3<double> low_o = queries[0].ray.origin, high_o = low_o;
        Vec3<double> low_d = queries[0].ray.direction, high_d = low_d;
        double end = 0;
        for (const Query<double>& query : queries) {
            const Vec3<double>& o = query.ray.origin;
            const Vec3<double>& d = query.ray.direction;
            for (int a = 0; a < 3; ++a) {
                low_o[a] = o[a] < low_o[a] ? o[a] : low_o[a];
                high_o[a] = o[a] > high_o[a] ? o[a] : high_o[a];
                low_d[a] = d[a] < low_d[a] ? d[a] : low_d[a];
                high_d[a] = d[a] > high_d[a] ? d[a] : high_d[a];
            }
            end = query.interval.to > end ? query.interval.to : end;
        }
        limit_ = to_float(end * bvh.scale() * (1 + 0x1p-20));
        for (int a = 0; a < 3; ++a) {
            set_axis(static_cast<std::size_t>(a), (low_o[a] - bvh.center()[a]) * bvh.scale(),
                     (high_o[a] - bvh.center()[a]) * bvh.scale(), low_d[a], high_d[a]);
        }
    }

    /// The children that some of the rays may meet, and at least how far away.
    unsigned enter_children(const WideBvh::Node& node, F8& near) const {
        return enter(node.min[0].data(), near);
    }
    /// The same for any eight boxes, their planes in the order of a node's.
    unsigned enter(const float* planes, F8& near) const {
        near = F8::all(0);
        F8 far = F8::all(limit_);
        unsigned beside = 0;
        for (const Axis& axis : axes_) {
            const F8 first = F8::load(planes + axis.near_row) - F8::all(axis.near_origin);
            const F8 last = F8::load(planes + axis.far_row) - F8::all(axis.far_origin);
            if (axis.both_ways) {
                beside |= ~(less_equal(first, F8::all(0)) & less_equal(F8::all(0), last));
                continue;
            }
            const F8 low = F8::all(axis.low_inverse), high = F8::all(axis.high_inverse);
            near = max(near, min(first * low, first * high));
            far = min(far, max(last * low, last * high));
        }
        return less_equal(near, far) & ~beside;
    }

    /// How far away things matter, in the coordinates of the boxes; it can only be lowered.
    float limit() const { return limit_; }
    void lower(float limit) { limit_ = std::min(limit_, limit); }

  private:
    static constexpr float largest = 1e30F;

    struct Axis {
        std::uint32_t near_row, far_row;
        float near_origin, far_origin;
        float low_inverse, high_inverse;
        /// There are no inverses: the rays stay between the origins, near being the high one.
        bool both_ways;
    };

    static float to_float(double x) {
        constexpr auto most = static_cast<double>(largest);
        return static_cast<float>(std::min(std::max(x, -most), most));
    }

    void set_axis(std::size_t a, double low_o, double high_o, double low_d, double high_d) {
        constexpr double flattest = 1e-18;
        const double away = std::max(std::abs(low_o), std::abs(high_o)) + 1;
        const double error = 8 * 0x1p-24 * away;
        Axis& axis = axes_[a];
        const auto row = static_cast<std::uint32_t>(a);
        const bool backwards = high_d < 0;
        axis.both_ways = low_d <= flattest && high_d >= -flattest;
        axis.near_row = 8 * (row + (backwards && !axis.both_ways ? 3 : 0));
        axis.far_row = 8 * (row + (backwards && !axis.both_ways ? 0 : 3));
        if (axis.both_ways) {
            const auto reach = static_cast<double>(limit_);
            const double low = low_o + std::min(low_d, 0.0) * reach;
            const double high = high_o + std::max(high_d, 0.0) * reach;
            axis.near_origin = to_float(high + 0x1p-20 * (away + std::abs(high)));
            axis.far_origin = to_float(low - 0x1p-20 * (away + std::abs(low)));
            return;
        }
        const double low = low_o - error, high = high_o + error;
        axis.near_origin = to_float(backwards ? low : high);
        axis.far_origin = to_float(backwards ? high : low);
        axis.low_inverse = 1 / to_float(high_d);
        axis.high_inverse = 1 / to_float(low_d);
    }

    float limit_ = 0;
    std::array<Axis, 3> axes_;
};

/// The copies of the leaves against the boxes.
struct CopySpace {
    std::array<float, 3> shift;  ///< taken off a copy's coordinates they are those of the boxes
    float error;  ///< how far a box of such coordinates may be from holding every hit of its shape

    explicit CopySpace(const Searched& searched) {
        WideBvh::BoxRay middle;
        middle.origin = Vec3<double>(0.0);
        const Vec3<double> origin = searched.filter.origin_of(middle);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            shift[axis] = static_cast<float>(origin[static_cast<int>(axis)]);
        }
        // A dozen roundings of floats up to the reach, and what double loses of a place far away.
        const WideBvh& bvh = searched.bvh;
        const double away = largest_component(bvh.center()) * bvh.scale() + 1;
        error = static_cast<float>(16 * 0x1p-24 * searched.filter.reach() + 256 * 0x1p-53 * away);
    }
};

/// The shapes of a leaf side by side, in the coordinates of the boxes: a box and a sphere around
/// each.
struct LeafShapes {
    std::array<float, 48> planes;  ///< in the order of a node's
    std::array<std::array<float, 8>, 3> center;
    std::array<float, 8> radius;
    /// Of triangles x, y, z of the first corner, the second and the third; of cones those of the
    /// base and of the axis, and the larger radius.
    std::array<std::array<float, 8>, 9> numbers;
    std::array<float, 8> extent;  ///< of triangles, along an axis

    LeafShapes(const Searched& searched, Ref leaf) {
        const LeafFilter& filter = searched.filter;
        const CopySpace space(searched);
        const std::size_t n = leaf.count();
        const float* const rows = filter.of_leaf(leaf);
        const auto row = [&](std::size_t k) { return F8::load(rows + k * n); };
        const unsigned kind = leaf.kind();
        const F8 half = F8::all(0.5F);
        F8 square = F8::all(0);
        if (kind == LeafFilter::triangle) {
            row(12).store(extent.data());
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const F8 first = row(axis) - F8::all(space.shift[axis]);
            F8 low = first, high = first;
            F8 margin = F8::all(space.error);
            if (kind == LeafFilter::triangle) {
                const F8 second = row(axis + 3) - F8::all(space.shift[axis]);
                const F8 third = row(axis + 6) - F8::all(space.shift[axis]);
                low = min(first, min(second, third));
                high = max(first, max(second, third));
                first.store(numbers[axis].data());
                second.store(numbers[axis + 3].data());
                third.store(numbers[axis + 6].data());
                const F8 reach = (high - low) * half;
                square = multiply_add(reach, reach, square);
            } else if (kind == LeafFilter::sphere) {
                margin = margin + row(3);
            } else {
                first.store(numbers[axis].data());
                row(axis + 3).store(numbers[axis + 3].data());
                row(6).store(numbers[6].data());
                const F8 apex = multiply_add(row(axis + 3), row(7), first);
                low = min(first, apex);
                high = max(first, apex);
                margin = margin + row(6);
            }
            ((low + high) * half).store(center[axis].data());
            (low - margin).store(&planes[8 * axis]);
            (high + margin).store(&planes[8 * (axis + 3)]);
        }
        (kind == LeafFilter::triangle ? square_root(square)
         : kind == LeafFilter::sphere ? row(3)
                                      : row(8))
            .store(radius.data());
    }
};

inline unsigned all_lanes(Ref leaf) { return (2U << (leaf.count() - 1)) - 1; }

/// Whether some of the rays may meet something; true also where it takes long to tell.
inline bool may_meet(const WideBvh& bvh, const Shaft& shaft) {
    constexpr std::size_t visits_most = 64, waiting_most = 64;
    std::array<Ref, waiting_most> waiting{Ref::to_node(0)};
    std::size_t top = 1;
    for (std::size_t visits = 0; top > 0; ++visits) {
        const WideBvh::Node& node = bvh.nodes()[waiting[--top].node()];
        F8 near;
        unsigned met = shaft.enter_children(node, near);
        if (visits == visits_most ||
            top + static_cast<std::size_t>(std::popcount(met)) > waiting_most) {
            return true;
        }
        for (; met != 0; met &= met - 1) {
            const Ref child = node.child[static_cast<std::size_t>(std::countr_zero(met))];
            if (child.is_leaf()) {
                return true;
            }
            waiting[top++] = child;
        }
    }
    return false;
}

/// Up to sixteen rays side by side as lines in float, in the coordinates of the boxes.
class Lines {
  public:
    static constexpr std::size_t most = 16;

    void set(const Searched& searched, Kernels::Queries queries) {
        const WideBvh& bvh = searched.bvh;
        float away = 0;
        for (std::size_t k = 0; k < most; ++k) {
            const Query<double>& query = queries[k < queries.size() ? k : 0];
            const Vec3<double> o = (query.ray.origin - bvh.center()) * bvh.scale();
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const int a = static_cast<int>(axis);
                origin_[axis][k] = clamped(o[a]);
                direction_[axis][k] = static_cast<float>(query.ray.direction[a]);
            }
            set_limit(k, query.interval.to * bvh.scale());
            away = std::max(
                away, std::abs(origin_[0][k]) + std::abs(origin_[1][k]) + std::abs(origin_[2][k]));
        }
        // From very far away floats tell nothing, and every shape passes.
        error_ = away < 1e6F ? 40 * 0x1p-24F * (away + 4) + 8 * CopySpace(searched).error : 1e30F;
        set_frame(queries);
    }
    /// Nothing matters to the ray from `limit` on.
    void set_limit(std::size_t k, double limit) { limit_[k] = clamped(limit * (1 + 0x1p-20)); }
    /// The largest limit of some rays.
    float farthest(unsigned some) const {
        float limit = 0;
        for (; some != 0; some &= some - 1) {
            limit = std::max(limit, limit_[static_cast<std::size_t>(std::countr_zero(some))]);
        }
        return limit;
    }

    /// Those that may pass a shape's centre within its radius. With S the sizes of the origin and
    /// the centre together, the way across has an error under 32 u S and six of a box's.
    unsigned pass(const LeafShapes& shapes, std::size_t lane) const {
        const F8 reach = F8::all(shapes.radius[lane] * (1 + 0x1p-20F) + error_);
        unsigned met = 0;
        for (std::size_t half = 0; half < most; half += 8) {
            const auto direction = [&](std::size_t axis) {
                return F8::load(&direction_[axis][half]);
            };
            F8 from[3];
            F8 along = F8::all(0), square = F8::all(0);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                from[axis] = F8::all(shapes.center[axis][lane]) - F8::load(&origin_[axis][half]);
                along = multiply_add(from[axis], direction(axis), along);
            }
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const F8 across = subtract_product(from[axis], along, direction(axis));
                square = multiply_add(across, across, square);
            }
            met |= (less_equal(square, reach * reach) & less_equal(F8::all(0) - reach, along) &
                    less_equal(along - reach, F8::load(&limit_[half])))
                   << half;
        }
        return met;
    }

    /// Those whose lines may pass through a triangle: Woop's test, as for a leaf
    /// (filter_triangles).
    unsigned pass_triangle(const LeafShapes& shapes, std::size_t lane) const {
        if (!one_frame_) {
            return (1U << most) - 1;
        }
        unsigned met = 0;
        for (std::size_t half = 0; half < most; half += 8) {
            const F8 shear_x = F8::load(&shear_x_[half]), shear_y = F8::load(&shear_y_[half]);
            F8 x[3], y[3];
            for (std::size_t k = 0; k < 3; ++k) {
                const auto coordinate = [&](std::size_t axis) {
                    return F8::all(shapes.numbers[3 * k + axis][lane]) -
                           F8::load(&origin_[axis][half]);
                };
                const F8 z = coordinate(axis_[2]);
                x[k] = subtract_product(coordinate(axis_[0]), shear_x, z);
                y[k] = subtract_product(coordinate(axis_[1]), shear_y, z);
            }
            met |= may_enclose_origin(x, y, F8::all(shapes.extent[lane]), error_) << half;
        }
        return met;
    }

    /// Those whose lines may pass a cone's axis within its larger radius, as for a leaf
    /// (filter_cones).
    unsigned pass_cone(const LeafShapes& shapes, std::size_t lane) const {
        const F8 radius = F8::all(shapes.numbers[6][lane] * (1 + 0x1p-20F));
        unsigned met = 0;
        for (std::size_t half = 0; half < most; half += 8) {
            F8 distance = F8::all(0), square = F8::all(0);
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
                const F8 across = multiply_subtract(
                    F8::load(&direction_[i][half]), F8::all(shapes.numbers[3 + j][lane]),
                    F8::load(&direction_[j][half]) * F8::all(shapes.numbers[3 + i][lane]));
                const F8 from = F8::all(shapes.numbers[k][lane]) - F8::load(&origin_[k][half]);
                distance = multiply_add(from, across, distance);
                square = multiply_add(across, across, square);
            }
            met |= less_equal(abs(distance),
                              multiply_add(radius, square_root(square), F8::all(2 * error_)))
                   << half;
        }
        return met;
    }

  private:
    /// The frame of the rays, where they have the same axes (RayFrame).
    void set_frame(Kernels::Queries queries) {
        const RayFrame<double> frame(queries[0].ray.direction);
        axis_ = {static_cast<std::size_t>(frame.x), static_cast<std::size_t>(frame.y),
                 static_cast<std::size_t>(frame.z)};
        one_frame_ = true;
        for (std::size_t k = 0; k < most; ++k) {
            const float x = direction_[axis_[0]][k], y = direction_[axis_[1]][k],
                        z = direction_[axis_[2]][k];
            one_frame_ = one_frame_ && std::abs(x) <= std::abs(z) && std::abs(y) <= std::abs(z);
            shear_x_[k] = x / z;
            shear_y_[k] = y / z;
        }
    }

    static float clamped(double x) {
        constexpr double farthest = 1e18;  // squares stay finite; the error is far larger there
        return static_cast<float>(std::min(std::max(x, -farthest), farthest));
    }

    std::array<std::array<float, most>, 3> origin_, direction_;
    std::array<float, most> limit_;
    float error_ = 0;
    bool one_frame_ = false;
    std::array<std::size_t, 3> axis_;
    std::array<float, most> shear_x_, shear_y_;
};
