// Rays in any order, several on their way at a time. Part of kernels.inl.

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
