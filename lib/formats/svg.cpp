#include "formats/svg.h"

#include <array>
#include <charconv>

#include "formats/xml_text.h"

namespace raytree {
namespace {

constexpr std::string_view family = "DejaVu Sans, Verdana, Helvetica, Arial, sans-serif";

/// The advance of a character in DejaVu Sans, the widest of the fonts above, by its first byte.
double advance(unsigned char c) {
    constexpr std::string_view narrow = " .,:;'|!ijlI()[]-tfr/";
    constexpr std::string_view wide = "mwMW%@";
    if (c >= 0xE0) {
        return 1.0;
    }
    if (c < 0x80 && narrow.find(static_cast<char>(c)) != std::string_view::npos) {
        return 0.41;
    }
    if (c < 0x80 && wide.find(static_cast<char>(c)) != std::string_view::npos) {
        return 1.0;
    }
    return c >= 'A' && c <= 'Z' ? 0.78 : 0.64;
}

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

std::string attribute(std::string_view name, std::string_view value) {
    return " " + std::string(name) + "=\"" + std::string(value) + "\"";
}
std::string attribute(std::string_view name, double value) {
    return attribute(name, svg_number(value));
}

std::string stroke_attributes(const Svg::Stroke& stroke) {
    if (stroke.colour.empty()) {
        return "";
    }
    return attribute("stroke", stroke.colour) + attribute("stroke-width", stroke.width) +
           (stroke.dashes.empty() ? "" : attribute("stroke-dasharray", stroke.dashes));
}

}  // namespace

std::string svg_number(double value) {
    std::array<char, 64> buffer;
    const auto end =
        std::to_chars(buffer.begin(), buffer.end(), value, std::chars_format::fixed, 1).ptr;
    std::string text(buffer.data(), end);
    if (text.ends_with(".0")) {
        text.resize(text.size() - 2);
    }
    return text == "-0" ? "0" : text;
}

double text_width(std::string_view text, double size) {
    double width = 0;
    for (const char c : text) {
        width += continues_character(c) ? 0 : advance(static_cast<unsigned char>(c));
    }
    return width * size;
}

std::string fitted_text(std::string_view text, double size, double width) {
    if (text_width(text, size) <= width) {
        return std::string(text);
    }
    const double room = width - text_width("…", size);
    std::size_t end = 0;
    for (std::size_t next = 1; next <= text.size(); ++next) {
        if (next < text.size() && continues_character(text[next])) {
            continue;
        }
        if (text_width(text.substr(0, next), size) > room) {
            break;
        }
        end = next;
    }
    return std::string(text.substr(0, end)) + "…";
}

void Svg::rectangle(double x, double y, double width, double height, const std::string& fill,
                    const Stroke& stroke, double radius) {
    body_ += "<rect" + attribute("x", x) + attribute("y", y) + attribute("width", width) +
             attribute("height", height) + (radius > 0 ? attribute("rx", radius) : "") +
             attribute("fill", fill) + stroke_attributes(stroke) + "/>\n";
}

void Svg::circle(double x, double y, double radius, const std::string& fill, const Stroke& stroke) {
    body_ += "<circle" + attribute("cx", x) + attribute("cy", y) + attribute("r", radius) +
             attribute("fill", fill) + stroke_attributes(stroke) + "/>\n";
}

void Svg::path(const std::string& data, const Stroke& stroke) {
    body_ += "<path" + attribute("d", data) + attribute("fill", "none") +
             stroke_attributes(stroke) + "/>\n";
}

void Svg::text(double x, double y, std::string_view words, const Font& font) {
    body_ += "<text" + attribute("x", x) + attribute("y", y) + attribute("font-size", font.size) +
             attribute("fill", font.colour) +
             (font.anchor == "start" ? "" : attribute("text-anchor", font.anchor)) +
             (font.bold ? attribute("font-weight", "bold") : "") +
             (font.italic ? attribute("font-style", "italic") : "") + ">" + xml_text(words) +
             "</text>\n";
}

void Svg::begin_group(std::string_view tooltip) {
    body_ += "<g><title>" + xml_text(tooltip) + "</title>\n";
}

void Svg::end_group() { body_ += "</g>\n"; }

std::string Svg::finish(double width, double height, std::string_view title) const {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
           "<svg xmlns=\"http://www.w3.org/2000/svg\"" +
           attribute("width", width) + attribute("height", height) +
           attribute("viewBox", "0 0 " + svg_number(width) + " " + svg_number(height)) +
           attribute("font-family", family) + ">\n<title>" + xml_text(title) +
           "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#FFFFFF\"/>\n" + body_ +
           "</svg>\n";
}

}  // namespace raytree
