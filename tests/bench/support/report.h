#pragma once

#include <string>
#include <variant>
#include <vector>

#include "support/bench.h"

/// What a benchmark says: tables on standard output while it runs, and at its end NAME.json and
/// the plots NAME-*.svg in the folder, which plot.py draws from it.
namespace raytree::bench {

/// A cell: words, or a number with the digits to show.
struct Cell {
    Cell(std::string words) : text(std::move(words)) {}
    Cell(const char* words) : text(words) {}
    Cell(double number, int digits = 2) : value(number), places(digits), is_number(true) {}

    std::string text;
    double value = 0;
    int places = 2;  ///< after the point; negative: significant digits
    bool is_number = false;
    std::string shown() const;
};

class Report {
  public:
    Report(const Options& options, const std::string& title);

    /// Starts a table; the rows that follow are its.
    void table(const std::string& caption, const std::vector<std::string>& columns);
    /// One cell for each column.
    void row(const std::vector<Cell>& cells);
    /// A sentence under the tables so far.
    void note(const std::string& text);

    struct Series {
        std::string name;
        std::vector<double> x, y;
    };
    /// A plot with logarithmic axes, NAME-FILE.svg. Points that are not positive are left out.
    void plot(const std::string& file, const std::string& title, const std::string& x_axis,
              const std::string& y_axis, const std::vector<Series>& series);

    /// Writes NAME.json and has the plots drawn. Nothing follows.
    void finish();

  private:
    struct Table {
        std::string caption;
        std::vector<std::string> columns;
        std::vector<std::vector<Cell>> rows;
        std::vector<std::size_t> widths;
    };

    struct Plot {
        std::string file, title, x_axis, y_axis;
        std::vector<Series> series;
    };

    std::string json() const;
    std::string file_name(const std::string& rest) const;

    Options options_;
    std::string title_;
    std::vector<Table> tables_;
    std::vector<std::string> notes_;
    std::vector<Plot> plots_;
};

}  // namespace raytree::bench
