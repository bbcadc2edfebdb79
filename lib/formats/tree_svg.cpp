#include "formats/tree_svg.h"

#include <algorithm>
#include <array>

#include "formats/svg.h"
#include "formats/tree_colours.h"
#include "formats/tree_diagram.h"
#include "formats/tree_title.h"
#include "tree/explain.h"

namespace raytree {
namespace {

using Sizes = DiagramSizes;
using Box = DiagramBox;

constexpr const char* ink = "#2B3440";
constexpr const char* faint_ink = absent_look.text;
constexpr double title_size = 15;
constexpr double page_margin = 24;
constexpr double header_height = 90;
constexpr double legend_height = 78;
constexpr double legend_width = 640;

const RayColours& look_of(LightRow::State state) {
    return state == LightRow::State::lit       ? lit_look
           : state == LightRow::State::blocked ? blocked_look
                                               : absent_look;
}

/// Every digit of a count, as long as it has them.
std::string whole_text(double count) {
    return count < 1e15 ? std::to_string(static_cast<long long>(count)) : number_text(count);
}

std::string at(double x, double y) { return svg_number(x) + " " + svg_number(y); }

class Drawing {
  public:
    explicit Drawing(const RayTree<double>& tree) : tree_(tree), diagram_(diagram_of(tree)) {}

    std::string draw() {
        const std::string title = title_text();
        const double title_width = 1.1 * text_width(title, title_size);
        const double width =
            std::max({diagram_.width, legend_width, title_width}) + 2 * page_margin;
        left_ = (width - diagram_.width) / 2;
        for (const Box& box : diagram_.boxes) {
            draw_edge(box);
        }
        for (const Box& box : diagram_.boxes) {
            draw_box(box);
        }
        draw_header(title, width / 2);
        const double legend_top = top_ + diagram_.height + 22;
        draw_legend(width / 2 - legend_width / 2, legend_top);
        return svg_.finish(width, legend_top + legend_height, title);
    }

  private:
    double left(const Box& box) const { return left_ + box.x; }
    double right(const Box& box) const { return left_ + box.x + box.card_width; }
    double middle(const Box& box) const { return left_ + box.x + box.card_width / 2; }
    double label_y(const Box& box) const { return top_ + box.y; }
    double card_y(const Box& box) const { return top_ + box.y + Sizes::label; }
    double bottom(const Box& box) const { return card_y(box) + box.card_height; }

    std::string title_text() const { return "Ray tree of " + pixel_and_scene(tree_); }

    void draw_header(const std::string& title, double centre) {
        svg_.text(centre, 24, title, {title_size, ink, true, false, "middle"});
        const TreeCounts& n = tree_.counts;
        const std::string counts = std::to_string(n.all()) + " rays: " + std::to_string(n.primary) +
                                   " primary, " + std::to_string(n.reflected) + " reflected, " +
                                   std::to_string(n.refracted) + " refracted, " +
                                   std::to_string(n.shadow) + " shadow";
        const std::string bound =
            n.full_tree > 0 ? "; a full tree has " + whole_text(n.full_tree) : "";
        svg_.text(centre, 42, counts + bound, {Sizes::font, faint_ink, false, false, "middle"});
    }

    /// From the bottom of the parent's frame to the label above the box.
    void draw_edge(const Box& box) {
        const double x = middle(box);
        if (!box.parent) {
            draw_eye(x, label_y(box) - 26);
            svg_.path("M " + at(x, label_y(box) - 17) + " V " + svg_number(label_y(box) - 1),
                      {ink, thickness_of(box.ray->weight), ""});
            return;
        }
        const Box& parent = diagram_.boxes[*box.parent];
        const double side = box.branch == RayKind::reflected ? -0.2 : 0.2;
        const double from_x = middle(parent) + side * parent.card_width;
        // What is beside the parent may reach further down than its frame.
        const double to = label_y(box);
        const double turn = std::max(bottom(parent), to - 44);
        const RayColours& look = box.absent ? absent_look : look_of(*box.ray);
        svg_.path("M " + at(from_x, bottom(parent)) + " V " + svg_number(turn) + " C " +
                      at(from_x, turn + 30) + " " + at(x, to - 30) + " " + at(x, to),
                  {look.line, box.absent ? 1.5 : thickness_of(box.ray->weight), look.dashes});
    }

    void draw_eye(double x, double y) {
        svg_.path("M " + at(x - 11, y) + " Q " + at(x, y - 12) + " " + at(x + 11, y) + " Q " +
                      at(x, y + 12) + " " + at(x - 11, y) + " Z",
                  {ink, 1.4, ""});
        svg_.circle(x, y, 3.2, ink, {});
    }

    double light_y(const Box& box, std::size_t k) const {
        return card_y(box) + box.light_row * static_cast<double>(k) + 9;
    }

    void draw_box(const Box& box) {
        svg_.begin_group(box.tooltip);
        draw_label(box);
        if (box.absent) {
            draw_absent(box);
        } else {
            draw_ray(box);
        }
        svg_.end_group();
        draw_lights(box);
    }

    /// The kind of the ray, on the end of its line.
    void draw_label(const Box& box) {
        const std::string word(word_of(box.branch));
        const double width = 1.05 * text_width(word, Sizes::font) + 6;
        svg_.rectangle(middle(box) - width / 2, label_y(box), width, Sizes::label - 3, "#FFFFFF",
                       {}, 3);
        svg_.text(middle(box), label_y(box) + 11, word,
                  {Sizes::font, box.absent ? faint_ink : look_of(*box.ray).text, false, box.absent,
                   "middle"});
    }

