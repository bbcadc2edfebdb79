#pragma once

#include <string>
#include <string_view>

namespace raytree {

/// A length or coordinate for SVG, to a tenth of a unit.
std::string svg_number(double value);

/// About how wide `text` is in a sans-serif font of this size; rather more than less.
double text_width(std::string_view text, double size);

/// `text`, or as much of its beginning as fits, with an ellipsis.
std::string fitted_text(std::string_view text, double size, double width);

/// Draws an SVG picture from back to front. Units are those of CSS; y points down.
class Svg {
  public:
    struct Stroke {
        std::string colour;
        double width = 1;
        std::string dashes;  ///< as of stroke-dasharray; empty: solid
    };
    struct Font {
        double size = 11;
        std::string colour = "#2B3440";
        bool bold = false;
        bool italic = false;
        std::string anchor = "start";  ///< or middle, end
    };

    void rectangle(double x, double y, double width, double height, const std::string& fill,
                   const Stroke& stroke, double radius = 0);
    void circle(double x, double y, double radius, const std::string& fill, const Stroke& stroke);
    /// `data` as in the attribute `d` of a path.
    void path(const std::string& data, const Stroke& stroke);
    void text(double x, double y, std::string_view words, const Font& font);
    /// What a viewer shows while the pointer is over the elements up to `end_group`.
    void begin_group(std::string_view tooltip);
    void end_group();

    /// The whole picture on white ground.
    std::string finish(double width, double height, std::string_view title) const;

  private:
    std::string body_;
};

}  // namespace raytree
