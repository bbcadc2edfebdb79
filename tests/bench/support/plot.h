#pragma once

#include <string>
#include <vector>

namespace raytree::bench {

/// A plot of several series over logarithmic axes, as SVG.
class Plot {
  public:
    Plot(std::string title, std::string x_axis, std::string y_axis)
        : title_(std::move(title)), x_axis_(std::move(x_axis)), y_axis_(std::move(y_axis)) {}

    /// Points that are not positive are left out: they have no place on these axes.
    void add(const std::string& name, const std::vector<double>& x, const std::vector<double>& y);
    std::string svg() const;

  private:
    struct Series {
        std::string name;
        std::vector<double> x, y;
    };
    std::string title_, x_axis_, y_axis_;
    std::vector<Series> series_;
};

}  // namespace raytree::bench
