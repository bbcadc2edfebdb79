#include "support/report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>

#include "formats/json_text.h"
#include "formats/output_file.h"
#include "formats/styled_text.h"

namespace raytree::bench {
namespace {

void write(JsonWriter& json, double number) {
    if (std::isfinite(number)) {
        json.value(number);
    } else {
        json.null();
    }
}

void write(JsonWriter& json, const Cell& cell) {
    if (cell.is_number) {
        write(json, cell.value);
    } else {
        json.value(cell.text);
    }
}

void write(JsonWriter& json, const std::vector<double>& numbers) {
    json.begin_array();
    for (const double number : numbers) {
        write(json, number);
    }
    json.end_array();
}

}  // namespace

std::string Cell::shown() const {
    if (!is_number) {
        return text;
    }
    if (!std::isfinite(value)) {
        return "-";
    }
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, places < 0 ? "%.*g" : "%.*f", std::abs(places), value);
    return buffer;
}

Report::Report(const Options& options, const std::string& title)
    : options_(options), title_(title) {
    std::cout << title << '\n' << machine_text() << '\n';
}

void Report::table(const std::string& caption, const std::vector<std::string>& columns) {
    Table table{caption, columns, {}, {}};
    std::cout << '\n' << caption << "\n\n|";
    for (const std::string& column : columns) {
        table.widths.push_back(std::max<std::size_t>(padded(column, 0).size(), 7));
        std::cout << ' ' << padded(column, table.widths.back()) << " |";
    }
    std::cout << "\n|";
    for (const std::size_t width : table.widths) {
        std::cout << std::string(width + 1, '-') << ":|";
    }
    std::cout << std::endl;
    tables_.push_back(std::move(table));
}

void Report::row(const std::vector<Cell>& cells) {
    Table& table = tables_.back();
    std::cout << '|';
    for (std::size_t k = 0; k < cells.size(); ++k) {
        const std::string shown = cells[k].shown();
        const std::size_t width = table.widths[k];
        const std::string fill(shown.size() < width ? width - shown.size() : 0, ' ');
        std::cout << ' ' << (cells[k].is_number ? fill + shown : padded(shown, width)) << " |";
    }
    std::cout << std::endl;
    table.rows.push_back(cells);
}

void Report::note(const std::string& text) {
    std::cout << '\n' << text << std::endl;
    notes_.push_back(text);
}

std::string Report::file_name(const std::string& rest) const {
    return options_.folder + '/' + options_.name + rest;
}

void Report::plot(const std::string& file, const std::string& title, const std::string& x_axis,
                  const std::string& y_axis, const std::vector<Series>& series) {
    plots_.push_back({file, title, x_axis, y_axis, series});
}

void Report::finish() {
    if (options_.folder.empty()) {
        return;
    }
    write_output(file_name(".json"), json());
    const std::string command =
        "'" RAYTREE_PYTHON "' '" RAYTREE_PLOT "' '" + file_name(".json") + "'";
    if (!plots_.empty() && std::system(command.c_str()) != 0) {
        std::cout << "\nNo plots: they are drawn by Debian's python3-matplotlib." << std::endl;
    }
}

std::string Report::json() const {
    JsonWriter json;
    using Layout = JsonWriter::Layout;
    json.begin_object(Layout::block);
    json.member("format", "raytree-bench/1.0").member("name", options_.name);
    json.member("title", title_).member("machine", machine_text());
    json.member("rounds", options_.rounds);
    json.key("tables").begin_array(Layout::block);
    for (const Table& table : tables_) {
        json.begin_object(Layout::block).member("caption", table.caption);
        json.key("rows").begin_array(Layout::block);
        for (const std::vector<Cell>& row : table.rows) {
            json.begin_object();
            for (std::size_t k = 0; k < row.size(); ++k) {
                write(json.key(table.columns[k]), row[k]);
            }
            json.end_object();
        }
        json.end_array().end_object();
    }
    json.end_array().key("notes").begin_array(Layout::block);
    for (const std::string& note : notes_) {
        json.value(note);
    }
    json.end_array().key("plots").begin_array(Layout::block);
    for (const Plot& plot : plots_) {
        json.begin_object(Layout::block).member("file", plot.file).member("title", plot.title);
        json.member("x_axis", plot.x_axis).member("y_axis", plot.y_axis);
        json.key("series").begin_array(Layout::block);
        for (const Series& series : plot.series) {
            json.begin_object().member("name", series.name);
            write(json.key("x"), series.x);
            write(json.key("y"), series.y);
            json.end_object();
        }
        json.end_array().end_object();
    }
    json.end_array().end_object();
    return json.take();
}

}  // namespace raytree::bench
