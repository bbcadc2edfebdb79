#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "accel/leaf_filter.h"
#include "accel/query.h"

namespace raytree {

/// What the kernels look at: shapes in double, all or some of a set, with what spares testing them.
struct Searched {
    const ShapeSet<double>* shapes = nullptr;
    WideBvh bvh{};
    LeafFilter filter{};
};

/// The searches of a scene, each compiled for one instruction set. Which one is used decides how
/// fast an answer is found and never which.
struct Kernels {
    using Queries = std::span<const Query<double>>;

    /// One ray; `tests` counts shapes tested, where it is not null.
    Hit<double> (*closest)(const Searched&, const Query<double>&, std::size_t* tests);
    /// Some shape that is hit, no_primitive where there is none.
    PrimitiveId (*any)(const Searched&, const Query<double>&, std::size_t* tests);
    /// Many, several on their way at a time.
    void (*closest_of_each)(const Searched&, Queries, std::span<Hit<double>>);
    void (*any_of_each)(const Searched&, Queries, std::span<std::uint8_t>);
    /// Many, sixteen side by side.
    void (*closest_in_packets)(const Searched&, Queries, std::span<Hit<double>>);
    void (*any_in_packets)(const Searched&, Queries, std::span<std::uint8_t>);
};

extern const Kernels plain_kernels;
#if defined(__x86_64__) && defined(__GNUC__)
extern const Kernels avx2_kernels;
extern const Kernels avx512_kernels;
#endif

/// Those that the processor can run, the fastest last.
std::span<const Kernels* const> runnable_kernels();

/// The fastest of them.
const Kernels& kernels();

}  // namespace raytree
