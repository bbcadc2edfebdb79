#include "formats/tree_dot.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "formats/tree_colours.h"
#include "formats/tree_diagram.h"
#include "formats/tree_title.h"
#include "formats/xml_text.h"
#include "tree/explain.h"

namespace raytree {
namespace {

using Ray = TreeRay<double>;

std::string name_of(const Ray& ray) { return "ray" + std::to_string(ray.id); }

/// An HTML-like label: the lines below each other, the first in bold.
std::string label(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) {
        if (!line.empty()) {
            const std::string escaped = xml_text(line);
            text += text.empty() ? "<B>" + escaped + "</B>" : "<BR/>" + escaped;
        }
    }
    return "<" + text + ">";
}

/// With a swatch of the ray's colour at the left.
std::string label_with_swatch(const std::vector<std::string>& lines, const std::string& swatch) {
    const std::string words = label(lines);
    return "<<TABLE BORDER=\"0\" CELLSPACING=\"4\"><TR><TD BGCOLOR=\"" + swatch +
           "\" WIDTH=\"14\"> </TD><TD>" + words.substr(1, words.size() - 2) + "</TD></TR></TABLE>>";
}

class Graph {
  public:
    explicit Graph(const RayTree<double>& tree) : tree_(tree), children_(children_of(tree)) {}

    std::string write() {
        const std::string title = "Ray tree of " + pixel_and_scene(tree_);
        text_ =
            "digraph raytree {\n"
            "  graph [fontname=\"DejaVu Sans\", labelloc=t, ordering=out, nodesep=0.25, "
            "ranksep=0.5, label=" +
            label({title}) +
            "]\n"
            "  node [shape=box, style=rounded, fontname=\"DejaVu Sans\", fontsize=10]\n"
            "  edge [fontname=\"DejaVu Sans\", fontsize=9, arrowsize=0.6]\n"
            "  eye [shape=ellipse]\n";
        if (!tree_.rays.empty()) {
            write_ray(tree_.rays.front(), "eye");
        }
        for (const Ray& ray : tree_.rays) {
            write_below(ray);
        }
        return text_ + "}\n";
    }

  private:
    /// A node and the edge that leads to it.
    void node(const std::string& from, const std::string& name, const std::string& look,
              const std::string& edge_look, const std::string& words, RayKind kind) {
        text_ += "  " + name + " [" + look + ", label=" + words + "]\n";
        text_ += "  " + from + " -> " + name + " [" + edge_look + ", label=\"" +
                 std::string(word_of(kind)) + "\"]\n";
    }

    void write_ray(const Ray& ray, const std::string& from) {
        const std::string colour = "color=\"" + std::string(look_of(ray).line) + "\"";
        const std::string frame = ray.hit ? "" : ", style=\"rounded,dashed\"";
        if (ray.shadow) {
            node(from, name_of(ray), colour + frame, colour + ", style=dashed",
                 label({ray.shadow->light, short_fate(ray)}), ray.kind);
            return;
        }
        std::vector<std::string> lines = {ray.hit ? ray.hit->object : "nothing",
                                          "I = " + triple_text(ray.intensity)};
        std::ranges::copy(notes_of(ray), std::back_inserter(lines));
        const std::string words =
            label_with_swatch(lines, swatch_colour(ray.intensity, tree_.settings.quantize));
        node(from, name_of(ray), colour + frame,
             colour + ", penwidth=" + number_text(thickness_of(ray.weight)), words, ray.kind);
    }

    /// What hangs from a ray, in the order in which it is to be drawn.
    void write_below(const Ray& ray) {
        for (const RayKind kind : {RayKind::shadow, RayKind::reflected, RayKind::refracted}) {
            for (const std::size_t child : children_[ray.id]) {
                if (tree_.rays[child].kind == kind) {
                    write_ray(tree_.rays[child], name_of(ray));
                }
            }
            for (const Skipped& skipped : ray.skipped) {
                if (skipped.kind == kind && has_frame(ray, skipped)) {
                    write_absent(ray, skipped);
                }
            }
        }
    }

    void write_absent(const Ray& ray, const Skipped& skipped) {
        const std::string look = "color=\"" + std::string(absent_look.line) + "\", fontcolor=\"" +
                                 absent_look.text + "\", style=";
        node(name_of(ray), "absent" + std::to_string(absent_++), look + "\"rounded,dotted\"",
             look + "dotted",
             label({skipped.light.empty() ? "not sent" : skipped.light + ": not sent",
                    short_reason(skipped.reason)}),
             skipped.kind);
    }

    const RayTree<double>& tree_;
    std::vector<std::vector<std::size_t>> children_;
    std::string text_;
    std::size_t absent_ = 0;
};

}  // namespace

std::string write_tree_dot(const RayTree<double>& tree) { return Graph(tree).write(); }

}  // namespace raytree
