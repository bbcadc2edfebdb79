#include "support/plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "formats/svg.h"

namespace raytree::bench {
namespace {

constexpr double width = 720, height = 440;
constexpr double left = 80, right = 530, top = 50, bottom = 380;
constexpr std::array colours = {"#0B84C6", "#E07B00", "#9B2226", "#2E7D32",
                                "#6A4C93", "#B59A1E", "#2B3440", "#D6336C"};

/// Whole decades around the numbers, and where a number lies among them.
struct Axis {
    double low = 1e300, high = -1e300;

    void include(double value) {
        low = std::min(low, std::floor(std::log10(value)));
        high = std::max(high, std::ceil(std::log10(value)));
    }
    double place(double value, double begin, double end) const {
        const double span = std::max(high - low, 1.0);
        return begin + (std::log10(value) - low) / span * (end - begin);
    }
};

std::string power(double exponent) {
    const int n = static_cast<int>(exponent);
    static constexpr std::array small = {"0.001", "0.01", "0.1", "1", "10", "100", "1000"};
    return n >= -3 && n <= 3 ? small[static_cast<std::size_t>(n + 3)] : "1e" + std::to_string(n);
}

void draw_axes(Svg& svg, const Axis& x, const Axis& y) {
    const Svg::Stroke line{"#D0D4D9", 1, ""};
    for (double e = x.low; e <= std::max(x.high, x.low + 1); ++e) {
        const double at = x.place(std::pow(10, e), left, right);
        svg.path('M' + svg_number(at) + ' ' + svg_number(top) + 'V' + svg_number(bottom), line);
        svg.text(at, bottom + 18, power(e), {11, "#2B3440", false, false, "middle"});
    }
    for (double e = y.low; e <= std::max(y.high, y.low + 1); ++e) {
        const double at = y.place(std::pow(10, e), bottom, top);
        svg.path('M' + svg_number(left) + ' ' + svg_number(at) + 'H' + svg_number(right), line);
        svg.text(left - 8, at + 4, power(e), {11, "#2B3440", false, false, "end"});
    }
}

}  // namespace

void Plot::add(const std::string& name, const std::vector<double>& x,
               const std::vector<double>& y) {
    Series series{name, {}, {}};
    for (std::size_t k = 0; k < std::min(x.size(), y.size()); ++k) {
        if (x[k] > 0 && y[k] > 0 && std::isfinite(x[k]) && std::isfinite(y[k])) {
            series.x.push_back(x[k]);
            series.y.push_back(y[k]);
        }
    }
    if (!series.x.empty()) {
        series_.push_back(std::move(series));
    }
}

std::string Plot::svg() const {
    Axis x, y;
    for (const Series& series : series_) {
        std::for_each(series.x.begin(), series.x.end(), [&](double v) { x.include(v); });
        std::for_each(series.y.begin(), series.y.end(), [&](double v) { y.include(v); });
    }
    Svg svg;
    svg.text(left, 26, title_, {15, "#2B3440", true, false, "start"});
    svg.text((left + right) / 2, bottom + 42, x_axis_, {12, "#2B3440", false, false, "middle"});
    svg.text(left, top - 8, y_axis_, {12, "#2B3440", false, false, "start"});
    if (!series_.empty()) {
        draw_axes(svg, x, y);
    }
    for (std::size_t k = 0; k < series_.size(); ++k) {
        const Series& series = series_[k];
        const std::string colour = colours[k % colours.size()];
        std::string path;
        for (std::size_t i = 0; i < series.x.size(); ++i) {
            const double px = x.place(series.x[i], left, right);
            const double py = y.place(series.y[i], bottom, top);
            path += (i == 0 ? 'M' : 'L') + svg_number(px) + ' ' + svg_number(py);
            svg.circle(px, py, 3, colour, {colour, 1, ""});
        }
        const std::string dashes = k < colours.size() ? "" : "5 3";
        svg.path(path, {colour, 2, dashes});
        const double at = top + 10 + 18 * static_cast<double>(k);
        svg.path('M' + svg_number(right + 14) + ' ' + svg_number(at) + "h18", {colour, 2, dashes});
        svg.text(right + 38, at + 4, fitted_text(series.name, 11, width - right - 44), {});
    }
    return svg.finish(width, height, title_);
}

}  // namespace raytree::bench
