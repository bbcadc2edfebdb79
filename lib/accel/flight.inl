// Rays in any order, several on their way at a time. Part of kernels.inl.

/// Several rays on their way at a time: while one waits for memory another is worked on, and what
/// a ray does next, which no processor can guess, is decided by the list it is put on.
template <bool any_will_do, class Answers> class Flight {
  public:
    Flight(const Searched& searched, Kernels::Queries queries, Answers answers)
        : searched_(searched),
          queries_(queries),
          answers_(answers),
          places_{Places{address(searched.bvh.nodes().data()), sizeof(WideBvh::Node)},
                  Places{searched.filter.bytes() > 0  // else there are no copies of shapes
                             ? address(searched.filter.of_leaf(Ref::to_leaf(0, 1, 0)))
                             : 0,
                         LeafFilter::numbers * sizeof(float)}} {}

    void run() {
        free_count_ = seats;
        std::iota(free_.begin(), free_.end(), 0);
        board();
        while (counts_[0] + counts_[1] > 0) {
            visit_nodes();
            visit_leaves();
            board();
        }
    }

  private:
    static constexpr std::uint32_t seats = 16;

    /// Where what is visited lies, to be fetched: a number, as nothing may be there.
    struct Places {
        std::uintptr_t first;
        std::size_t size;
    };
    static std::uintptr_t address(const void* first) {
        return reinterpret_cast<std::uintptr_t>(first);
    }
    struct Seat {
        Traveller ray;
        Waiting<any_will_do> waiting;
        std::size_t query = 0;
        Ref next;
    };

    /// Who is next takes a seat that is free.
    [[gnu::noinline]] void board() {
        const std::size_t count = std::min(free_count_, queries_.size() - next_);
        for (std::size_t k = 0; k < count; ++k) {
            Seat& s = seats_[free_[k]];
            s.query = next_ + k;
            begin(queries_[s.query], s.ray);
            make_ready_for_boxes(searched_, s.ray);
        }
        for (std::size_t k = 0; k < count; ++k) {
            Seat& s = seats_[free_[k]];
            make_ready_for_leaves(searched_, s.ray);
            s.next = Ref::to_node(0);
            s.waiting.top = 0;
            lists_[0][counts_[0]++] = free_[k];
        }
        next_ += count;
        free_count_ = 0;
    }

    void leave(std::uint32_t seat) {
        answer(answers_, seats_[seat].query, seats_[seat].ray.best);
        free_[free_count_++] = seat;
    }

    void go_on(std::uint32_t seat) {
        Seat& s = seats_[seat];
        if (!s.waiting.pop(s.ray.limit, s.next)) {
            leave(seat);
            return;
        }
        const std::size_t list = s.next.is_leaf() ? 1 : 0;
        lists_[list][counts_[list]++] = seat;
        // A place is less than `most_items` of a node too, so no branch is needed to tell them
        // apart.
        const std::uintptr_t at = places_[list].first + places_[list].size * s.next.first();
        for (std::uintptr_t line = 0; line < 4; ++line) {
            __builtin_prefetch(reinterpret_cast<const void*>(at + 64 * line));
        }
    }

    /// Those that are on a list, which is empty then.
    std::size_t take(std::size_t list) {
        now_ = lists_[list];
        return std::exchange(counts_[list], 0);
    }

    // What is done is done for all of them, step by step: the steps of one ray wait for each other,
    // those of several do not. Each step is a function, which has all registers to itself.

    void visit_nodes() {
        const std::size_t count = take(0);
        test_boxes(count);
        queue_children(count);
        for (std::size_t k = 0; k < count; ++k) {
            go_on(now_[k]);
        }
    }

    void visit_leaves() {
        const std::size_t count = take(1);
        filter(count);
        meet_shapes(count);
    }

    [[gnu::noinline]] void test_boxes(std::size_t count) {
        const WideBvh::Node* const nodes = searched_.bvh.nodes().data();
        for (std::size_t k = 0; k < count; ++k) {
            const Seat& s = seats_[now_[k]];
            F8 entered;
            met_[k] = enter_children(nodes[s.next.node()], s.ray, entered);
            entered.store(entered_[k].data());
        }
    }

    [[gnu::noinline]] void queue_children(std::size_t count) {
        const WideBvh::Node* const nodes = searched_.bvh.nodes().data();
        for (std::size_t k = 0; k < count; ++k) {
            Seat& s = seats_[now_[k]];
            s.waiting.append_children(nodes[s.next.node()], s.ray, F8::load(entered_[k].data()),
                                      met_[k]);
        }
    }

    [[gnu::noinline]] void filter(std::size_t count) {
        for (std::size_t k = 0; k < count; ++k) {
            const Seat& s = seats_[now_[k]];
            met_[k] = filter_leaf(searched_.filter, s.next, s.ray);
        }
    }

    [[gnu::noinline]] void meet_shapes(std::size_t count) {
        for (std::size_t k = 0; k < count; ++k) {
            Seat& s = seats_[now_[k]];
            if (meet_lanes<any_will_do>(searched_, s.next, met_[k], s.ray)) {
                leave(now_[k]);
            } else {
                go_on(now_[k]);
            }
        }
    }

    const Searched& searched_;
    Kernels::Queries queries_;
    Answers answers_;
    std::array<Places, 2> places_;  ///< of nodes, of leaves
    std::size_t next_ = 0;
    std::array<std::size_t, 2> counts_{};  ///< of those that visit a node next, and a leaf
    std::array<std::array<std::uint32_t, seats>, 2> lists_{};
    std::size_t free_count_ = 0;
    std::array<std::uint32_t, seats> free_;
    std::array<std::uint32_t, seats> now_;
    std::array<unsigned, seats> met_;  ///< of these, a bit for each child, or shape of the leaf
    std::array<std::array<float, 8>, seats> entered_;
    std::array<Seat, seats> seats_;
};
