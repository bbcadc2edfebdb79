#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "formats/json_parse.h"
#include "scene/scene.h"

/// Assignments: a scene with ranges in place of numbers, of which each student has a variant.
namespace raytree::check {

/// SplitMix64 (Steele, Lea & Flood, 2014): the state grows by 0x9E3779B97F4A7C15, and is mixed. The
/// same on every machine; a variant's stream starts from the seed and its number alone.
class SplitMix64 {
  public:
    explicit SplitMix64(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next();
    /// 0 to n - 1, by the high half of the product (Lemire, 2019, without rejection); n < 2^32.
    std::uint64_t below(std::uint64_t n);

  private:
    std::uint64_t state_;
};

/// A raytree-assignment/1.0: a raytree-scene/1.0 under `scene`, where any value may be
/// `{"from": a, "to": b, "step": s}` (a, a + s, ... up to b; step 0.01 where none is given) or
/// `{"one_of": [...]}`.
struct Assignment {
    std::string name;
    std::filesystem::path folder;      ///< where the meshes of its scene are
    std::size_t pixels = 3;            ///< to choose in each variant
    std::vector<std::string> exposes;  ///< beginnings of ids; empty: all mistakes
    std::string file;
    Json scene;
};

/// Throws InputError with file and place.
Assignment read_assignment(const std::string& text, const std::filesystem::path& file);

struct Variant {
    Scene scene;
    std::vector<std::string> warnings;  ///< what could hide mistakes
};

/// Variant `number`, from 1. The same seed and number give the same scene. Throws InputError where
/// what was drawn is no scene; the place is that of the template.
Variant variant_of(const Assignment& assignment, std::uint64_t seed, std::size_t number);

}  // namespace raytree::check
