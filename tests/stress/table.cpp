#include "table.h"

#include <cmath>
#include <cstdio>
#include <map>

#include "formats/output_file.h"
#include "scene/input_error.h"

namespace raytree::stress {
namespace {

constexpr std::string_view begin_mark = "<!-- table -->\n";
constexpr std::string_view end_mark = "<!-- /table -->";

std::string formatted(const char* format, double value) {
    char text[32];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string grouped(std::uint64_t count) {
    std::string text = std::to_string(count);
    for (std::size_t k = text.size(); k > 3; k -= 3) {
        text.insert(k - 3, ",");
    }
    return text;
}

std::string figures(const Row& row, const Outcome& outcome) {
    std::string text = grouped(outcome.wrong) + " wrong";
    if (outcome.undecided > 0) {
        text += ", " + grouped(outcome.undecided) + " undecided";
    }
    if (!row.worst.empty()) {
        text += "; worst " + formatted("%.2g", outcome.worst);
    }
    return text;
}

std::string figures_in_float(const Row& row, const Tally& tally) {
    return row.in_float ? figures(row, tally.in_float) : "not tried";
}

/// The table's lines, by the row's name.
std::map<std::string, std::string, std::less<>> lines_of(std::string_view table) {
    std::map<std::string, std::string, std::less<>> lines;
    while (!table.empty()) {
        const std::size_t end = table.find('\n');
        const std::string_view line = table.substr(0, end);
        const std::size_t from = line.find('`');
        const std::size_t to = line.find('`', from + 1);
        if (from != std::string_view::npos && to != std::string_view::npos) {
            lines.emplace(line.substr(from + 1, to - from - 1), line);
        }
        table.remove_prefix(end == std::string_view::npos ? table.size() : end + 1);
    }
    return lines;
}

std::string line_of(const Row& row, const std::string& tried, const std::string& in_double,
                    const std::string& in_float, const std::string& took) {
    return "| `" + std::string(row.name) + "` | " + std::string(row.tried) + " | " +
           std::string(row.holds) + " | " + tried + " | " + in_double + " | " + in_float + " | " +
           took + " |";
}

}  // namespace

std::string outcome_text(const Row& row, const Tally& tally) {
    std::string text = grouped(tally.trials) + " " + std::string(row.unit) + ": " +
                       figures(row, tally.in_double) + " | float: " + figures_in_float(row, tally);
    return row.worst.empty() ? text : text + " (of " + std::string(row.worst) + ")";
}

void update_table(const std::string& file, const std::vector<Row>& rows, const Row& row,
                  const Tally& tally, std::uint64_t seed, double seconds) {
    std::string text = read_input(file);
    const std::size_t from = text.find(begin_mark);
    const std::size_t to = text.find(end_mark);
    if (from == std::string::npos || to == std::string::npos || to < from) {
        throw InputError(file, "", "has no lines <!-- table --> and <!-- /table --> for the table");
    }
    const std::size_t inside = from + begin_mark.size();
    auto lines = lines_of(std::string_view(text).substr(inside, to - inside));
    lines[std::string(row.name)] = line_of(
        row, grouped(tally.trials) + " " + std::string(row.unit) + ", seed " + std::to_string(seed),
        figures(row, tally.in_double), figures_in_float(row, tally), formatted("%.0f s", seconds));
    std::string table =
        "| test | tried | must hold | trials | `double` | `float` | processor time |\n"
        "| --- | --- | --- | --- | --- | --- | --- |\n";
    for (const Row& each : rows) {
        const auto line = lines.find(each.name);
        table +=
            (line != lines.end() ? line->second : line_of(each, "not run yet", "", "", "")) + '\n';
    }
    write_output(file, text.replace(inside, to - inside, table));
}

}  // namespace raytree::stress
