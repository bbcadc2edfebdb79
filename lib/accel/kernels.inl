// The kernels, written over eight floats side by side (F8). Included by one file for each
// instruction set, inside a namespace of its own.

namespace {

#include "accel/traveller.inl"

#include "accel/leaf_tests.inl"

#include "accel/single_ray.inl"

/// Where the answers go.
inline void answer(std::span<Hit<double>> hits, std::size_t k, const Hit<double>& best) {
    hits[k] = best.primitive == no_primitive ? Hit<double>{} : best;
}
inline void answer(std::span<std::uint8_t> met, std::size_t k, const Hit<double>& best) {
    met[k] = best.primitive == no_primitive ? 0 : 1;
}

#include "accel/flight.inl"

#include "accel/shaft.inl"

#include "accel/packet.inl"

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

bool may_meet_between(const WideBvh& bvh, Kernels::Queries queries) {
    return !bvh.empty() && may_meet(bvh, Shaft(bvh, queries));
}
