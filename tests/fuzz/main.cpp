#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>
#include <iostream>

#include "mutation.h"
#include "readers.h"
#include "scene/input_error.h"
#include "scene/utf8.h"

/// raytree-fuzz: every reader is given broken files. Each of them is read or refused with a message
/// that names it, in clean text; nothing else may come of it.
namespace raytree::fuzz {
namespace {

/// What is wrong with how a text was refused; nothing if it is well.
std::string wrong_refusal(const InputError& error) {
    if (error.mistakes().empty()) {
        return "refused without a mistake";
    }
    for (const Mistake& mistake : error.mistakes()) {
        const std::string message = mistake.message();
        if (mistake.text.empty() || message.find("fuzzed.file") == std::string::npos) {
            return "does not say what is wrong where: " + message;
        }
        if (legible(message) != message) {
            return "the message is no clean text: " + legible(message);
        }
    }
    return "";
}

struct Outcome {
    std::size_t read = 0, refused = 0;
    double slowest = 0;  ///< seconds of processor time
    std::string wrong;   ///< of the first case in which something else came of it
};

double processor_seconds() {
    return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

std::string read_one(const Reader& reader, const std::string& text, Outcome& outcome) {
    try {
        reader.read(text);
        ++outcome.read;
    } catch (const InputError& error) {
        ++outcome.refused;
        return wrong_refusal(error);
    } catch (const std::exception& error) {
        return std::string("an error of the program: ") + error.what();
    }
    return "";
}

Outcome try_out(const Reader& reader, std::size_t cases, std::uint64_t seed,
                const std::string& keep) {
    Outcome outcome;
    for (std::size_t k = 0; k < cases && outcome.wrong.empty(); ++k) {
        Random random(seed, k);
        const std::size_t which = random.below(reader.seeds.size());
        const bool as_json = reader.seeds[which].starts_with('{') && random.below(2) == 0;
        const std::string text = as_json ? mutated_json(random, reader.seeds, which)
                                         : mutated(random, reader.seeds, which);
        const double begin = processor_seconds();
        const std::string wrong = read_one(reader, text, outcome);
        outcome.slowest = std::max(outcome.slowest, processor_seconds() - begin);
        if (!wrong.empty()) {
            outcome.wrong = "case " + std::to_string(k) + ": " + wrong;
            if (!keep.empty()) {
                if (std::FILE* const file = std::fopen(keep.c_str(), "wb")) {
                    std::fwrite(text.data(), 1, text.size(), file);
                    std::fclose(file);
                }
            }
        }
    }
    return outcome;
}

int main_with(int argc, char** argv) {
    CLI::App app("Gives every reader broken files. Exit 1: one was neither read nor refused well.",
                 "raytree-fuzz");
    std::vector<std::string> names;
    double cases = 1500;
    std::uint64_t seed = 1;
    std::string keep;
    const std::vector<Reader> readers = all_readers();
    std::string known;
    for (const Reader& reader : readers) {
        known += (known.empty() ? "" : ", ") + std::string(reader.name);
    }
    app.add_option("READER", names, "which readers; all of them otherwise: " + known);
    app.add_option("--cases", cases, "so many files for each, such as 1e6 (default: 1500)");
    app.add_option("--seed", seed, "of the random numbers (default: 1)");
    app.add_option("--keep", keep, "write the first file that shows a defect here");
    CLI11_PARSE(app, argc, argv);
    bool well = true;
    for (const Reader& reader : readers) {
        if (!names.empty() && std::ranges::count(names, std::string(reader.name)) == 0) {
            continue;
        }
        const Outcome outcome = try_out(reader, static_cast<std::size_t>(cases), seed, keep);
        std::printf("%-11s %8zu read, %8zu refused, slowest %.3f s\n",
                    std::string(reader.name).c_str(), outcome.read, outcome.refused,
                    outcome.slowest);
        if (!outcome.wrong.empty()) {
            std::printf("  %s\n", outcome.wrong.c_str());
            well = false;
        }
        std::fflush(stdout);
    }
    return well ? 0 : 1;
}

}  // namespace
}  // namespace raytree::fuzz

int main(int argc, char** argv) {
    try {
        return raytree::fuzz::main_with(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << "raytree-fuzz: " << error.what() << '\n';
        return 2;
    }
}
