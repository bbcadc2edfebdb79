// One ray from the root to its end. Part of kernels.inl.

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
            top += append(entered, children, met, node.order.data(), ray.octant->order_shift,
                          &near[top], &ref[top]);
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
template <bool any_will_do> inline bool choose_child(const WideBvh::Node& node,
                                                     const Traveller& ray,
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
