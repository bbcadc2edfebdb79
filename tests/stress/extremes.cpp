#include <filesystem>
#include <nlohmann/json.hpp>

#include "folders.h"
#include "formats/output_file.h"
#include "formats/scene_json.h"
#include "formats/tree_json.h"
#include "scene/input_error.h"
#include "stress.h"
#include "trace/render.h"
#include "tree/record.h"

namespace raytree::stress {
namespace {

using Document = nlohmann::json;

struct Source {
    std::filesystem::path file;
    Document document;
    std::vector<Document::json_pointer> numbers;
};

/// Whole numbers that mean how much work there is, not how large anything is.
bool means_work(const std::string& key) {
    return key == "width" || key == "height" || key == "max_depth" || key == "ray_budget";
}

void find_numbers(const Document& value, const Document::json_pointer& at, Source& source) {
    if (value.is_number()) {
        source.numbers.push_back(at);
    } else if (value.is_array()) {
        for (std::size_t k = 0; k < value.size(); ++k) {
            find_numbers(value[k], at / k, source);
        }
    } else if (value.is_object()) {
        for (const auto& [key, part] : value.items()) {
            if (!means_work(key)) {
                find_numbers(part, at / key, source);
            }
        }
    }
}

/// The example scenes, as small pictures of few levels.
std::vector<Source> load_sources() {
    std::vector<Source> sources;
    for (const auto& entry : std::filesystem::directory_iterator(RAYTREE_DATA_DIR "/scenes")) {
        if (entry.path().extension() != ".json" || entry.file_size() > 20'000) {
            continue;
        }
        Source source;
        source.file = entry.path();
        source.document = Document::parse(read_input(entry.path().string()));
        source.document["camera"]["width"] = 5;
        source.document["camera"]["height"] = 4;
        source.document["settings"]["max_depth"] = 4;
        find_numbers(source.document, Document::json_pointer(), source);
        sources.push_back(std::move(source));
    }
    std::ranges::sort(sources, {}, &Source::file);
    return sources;
}

double extreme(Random& random, double value) {
    constexpr double values[] = {0.0,    -0.0,   5e-324, -5e-324, 1e-310, 1e-300, -1e-300, 1e300,
                                 -1e300, 1e308,  1e-200, 1e200,   1e-150, 1e150,  -1e150,  1e-100,
                                 1e100,  -1e100, 1e-30,  1e30,    1e-16,  1e16,   -1,      1};
    return random.chance(0.2) ? value * random.log_uniform(1e-300, 1e300)
                              : values[random.below(std::size(values))];
}

Document disturbed(Random& random, const Source& source) {
    Document document = source.document;
    if (random.chance(0.15)) {  // the whole scene in another unit
        const double unit = random.log_uniform(1e-300, 1e300);
        for (const auto& at : source.numbers) {
            document[at] = document[at].get<double>() * unit;
        }
        return document;
    }
    for (std::size_t k = 1 + random.below(3); k > 0; --k) {
        Document& number = document[source.numbers[random.below(source.numbers.size())]];
        number = extreme(random, number.get<double>());
    }
    return document;
}

bool holds_no_nan(const std::string& json) {
    return json.find("nan") == std::string::npos && json.find("inf\"") == std::string::npos &&
           json.find("inf,") == std::string::npos && json.find("inf]") == std::string::npos;
}

/// Traces a pixel and the picture; what is wrong with the outcome, or nothing.
template <class T> std::string outcome_of(Random& random, const Scene& scene) {
    const World<T> world(scene);
    const int i = static_cast<int>(random.below(static_cast<std::size_t>(scene.camera.width)));
    const int j = static_cast<int>(random.below(static_cast<std::size_t>(scene.camera.height)));
    const RayTree<T> tree = record_tree(world, i, j);
    if (!holds_no_nan(write_tree_json(tree))) {
        return "a number of the tree is none";
    }
    for (const Rgb<double>& pixel : render(world, {1, {}}).pixels) {
        if (!isfinite(pixel)) {
            return "a pixel of the picture is no number";
        }
    }
    return "";
}

template <class T>
void try_one(Random& random, const Source& source, const Document& document, Tally& tally) {
    std::string wrong;
    try {
        std::vector<std::string> warnings;
        const Scene scene = read_scene_json(document.dump(), source.file, warnings);
        wrong = outcome_of<T>(random, scene);
    } catch (const InputError& error) {
        wrong = std::string_view(error.what()).empty() ? "an error without a reason" : "";
        ++tally.in<T>().undecided;
    } catch (const std::exception& error) {
        wrong = std::string("an error that is none of the input: ") + error.what();
    }
    if (!wrong.empty()) {
        ++tally.in<T>().wrong;
        tally.describe<T>([&](std::ostream& out) {
            out << source.file.filename() << ": " << wrong << "; "
                << Document::diff(source.document, document).dump();
        });
    }
}

Tally run(Random& random, std::uint64_t trials) {
    static const std::vector<Source> sources = load_sources();
    Tally tally;
    for (; tally.trials < trials; ++tally.trials) {
        const Source& source = sources[random.below(sources.size())];
        const Document document = disturbed(random, source);
        try_one<double>(random, source, document, tally);
        try_one<float>(random, source, document, tally);
    }
    return tally;
}

}  // namespace

Row extremes() {
    return {"extremes",
            "the example scenes with extreme values in any of their numbers (0, denormals, 10^±300 "
            "and in between), or all of them in another unit",
            "scenes",
            "an answer without NaN, or an error that says why (counted as undecided)",
            "",
            300,
            100'000,
            50,
            run};
}

}  // namespace raytree::stress