    void draw_ray(const Box& box) {
        const RayColours& look = look_of(*box.ray);
        const bool escaped = !box.ray->hit;
        const double x = left(box);
        svg_.rectangle(x, card_y(box), box.card_width, box.card_height,
                       escaped ? "#FFFFFF" : look.fill, {look.line, 1.5, escaped ? "4 3" : ""}, 4);
        double y = card_y(box) + Sizes::margin + 9;
        svg_.text(x + Sizes::margin, y, box.title, {Sizes::font, ink, !escaped, escaped});
        svg_.text(x + box.card_width - Sizes::margin, y, "#" + std::to_string(box.ray->id),
                  {Sizes::font, faint_ink, false, false, "end"});
        svg_.rectangle(x + Sizes::margin, y + 5, Sizes::swatch,
                       Sizes::line * static_cast<double>(box.lines.size()) - 2,
                       swatch_colour(box.ray->intensity, tree_.settings.quantize), {ink, 0.5, ""});
        for (const std::string& line : box.lines) {
            y += Sizes::line;
            svg_.text(x + Sizes::margin + Sizes::swatch + 6, y, line, {});
        }
        for (const std::string& note : box.notes) {
            y += Sizes::line;
            svg_.text(x + Sizes::margin, y, note, {Sizes::font, faint_ink, false, true});
        }
    }

    void draw_absent(const Box& box) {
        const double x = left(box);
        svg_.rectangle(x, card_y(box), box.card_width, box.card_height, "#FFFFFF",
                       {absent_look.line, 1.2, absent_look.dashes}, 4);
        double y = card_y(box) + Sizes::margin + 9;
        svg_.text(middle(box), y, box.title, {Sizes::font, faint_ink, false, false, "middle"});
        for (const std::string& line : box.lines) {
            y += Sizes::line;
            svg_.text(middle(box), y, line, {Sizes::font, faint_ink, false, true, "middle"});
        }
    }

    /// Beside the frame: from its edge a line to each light.
    void draw_lights(const Box& box) {
        if (box.lights.empty()) {
            return;
        }
        const double lamp = right(box) + Sizes::light_indent - 9;
        const double words = right(box) + Sizes::light_indent;
        svg_.text(words, label_y(box) + 11, "shadow", {Sizes::font, faint_ink});
        for (std::size_t k = box.lights.size(); k-- > 0;) {
            const LightRow& row = box.lights[k];
            const RayColours& look = look_of(row.state);
            const double y = light_y(box, k);
            svg_.begin_group(row.tooltip);
            svg_.path("M " + at(right(box) + 1, std::min(y, bottom(box) - 6)) + " h 6 V " +
                          svg_number(y) + " H " + svg_number(lamp - 5),
                      {look.line, 1.5, look.dashes});
            draw_lamp(lamp, y, row.state);
            svg_.text(words, y + 4, row.light, {Sizes::font, look.text, true});
            svg_.text(words + box.fate_x, y + 4 + box.fate_y, row.fate,
                      {Sizes::font - 1, look.text, false, true});
            svg_.end_group();
        }
    }

    /// A light as seen from the hit: full, crossed out, or not looked at.
    void draw_lamp(double x, double y, LightRow::State state) {
        const RayColours& look = look_of(state);
        const bool lit = state == LightRow::State::lit;
        svg_.circle(x, y, 4.5, lit ? "#F2D64B" : "#FFFFFF",
                    {look.line, 1.2, state == LightRow::State::absent ? look.dashes : ""});
        if (state == LightRow::State::blocked) {
            svg_.path("M " + at(x - 3, y - 3) + " L " + at(x + 3, y + 3) + " M " +
                          at(x - 3, y + 3) + " L " + at(x + 3, y - 3),
                      {look.line, 1.5, ""});
        }
    }

    void draw_legend(double x, double y) {
        svg_.path("M " + at(x, y) + " H " + svg_number(x + legend_width), {"#D5DAE0", 1, ""});
        struct Entry {
            const RayColours* look;
            double width;
            const char* text;
        };
        constexpr std::array<Entry, 6> entries = {{{&primary_look, 3.5, "primary"},
                                                   {&reflected_look, 3.5, "reflected"},
                                                   {&refracted_look, 3.5, "refracted"},
                                                   {&lit_look, 1.5, "shadow, lit"},
                                                   {&blocked_look, 1.5, "shadow, blocked"},
                                                   {&absent_look, 1.5, "not sent"}}};
        double column = x;
        for (const Entry& entry : entries) {
            svg_.path("M " + at(column, y + 18) + " h 22",
                      {entry.look->line, entry.width, entry.look->dashes});
            svg_.text(column + 27, y + 22, entry.text, {Sizes::font, entry.look->text});
            column += 27 + text_width(entry.text, Sizes::font) + 14;
        }
        svg_.text(x, y + 42,
                  "A box is what the ray hit; a hollow one: it hit nothing. The numbers are the "
                  "intensity I (red, green, blue),",
                  {Sizes::font, faint_ink});
        svg_.text(x, y + 57,
                  "the swatch its colour between 0 and 1. The thicker the line, the larger the "
                  "ray's share of the pixel.",
                  {Sizes::font, faint_ink});
    }

    const RayTree<double>& tree_;
    Diagram diagram_;
    Svg svg_;
    double left_ = 0;
    double top_ = header_height;
};

}  // namespace

std::string write_tree_svg(const RayTree<double>& tree) { return Drawing(tree).draw(); }

}  // namespace raytree
