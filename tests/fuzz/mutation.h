#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <string>

/// Breaking files in the ways in which files are broken: by hand, by other programs, in transit.
namespace raytree::fuzz {

/// The same numbers for the same seed and case, on any machine.
class Random {
  public:
    Random(std::uint64_t seed, std::uint64_t which) {
        std::seed_seq sequence{seed, seed >> 32, which, which >> 32};
        engine_.seed(sequence);
    }
    /// From 0 to `count` - 1; 0 where `count` is 0.
    std::size_t below(std::size_t count) {
        return count == 0 ? 0 : static_cast<std::size_t>(engine_() % count);
    }

  private:
    std::mt19937_64 engine_;
};

/// `seeds[which]` with one to four mistakes in it: bytes changed, lost or repeated, the end cut
/// off, lines swapped, words and numbers replaced by extreme ones, brackets nested a thousand deep,
/// a piece of another of the seeds inside.
std::string mutated(Random& random, std::span<const std::string> seeds, std::size_t which);

/// The same for JSON that stays JSON: values replaced by others of any type, taken away, exchanged,
/// or taken from another of the seeds.
std::string mutated_json(Random& random, std::span<const std::string> seeds, std::size_t which);

}  // namespace raytree::fuzz
