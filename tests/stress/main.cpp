#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <iostream>
#include <mutex>

#include "scene/input_error.h"
#include "stress.h"
#include "table.h"

/// raytree-stress: tries the arithmetic where it is at its worst.
namespace raytree::stress {
namespace {

std::vector<Row> all_rows() {
    return {spheres(),    tangents(),  leaving(),  meshes(), polygons(), hierarchy(),
            refraction(), corridors(), extremes(), trees(),  bounds()};
}

struct Arguments {
    std::vector<std::string> rows;
    double count = 0;  ///< 0: that of the row's quick or long form
    std::uint64_t seed = 1;
    int threads = 0;
    bool full = false;
    std::string table;
};

Tally run_row(const Row& row, std::uint64_t count, std::uint64_t seed) {
    const std::uint64_t blocks = (count + row.block - 1) / row.block;
    Tally total;
    std::uint64_t first_block = blocks;  // whose description is kept, on any number of threads
    std::mutex mutex;
    tbb::parallel_for(std::uint64_t{0}, blocks, [&](std::uint64_t block) {
        Random random(seed, block);
        const std::uint64_t trials =
            block + 1 < blocks ? row.block : count - row.block * (blocks - 1);
        Tally tally =
            row.run_range ? row.run_range(block * row.block, trials) : row.run(random, trials);
        const std::lock_guard lock(mutex);
        if (!tally.first_wrong.empty() && block < first_block) {
            first_block = block;
            total.first_wrong = tally.first_wrong;
        }
        total += tally;
    });
    return total;
}

bool run(const Arguments& arguments) {
    bool all_hold = true;
    for (const Row& row : all_rows()) {
        const bool wanted =
            arguments.rows.empty() || std::ranges::count(arguments.rows, std::string(row.name)) > 0;
        if (!wanted) {
            continue;
        }
        const auto count = arguments.count > 0 ? static_cast<std::uint64_t>(arguments.count)
                           : arguments.full    ? row.full
                                               : row.quick;
        const auto begin = std::chrono::steady_clock::now();
        const std::clock_t worked = std::clock();
        const Tally tally = run_row(row, count, arguments.seed);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
        const double processor =
            static_cast<double>(std::clock() - worked) / static_cast<double>(CLOCKS_PER_SEC);
        const std::string line = outcome_text(row, tally);
        std::printf("%-11s %s (%.1f s, %.1f s of processor time)\n", std::string(row.name).c_str(),
                    line.c_str(), seconds.count(), processor);
        if (tally.in_double.wrong > 0) {
            all_hold = false;
            std::printf("  the first: %s\n", tally.first_wrong.c_str());
        }
        std::fflush(stdout);
        if (!arguments.table.empty()) {
            update_table(arguments.table, all_rows(), row, tally, arguments.seed, processor);
        }
    }
    return all_hold;
}

int main_with(int argc, char** argv) {
    CLI::App app("Tries raytree's arithmetic where it is at its worst. Exit 1: something is wrong.",
                 "raytree-stress");
    Arguments arguments;
    std::string names;
    for (const Row& row : all_rows()) {
        names += (names.empty() ? "" : ", ") + std::string(row.name);
    }
    app.add_option("ROW", arguments.rows, "which tests; all of them otherwise: " + names);
    app.add_flag("--full", arguments.full, "the long form: hours in all");
    app.add_option("--count", arguments.count, "so many trials of each, such as 1e6");
    app.add_option("--seed", arguments.seed, "of the random numbers (default: 1)");
    app.add_option("--threads", arguments.threads, "work on N threads; all cores otherwise");
    app.add_option("--table", arguments.table, "write the figures into the table in this file");
    CLI11_PARSE(app, argc, argv);
    for (const std::string& name : arguments.rows) {
        if (std::ranges::none_of(all_rows(), [&](const Row& row) { return row.name == name; })) {
            std::cerr << "raytree-stress: there is no test '" << name << "'; there are " << names
                      << '\n';
            return 2;
        }
    }
    const tbb::global_control limit(
        tbb::global_control::max_allowed_parallelism,
        arguments.threads > 0
            ? static_cast<std::size_t>(arguments.threads)
            : tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
    return run(arguments) ? 0 : 1;
}

}  // namespace
}  // namespace raytree::stress

int main(int argc, char** argv) {
    try {
        return raytree::stress::main_with(argc, argv);
    } catch (const raytree::InputError& error) {
        std::cerr << "raytree-stress: " << error.what() << '\n';
        return 2;
    }
}
