// Rays that go much the same way, side by side. Part of kernels.inl.

/// Sixteen rays side by side. A node's children are first tested with bounds on all of them at
/// once, then each that may be met with every ray.
template <bool any_will_do> class Packet {
  public:
    static constexpr std::size_t most = 16;

    explicit Packet(const Searched& searched) : searched_(searched) {}

    template <class Answers>
    void run(Kernels::Queries queries, Answers answers, std::size_t first) {
        const std::size_t count = std::min(most, queries.size() - first);
        const Kernels::Queries together = queries.subspan(first, count);
        for (std::size_t k = 0; k < count; ++k) {
            begin(together[k], rays_[k]);
        }
        if (few_.find(searched_.bvh, Shaft(searched_.bvh, together))) {
            for (const FewLeaves::Leaf& leaf : few_.leaves()) {
                if (!all_leave_plane(together, leaf.ref)) {
                    meet_all(leaf, count);
                }
            }
        } else {
            travel_side_by_side(count);
        }
        for (std::size_t k = 0; k < count; ++k) {
            answer(answers, first + k, rays_[k].best);
        }
    }

  private:
    /// Below so many rays each goes alone.
    static constexpr int fewest = 3;

    /// Whether the leaf is one polygon and all rays start on it, so that none meets it.
    bool all_leave_plane(Kernels::Queries queries, Ref leaf) const {
        const PrimitiveId id = searched_.bvh.items()[leaf.first()];
        return leaf.kind() == LeafFilter::other && leaf.count() == 1 &&
               (*searched_.shapes)[id].kind == ShapeKind::polygon &&
               std::ranges::all_of(queries, [&](const auto& q) { return q.leaving == id; });
    }

    void meet_all(const FewLeaves::Leaf& leaf, std::size_t count) {
        for (std::size_t k = 0; k < count; ++k) {
            Traveller& ray = rays_[k];
            if (any_will_do && ray.best.primitive != no_primitive) {
                continue;
            }
            if (static_cast<double>(leaf.near) > ray.end * searched_.bvh.scale()) {
                continue;
            }
            if (!ray.ready_for_leaves && leaf.ref.kind() != LeafFilter::other) {
                make_ready_for_boxes(searched_, ray);
                make_ready_for_leaves(searched_, ray);
            }
            meet_leaf<any_will_do>(searched_, leaf.ref, ray);
        }
    }

    void travel_side_by_side(std::size_t count) {
        for (std::size_t k = 0; k < count; ++k) {
            make_ready_for_boxes(searched_, rays_[k]);
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
    }

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
            if (!rays_[k].ready_for_leaves && leaf.kind() != LeafFilter::other) {
                make_ready_for_leaves(searched_, rays_[k]);
            }
            finish(k, meet_leaf<any_will_do>(searched_, leaf, rays_[k]));
        }
        find_farthest();
    }

    void travel_alone(Ref next, unsigned here) {
        for (; here != 0; here &= here - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(here));
            alone_.top = 0;
            if (!rays_[k].ready_for_leaves) {
                make_ready_for_leaves(searched_, rays_[k]);
            }
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
    FewLeaves few_;
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
