#pragma once

#include <functional>
#include <string>
#include <vector>

/// What every benchmark program has in common: its command line, and how time is taken.
namespace raytree::bench {

enum class Precision { single, twice, reference };

struct Options {
    std::string name;    ///< of the benchmark
    std::string folder;  ///< for JSON and plots; empty: none are written
    std::string data;    ///< a folder with the scenes of others, such as the SPD's in nff/
    Precision precision = Precision::twice;
    bool quick = false;  ///< smaller scenes and fewer rounds: shows that all works
    int rounds = 7;
    std::string scene;       ///< only this one, where the benchmark has several; empty: all
    std::size_t shapes = 0;  ///< only this size, where the benchmark has several; 0: all
};

/// Runs `body` with the options of the command line; the result is the exit code of `main`. A
/// command line that cannot be understood gives one message and exit code 2.
int run(const std::string& name, const std::string& what, int argc, char** argv,
        const std::function<void(const Options&)>& body);

/// Calls `function.operator()<T>()` with the arithmetic T that was chosen.
template <class Function> decltype(auto) with_arithmetic(Precision precision, Function&& function) {
    switch (precision) {
        case Precision::single:
            return function.template operator()<float>();
        case Precision::reference:
            return function.template operator()<__float128>();
        default:
            return function.template operator()<double>();
    }
}

/// Seconds of processor time that this thread, or this process, has used.
double thread_seconds();
double process_seconds();
double wall_seconds();
/// Bytes of memory that this process holds now.
double resident_bytes();

struct Rival {
    std::string name;
    std::function<void()> work;
};

/// How long one rival took, in seconds, over all rounds.
struct Timing {
    double median = 0;
    double low = 0, high = 0;  ///< first and third quartile
    std::vector<double> rounds;
};

/// Runs the rivals in turn, A B C A B C ..., after a round to warm up, so that a machine that gets
/// slower does so for all of them. `clock` defaults to the time of this thread.
std::vector<Timing> in_turn(const std::vector<Rival>& rivals, int rounds,
                            double (*clock)() = thread_seconds);

/// Calls `work(first, count)` for parts of 0 .. size - 1, each of a multiple of sixteen but the
/// last, on all cores.
void in_parts(std::size_t size, const std::function<void(std::size_t, std::size_t)>& work);

Timing timing_of(std::vector<double> seconds);
double median_of(std::vector<double> values);

/// The median over rounds of `rival / ours`: how many times as fast ours is.
double speedup(const Timing& ours, const Timing& rival);

/// "AMD EPYC, 2 cores, ...", and what the program was built with.
std::string machine_text();

}  // namespace raytree::bench
