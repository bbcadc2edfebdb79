#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "math/vector.h"
#include "scene/input_error.h"

/// What every stress test is made of. A test is a number of independent trials, done in blocks; a
/// block's random numbers depend on the seed and on its number alone, so that a run gives the same
/// figures on any number of threads.
namespace raytree::stress {

class Random {
  public:
    Random(std::uint64_t seed, std::uint64_t block) {
        std::seed_seq sequence{seed, seed >> 32, block, block >> 32};
        engine_.seed(sequence);
    }

    double uniform(double low, double high) {
        return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
    }
    /// As likely between 1 and 10 as between 10 and 100.
    double log_uniform(double low, double high) {
        return std::exp(uniform(std::log(low), std::log(high)));
    }
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
    bool chance(double share) { return uniform(0, 1) < share; }
    /// A point of the cube of half side 1 about the origin.
    Vec3<double> in_cube() { return {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}; }
    UnitVec3<double> direction() {
        for (;;) {
            const Vec3<double> v = in_cube();
            const double square = inner(v, v);
            if (square <= 1 && square > 1e-4) {
                return UnitVec3<double>::of(v);
            }
        }
    }
    /// A unit vector across `axis`.
    UnitVec3<double> across(const Vec3<double>& axis) {
        for (;;) {
            const Vec3<double> v = outer(axis, direction().vec());
            if (inner(v, v) > 1e-4) {
                return UnitVec3<double>::of(v);
            }
        }
    }

  private:
    std::mt19937_64 engine_;
};

/// What came out in one arithmetic.
struct Outcome {
    std::uint64_t wrong = 0;      ///< what must not be
    std::uint64_t undecided = 0;  ///< differs from the reference, within the stated bound
    double worst = 0;             ///< largest error, as a share of what is allowed

    /// Notes an error as a share of what is allowed; anything over 1 is wrong, and so is NaN.
    bool judge(double share) {
        const bool good = share <= 1;
        wrong += good ? 0 : 1;
        if (!(share <= worst)) {
            worst = share;
        }
        return good;
    }
    Outcome& operator+=(const Outcome& other) {
        wrong += other.wrong;
        undecided += other.undecided;
        worst = other.worst > worst ? other.worst : worst;
        return *this;
    }
};

struct Tally {
    std::uint64_t trials = 0;
    Outcome in_double;
    Outcome in_float;
    std::string first_wrong;  ///< in double: what to look at

    template <class T> Outcome& in() {
        if constexpr (std::is_same_v<T, float>) {
            return in_float;
        } else {
            return in_double;
        }
    }
    /// Keeps the first description of what went wrong in double.
    template <class T, class Describe> void describe(Describe&& describe) {
        if (std::is_same_v<T, double> && first_wrong.empty()) {
            std::ostringstream text;
            text.precision(17);
            describe(text);
            first_wrong = text.str();
        }
    }
    Tally& operator+=(const Tally& other) {
        trials += other.trials;
        in_double += other.in_double;
        in_float += other.in_float;
        if (first_wrong.empty()) {
            first_wrong = other.first_wrong;
        }
        return *this;
    }
};

/// A thing of a scene in float, or nothing where its range or its digits do not do and the scene is
/// refused.
template <class Thing, class Scene> std::optional<Thing> if_accepted(const Scene& scene) {
    try {
        return std::optional<Thing>(std::in_place, scene);
    } catch (const InputError&) {
        return std::nullopt;
    }
}

struct Row {
    std::string_view name;   ///< on the command line
    std::string_view tried;  ///< for people: what is tried
    std::string_view unit;   ///< of which there are so many
    std::string_view holds;  ///< what must hold
    std::string_view worst;  ///< what the largest error is a share of; empty: there is none
    std::uint64_t quick;     ///< trials of the quick form
    std::uint64_t full;      ///< of the long form
    std::uint64_t block;     ///< trials that share their random numbers
    /// Does about `trials` trials.
    std::function<Tally(Random&, std::uint64_t trials)> run;
    /// Instead of it, where the trials are a list: does those from `first` on.
    std::function<Tally(std::uint64_t first, std::uint64_t trials)> run_range = {};
    bool in_float = true;  ///< whether `float` is tried too
};

Row spheres();
Row tangents();
Row leaving();
Row meshes();
Row polygons();
Row hierarchy();
Row refraction();
Row corridors();
Row extremes();
Row trees();
Row bounds();

inline std::ostream& operator<<(std::ostream& out, const Vec3<double>& v) {
    return out << '(' << v.x << ", " << v.y << ", " << v.z << ')';
}

/// The arithmetic that one is held against: far more digits than it has itself.
template <class T> struct ReferenceOf;
template <> struct ReferenceOf<double> { using Type = Quad; };
template <> struct ReferenceOf<float> { using Type = double; };
template <class T> using Reference = typename ReferenceOf<T>::Type;

}  // namespace raytree::stress
