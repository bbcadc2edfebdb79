#include "support/bench.h"

#include <sys/resource.h>
#include <tbb/parallel_for.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <ctime>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <thread>

#include "folders.h"

namespace raytree::bench {
namespace {

double seconds_of(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Precision precision_named(const std::string& word) {
    if (word == "float") {
        return Precision::single;
    }
    if (word == "double") {
        return Precision::twice;
    }
    if (word == "reference") {
        return Precision::reference;
    }
    throw std::invalid_argument("--precision: found \"" + word +
                                "\", must be float, double or reference");
}

int number_of(const std::string& option, const std::string& word, int largest) {
    int number = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc{} || stop != word.data() + word.size() || number < 1 ||
        number > largest) {
        throw std::invalid_argument(option + ": found \"" + word + "\", must be 1 to " +
                                    std::to_string(largest));
    }
    return number;
}

Options options_of(const std::string& name, int argc, char** argv) {
    Options options;
    options.name = name;
    options.data = RAYTREE_SHARED_DATA_DIR;
    for (int k = 1; k < argc; ++k) {
        const std::string option = argv[k];
        const auto value = [&]() -> std::string {
            if (k + 1 == argc) {
                throw std::invalid_argument(option + " wants a value");
            }
            return argv[++k];
        };
        if (option == "-o" || option == "--output") {
            options.folder = value();
        } else if (option == "--precision") {
            options.precision = precision_named(value());
        } else if (option == "--data") {
            options.data = value();
        } else if (option == "--rounds") {
            options.rounds = number_of(option, value(), 1000);
        } else if (option == "--scene") {
            options.scene = value();
        } else if (option == "--shapes") {
            options.shapes = static_cast<std::size_t>(number_of(option, value(), 100'000'000));
        } else if (option == "--quick") {
            options.quick = true;
        } else {
            throw std::invalid_argument("there is no option " + option);
        }
    }
    if (options.quick) {
        options.rounds = std::min(options.rounds, 3);
    }
    return options;
}

std::string processor_name() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("model name")) {
            return line.substr(line.find(':') + 2);
        }
    }
    return "unknown processor";
}

double quantile(const std::vector<double>& sorted, double share) {
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    const double rest = place - static_cast<double>(below);
    return sorted[below] + rest * (sorted[above] - sorted[below]);
}

}  // namespace

int run(const std::string& name, const std::string& what, int argc, char** argv,
        const std::function<void(const Options&)>& body) {
    try {
        if (argc > 1 && (std::string(argv[1]) == "--help" || std::string(argv[1]) == "-h")) {
            std::cout << name << ": " << what << "\n\nUsage: raytree bench " << name
                      << " [-o FOLDER] [--precision float|double|reference] [--rounds N] "
                         "[--quick] [--data FOLDER] [--scene NAME] [--shapes N]\n";
            return 0;
        }
        const Options options = options_of(name, argc, argv);
        if (!options.folder.empty()) {
            std::filesystem::create_directories(options.folder);
        }
        body(options);
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "raytree bench " << name << ": " << error.what() << '\n';
        return 2;
    }
}

double thread_seconds() { return seconds_of(CLOCK_THREAD_CPUTIME_ID); }
double process_seconds() { return seconds_of(CLOCK_PROCESS_CPUTIME_ID); }
double wall_seconds() { return seconds_of(CLOCK_MONOTONIC); }

double resident_bytes() {
    std::ifstream file("/proc/self/statm");
    double pages = 0;
    file >> pages >> pages;
    return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

void in_parts(std::size_t size, const std::function<void(std::size_t, std::size_t)>& work) {
    constexpr std::size_t part = 2048;
    tbb::parallel_for(std::size_t(0), (size + part - 1) / part,
                      [&](std::size_t k) { work(k * part, std::min(part, size - k * part)); });
}

Timing timing_of(std::vector<double> seconds) {
    Timing timing;
    timing.rounds = seconds;
    std::sort(seconds.begin(), seconds.end());
    timing.median = quantile(seconds, 0.5);
    timing.low = quantile(seconds, 0.25);
    timing.high = quantile(seconds, 0.75);
    return timing;
}

double median_of(std::vector<double> values) { return timing_of(std::move(values)).median; }

std::vector<Timing> in_turn(const std::vector<Rival>& rivals, int rounds, double (*clock)()) {
    std::vector<std::vector<double>> seconds(rivals.size());
    for (int round = -1; round < rounds; ++round) {
        for (std::size_t k = 0; k < rivals.size(); ++k) {
            const double begin = clock();
            rivals[k].work();
            const double taken = clock() - begin;
            if (round >= 0) {
                seconds[k].push_back(taken);
            }
        }
    }
    std::vector<Timing> timings;
    for (std::vector<double>& of_rival : seconds) {
        timings.push_back(timing_of(std::move(of_rival)));
    }
    return timings;
}

double speedup(const Timing& ours, const Timing& rival) {
    std::vector<double> ratios;
    for (std::size_t k = 0; k < std::min(ours.rounds.size(), rival.rounds.size()); ++k) {
        ratios.push_back(rival.rounds[k] / ours.rounds[k]);
    }
    return median_of(ratios);
}

std::string machine_text() {
    const double gigabytes = static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                             static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e9;
    std::string text = processor_name() + ", " +
                       std::to_string(std::thread::hardware_concurrency()) + " cores, " +
                       std::to_string(static_cast<int>(gigabytes + 0.5)) + " GB";
#if defined(__x86_64__) && defined(__GNUC__)
    text += __builtin_cpu_supports("avx2") ? ", AVX2" : ", without AVX2";
#endif
    return text + "; built by " +
#ifdef __clang__
           "clang " __clang_version__;
#else
           "GCC " __VERSION__;
#endif
}

}  // namespace raytree::bench
