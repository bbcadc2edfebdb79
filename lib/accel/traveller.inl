// What a ray carries through a hierarchy. Part of kernels.inl.

using Ref = WideBvh::Ref;

/// What rays have in common whose directions have the same signs.
struct Octant {
    std::array<std::uint32_t, 3> near_row, far_row;  ///< where a node has the planes, in floats
    unsigned order_shift;                            ///< where the order of its children is
};

inline constexpr std::array<Octant, 8> octants = [] {
    std::array<Octant, 8> all{};
    for (unsigned octant = 0; octant < 8; ++octant) {
        for (unsigned axis = 0; axis < 3; ++axis) {
            const unsigned backwards = octant >> axis & 1;
            all[octant].near_row[axis] = 8 * (axis + 3 * backwards);
            all[octant].far_row[axis] = 8 * (axis + 3 * (1 - backwards));
        }
        all[octant].order_shift = 3 * octant;
    }
    return all;
}();

/// A ray on its way: what the boxes and the leaves are tested with, and what it has met.
struct Traveller {
    WideBvh::BoxRay box;
    const Octant* octant = nullptr;
    float limit = 0;  ///< boxes beyond are of no use

    RayFrame<double> frame;  ///< for the triangles

    // For the filter, on the axes of the frame: the last is the direction's largest.
    std::array<int, 3> axis;
    std::array<float, 3> origin;
    std::array<float, 3> direction;
    float shear_x = 0, shear_y = 0;
    float error = 0;         ///< bound on a coordinate's after the shear
    float origin_error = 0;  ///< bound on that of a corner minus the origin, before it is rounded

    const Query<double>* query = nullptr;
    double end = 0;  ///< hits are looked for at t <= end
    Hit<double> best{Real<double>::infinity, no_primitive};
    bool ready_for_boxes = false, ready_for_leaves = false, has_frame = false;
};

inline void begin(const Query<double>& query, Traveller& ray) {
    ray.query = &query;
    ray.end = query.interval.to;
    ray.best = {Real<double>::infinity, no_primitive};
    ray.ready_for_boxes = ray.ready_for_leaves = ray.has_frame = false;
}

inline void set_frame(Traveller& ray) {
    std::construct_at(&ray.frame, ray.query->ray.direction);
    ray.axis = {ray.frame.x, ray.frame.y, ray.frame.z};
    ray.has_frame = true;
}

inline void make_ready_for_boxes(const Searched& searched, Traveller& ray) {
    searched.bvh.prepare(ray.query->ray.origin, ray.query->ray.direction, ray.box);
    unsigned octant = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        octant |= std::bit_cast<std::uint32_t>(ray.box.inverse[axis]) >> 31 << axis;
    }
    ray.octant = &octants[octant];
    ray.limit = ray.box.upper(ray.end);
    ray.ready_for_boxes = true;
}

/// What the leaves need besides.
inline void make_ready_for_leaves(const Searched& searched, Traveller& ray) {
    const Vec3<double>& d = ray.query->ray.direction;
    set_frame(ray);
    const Vec3<double> o = searched.filter.origin_of(ray.box);
    for (std::size_t k = 0; k < 3; ++k) {
        ray.origin[k] = static_cast<float>(component(o, ray.axis[k]));
        ray.direction[k] = static_cast<float>(component(d, ray.axis[k]));
    }
    ray.shear_x = static_cast<float>(ray.frame.shear_x);
    ray.shear_y = static_cast<float>(ray.frame.shear_y);
    // With R = |v| + |o|: 2 u R for the copies and their difference, as much again through the
    // shear, 3 u R for the shear's own rounding, 3 u R for the product and the sum; and twice what
    // double has lost of a far origin, before and after the shear.
    constexpr float roundoff = 0x1p-24F;
    const float away = std::abs(ray.origin[0]) + std::abs(ray.origin[1]) + std::abs(ray.origin[2]);
    const auto lost = static_cast<float>(ray.box.error);
    ray.error = 12 * roundoff * (static_cast<float>(searched.filter.reach()) + away) + 2 * lost;
    ray.origin_error = roundoff * away + searched.filter.edge_error() + 2 * lost;
    ray.ready_for_leaves = true;
}

inline void set_out(const Searched& searched, const Query<double>& query, Traveller& ray) {
    begin(query, ray);
    make_ready_for_boxes(searched, ray);
    make_ready_for_leaves(searched, ray);
}

/// Where the ray enters the eight children, and which of them it meets.
inline unsigned enter_children(const WideBvh::Node& node, const Traveller& ray, F8& near) {
    const float* const planes = node.min[0].data();
    const auto enter = [&](std::size_t axis) {
        return multiply_subtract(F8::load(planes + ray.octant->near_row[axis]),
                                 F8::all(ray.box.inverse[axis]), F8::all(ray.box.near_bias[axis]));
    };
    const auto leave = [&](std::size_t axis) {
        return multiply_subtract(F8::load(planes + ray.octant->far_row[axis]),
                                 F8::all(ray.box.inverse[axis]), F8::all(ray.box.far_bias[axis]));
    };
    near = max(max(enter(0), enter(1)), max(enter(2), F8::all(0)));
    const F8 far = min(min(leave(0), leave(1)), min(leave(2), F8::all(ray.limit)));
    return less_equal(near, far);
}
