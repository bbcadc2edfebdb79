// Rays that go much the same way, side by side. Part of kernels.inl.

/// Whether the next packet of a list goes as one. After one for which that did not pay some go side
/// by side at once, and more each time: the packets of a list are mostly alike.
class Patience {
  public:
    bool tries() { return left_ == 0 || --left_ == 0; }
    void paid() { pause_ = 0; }
    void did_not_pay() {
        pause_ = std::min(2 * pause_ + 1, longest);
        left_ = pause_ + 1;
    }

  private:
    static constexpr int longest = 63;
    int pause_ = 0;  ///< so many went side by side after the last that did not pay
    int left_ = 0;   ///< until one goes as one again
};

/// Sixteen rays together: as one, and where they go too far apart for that, side by side. Then a
/// node's children are first tested with bounds on all of them at once, then each that may be met
/// with every ray.
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
        active_ = (1U << count) - 1;
        has_lines_ = false;
        waiting_.top = 0;
        waiting_.push(0, Ref::to_node(0));
        const bool finished = patience_.tries() && travel_as_one(together);
        if (!finished) {
            travel_side_by_side(count);
        }
        for (std::size_t k = 0; k < count; ++k) {
            answer(answers, first + k, rays_[k].best);
        }
    }

  private:
    /// Below so many rays each goes alone.
    static constexpr int fewest = 3;
    /// As much do all rays together look for before they go side by side, in units of half a node.
    static constexpr int most_work = 64;
    /// Up to so much is less than they would look for one by one.
    static constexpr int work_that_pays = 32;

    /// Follows the space around all rays, so that none needs to be prepared for boxes. False where
    /// that comes upon so much that it no longer pays; what is left then waits.
    bool travel_as_one(Kernels::Queries queries) {
        Shaft shaft(searched_.bvh, queries);
        int work = 0;
        while (waiting_.top > 0 && active_ != 0) {
            if (work > most_work) {
                patience_.did_not_pay();
                return false;
            }
            const std::size_t place = --waiting_.top;
            const Ref next = Ref::of(waiting_.ref[place]);
            if (waiting_.near[place] > shaft.limit()) {
                continue;
            }
            if (!next.is_leaf()) {
                push_children(searched_.bvh.nodes()[next.node()], shaft);
                work += 2;
            } else if (next.kind() == LeafFilter::other) {
                for (std::size_t lane = 0; lane < next.count(); ++lane) {
                    meet_some(next, lane, active_, shaft);
                }
                work += 1;
            } else {
                work += 3 + meet_few(next, queries, shaft);
            }
        }
        if (work <= work_that_pays) {
            patience_.paid();
        } else {
            patience_.did_not_pay();
        }
        return true;
    }

    /// The nearest on top.
    void push_children(const WideBvh::Node& node, const Shaft& shaft) {
        F8 entered;
        unsigned met = shaft.enter_children(node, entered);
        std::array<float, 8> near;
        entered.store(near.data());
        const std::size_t bottom = waiting_.top;
        for (; met != 0; met &= met - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(met));
            std::size_t place = waiting_.top++;
            for (; place > bottom && waiting_.near[place - 1] < near[k]; --place) {
                waiting_.near[place] = waiting_.near[place - 1];
                waiting_.ref[place] = waiting_.ref[place - 1];
            }
            waiting_.near[place] = near[k];
            waiting_.ref[place] = std::bit_cast<std::uint32_t>(node.child[k]);
        }
    }

    /// Meets those shapes of a leaf that the rays may meet; returns how many these are.
    int meet_few(Ref leaf, Kernels::Queries queries, Shaft& shaft) {
        const LeafShapes shapes(searched_, leaf);
        F8 near;
        const unsigned met = shaft.enter(shapes.planes.data(), near) & all_lanes(leaf);
        if (met != 0 && !has_lines_) {
            lines_.set(searched_, queries);
            has_lines_ = true;
            for (std::size_t k = 0; k < queries.size(); ++k) {
                lines_.set_limit(k, rays_[k].end * searched_.bvh.scale());
            }
        }
        for (unsigned left = met; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            unsigned some = lines_.pass(shapes, lane) & active_;
            if (some != 0 && leaf.kind() != LeafFilter::sphere) {
                some &= leaf.kind() == LeafFilter::triangle ? lines_.pass_triangle(shapes, lane)
                                                            : lines_.pass_cone(shapes, lane);
            }
            meet_some(leaf, lane, some, shaft);
        }
        return std::popcount(met);
    }

    /// Meets one shape with some of the rays.
    void meet_some(Ref leaf, std::size_t lane, unsigned some, Shaft& shaft) {
        const PrimitiveId id = name_of(searched_, leaf, lane);
        const bool is_planar = planar(leaf, id);
        bool nearer = false;
        for (; some != 0; some &= some - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(some));
            Traveller& ray = rays_[k];
            if (is_planar && ray.query->leaving == id) {
                continue;
            }
            if (leaf.kind() == LeafFilter::triangle && !ray.has_frame) {
                set_frame(ray);
            }
            const double end = ray.end;
            if (meet_lane<any_will_do>(searched_, leaf, lane, ray)) {
                active_ &= ~(1U << k);
            } else if (ray.end < end && has_lines_) {
                lines_.set_limit(k, ray.end * searched_.bvh.scale());
                nearer = true;
            }
        }
        if (nearer) {
            shaft.lower(lines_.farthest(active_));
        }
    }

    /// Whether no ray that starts on the shape meets it again.
    bool planar(Ref leaf, PrimitiveId id) const {
        if (leaf.kind() != LeafFilter::other) {
            return leaf.kind() == LeafFilter::triangle;
        }
        const ShapeKind kind = (*searched_.shapes)[id].kind;
        return kind == ShapeKind::polygon || kind == ShapeKind::triangle;
    }

    void travel_side_by_side(std::size_t count) {
        for (std::size_t k = 0; k < count; ++k) {
            make_ready_for_boxes(searched_, rays_[k]);
        }
        const std::size_t rest = waiting_.top;
        std::copy_n(waiting_.ref.begin(), rest, rest_.begin());
        for (unsigned left = active_; left != 0;) {
            const Traveller& one = rays_[static_cast<std::size_t>(std::countr_zero(left))];
            unsigned alike = 0;
            for (std::size_t k = 0; k < count; ++k) {
                alike |= (rays_[k].octant == one.octant ? 1U : 0U) << k;
            }
            travel_together(alike & left, one, rest);
            left &= ~alike;
        }
    }

    /// Bounds on the rays' origins and directions on an axis, for the near and the far planes.
    struct Bounds {
        float near_origin, far_origin, low_inverse, high_inverse, error;
    };

    void gather(unsigned group, const Traveller& one) {
        octant_ = one.octant;
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
            const F8 first = F8::load(planes + octant_->near_row[axis]) - F8::all(b.near_origin);
            const F8 last = F8::load(planes + octant_->far_row[axis]) - F8::all(b.far_origin);
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
                near = max(near, multiply_subtract(F8::all(planes[octant_->near_row[axis]]),
                                                   inverse, F8::load(&near_bias_[axis][half])));
                far = min(far, multiply_subtract(F8::all(planes[octant_->far_row[axis]]), inverse,
                                                 F8::load(&far_bias_[axis][half])));
            }
            met |= less_equal(near, far) << half;
        }
        return met;
    }

    void travel_together(unsigned group, const Traveller& one, std::size_t rest) {
        gather(group, one);
        active_ = group;
        for (waiting_.top = 0; waiting_.top < rest;) {
            groups_[waiting_.top] = group;
            waiting_.push(0, Ref::of(rest_[waiting_.top]));
        }
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
            const std::size_t k = node.order[place] >> octant_->order_shift & 7;
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
            const bool met = travel<any_will_do, false>(searched_, rays_[k], alone_, next, nullptr);
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
    Patience patience_;
    Lines lines_;
    bool has_lines_ = false;
    std::array<Traveller, most> rays_;
    std::array<std::array<float, most>, 3> inverse_, near_bias_, far_bias_;
    std::array<float, most> limit_;
    float farthest_ = 0;  ///< the largest of them
    std::array<Bounds, 3> bounds_;
    const Octant* octant_ = nullptr;
    unsigned active_ = 0;
    Waiting<false> waiting_;  ///< of the packet, in order in any case
    Waiting<any_will_do> alone_;
    std::array<unsigned, Waiting<false>::places> groups_;
    std::array<std::uint32_t, Waiting<false>::places> rest_;
};
