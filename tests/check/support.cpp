#include "check/support.h"

#include <cctype>
#include <cstdio>
#include <cstdlib>

#include "folders.h"
#include "formats/scene_file.h"
#include "formats/tree_json.h"

namespace raytree::test {

std::string with_digits(const std::string& json, int digits) {
    std::string out;
    bool in_string = false;
    for (std::size_t k = 0; k < json.size();) {
        const char c = json[k];
        in_string = c == '"' && (k == 0 || json[k - 1] != '\\') ? !in_string : in_string;
        const bool number = std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '-';
        if (in_string || !number) {
            out += c;
            ++k;
            continue;
        }
        char* end = nullptr;
        const double value = std::strtod(json.c_str() + k, &end);
        char text[40];
        std::snprintf(text, sizeof text, "%.*g", digits, value);
        out += text;
        k = static_cast<std::size_t>(end - json.c_str());
    }
    return out;
}

Scene data_scene(const std::string& name) {
    return load_scene(RAYTREE_DATA_DIR "/scenes/" + name + ".json").scene;
}

check::Report check_tree(const check::Checker& checker, const RayTree<double>& tree) {
    return checker.check_text(write_tree_json(tree), "submission.json");
}

std::string in_words(const check::Report& report) {
    std::string text = "profile " + report.profile + ", " + report.precision + '\n';
    for (const check::Finding& finding : report.findings) {
        text += "  ray " + std::to_string(finding.ray) + ' ' + std::string(word_of(finding.kind)) +
                " problem " + std::to_string(static_cast<int>(finding.problem)) + ' ' +
                std::string(word_of(finding.field)) + " error " + std::to_string(finding.error) +
                ' ' + finding.expected.word + " / " + finding.found.word + ' ' + finding.subject +
                ' ' + finding.reason +
                (finding.follows_from ? " follows " + std::to_string(*finding.follows_from) : "");
        for (const auto& n : {finding.expected.numbers, finding.found.numbers}) {
            char numbers[100];
            std::snprintf(numbers, sizeof numbers, " (%.9g %.9g %.9g)", n.x[0], n.x[1], n.x[2]);
            text += numbers;
        }
        text += '\n';
    }
    return text;
}

}  // namespace raytree::test
