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
        const float* const planes = node.min[0].data();
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

  private:
    static constexpr float largest = 1e30F;

    struct Axis {
        std::uint32_t near_row, far_row;
        float near_origin, far_origin;
        float low_inverse, high_inverse;
        bool both_ways;  ///< no inverses: the rays stay between the origins, near being the high one
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

/// The leaves that some rays may meet, the nearest first, where these are only a few.
class FewLeaves {
  public:
    struct Leaf {
        float near;
        Ref ref;
    };

    /// False where there are more, or it takes long to tell.
    bool find(const WideBvh& bvh, const Shaft& shaft) {
        count_ = 0;
        std::array<Ref, waiting_most> waiting{Ref::to_node(0)};
        std::size_t top = 1;
        for (std::size_t visits = 0; top > 0; ++visits) {
            const WideBvh::Node& node = bvh.nodes()[waiting[--top].node()];
            F8 near;
            unsigned met = shaft.enter_children(node, near);
            if (visits == visits_most || top + static_cast<std::size_t>(std::popcount(met)) > waiting_most) {
                return false;
            }
            std::array<float, 8> nears;
            near.store(nears.data());
            for (; met != 0; met &= met - 1) {
                const auto k = static_cast<std::size_t>(std::countr_zero(met));
                if (!node.child[k].is_leaf()) {
                    waiting[top++] = node.child[k];
                } else if (!add(nears[k], node.child[k])) {
                    return false;
                }
            }
        }
        return true;
    }

    std::span<const Leaf> leaves() const { return std::span(leaves_).first(count_); }

  private:
    static constexpr std::size_t most = 4;
    static constexpr std::size_t visits_most = 12;
    static constexpr std::size_t waiting_most = 24;

    bool add(float near, Ref ref) {
        if (count_ == most) {
            return false;
        }
        std::size_t place = count_++;
        for (; place > 0 && leaves_[place - 1].near > near; --place) {
            leaves_[place] = leaves_[place - 1];
        }
        leaves_[place] = {near, ref};
        return true;
    }

    std::array<Leaf, most> leaves_;
    std::size_t count_ = 0;
};
