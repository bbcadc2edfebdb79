#include "formats/tree_diagram.h"

#include <algorithm>
#include <map>

#include "formats/svg.h"
#include "tree/eight_bit.h"
#include "tree/explain.h"

namespace raytree {
namespace {

using Sizes = DiagramSizes;
using Box = DiagramBox;
using Ray = TreeRay<double>;

constexpr double widest_text = 170;
constexpr LayoutGaps gaps{16, 40};
constexpr std::size_t most_high_rows = 5, most_alike = 3;  // lights beside a frame

double width_of(const std::string& text) { return text_width(text, Sizes::font); }

/// Breaks a reason's words into lines that are about as long as each other.
std::vector<std::string> broken(const std::string& text) {
    std::vector<std::string> lines;
    std::string_view rest = text;
    while (!rest.empty()) {
        const std::size_t blank = rest.find(' ', 11);
        lines.emplace_back(rest.substr(0, blank));
        rest = blank == std::string_view::npos ? "" : rest.substr(blank + 1);
    }
    return lines;
}

/// Whether it is the surface that has no such branch.
bool is_lacking(Reason reason) {
    return reason == Reason::not_reflective || reason == Reason::not_transmissive;
}

class DiagramMaker {
  public:
    DiagramMaker(const RayTree<double>& tree, double fold_below)
        : tree_(tree), fold_below_(fold_below), children_(children_of(tree)) {}

    Diagram make() {
        if (!tree_.rays.empty()) {
            add_ray(tree_.rays.front(), std::nullopt);
        }
        place();
        return std::move(diagram_);
    }

  private:
    /// A box for the ray, then those of what hangs from it, in the order in which they are drawn.
    void add_ray(const Ray& ray, std::optional<std::size_t> parent) {
        const std::size_t own = diagram_.boxes.size();
        diagram_.boxes.push_back(ray_box(ray, parent));
        for (const RayKind kind : {RayKind::reflected, RayKind::refracted}) {
            for (const std::size_t child : children_[ray.id]) {
                if (tree_.rays[child].kind == kind) {
                    add_branch(tree_.rays[child], own);
                }
            }
            for (const Skipped& skipped : ray.skipped) {
                if (skipped.kind == kind && has_frame(ray, skipped)) {
                    diagram_.boxes.push_back(absent_box(ray, skipped, own));
                }
            }
        }
    }

    void add_branch(const Ray& ray, std::size_t parent) {
        if (largest_component(ray.weight) < fold_below_) {
            diagram_.boxes.push_back(folded_box(ray, parent));
        } else {
            add_ray(ray, parent);
        }
    }

    Box ray_box(const Ray& ray, std::optional<std::size_t> parent) const {
        Box box;
        box.parent = parent;
        box.ray = &ray;
        box.branch = ray.kind;
        const std::string hit = ray.hit ? ray.hit->object : "nothing";
        box.title = fitted_text(hit, Sizes::font, widest_text);
        box.lines = intensity_lines(ray);
        box.notes = notes_of(ray);
        box.tooltip =
            "#" + std::to_string(ray.id) + " " + std::string(word_of(ray.kind)) + " ray: " +
            (ray.hit ? "hits " + hit + " at t = " + number_text(ray.hit->t) : "hits nothing");
        box.tooltip += "\nI = " + triple_text(ray.intensity) +
                       "\nshare of the pixel: " + triple_text(ray.weight);
        if (ray.attenuation != 1) {
            box.tooltip += ", f = " + number_text(ray.attenuation);
        }
        box.tooltip += ray.termination ? "\n" + ended_text(tree_, ray) : "";
        double text = 1.08 * width_of(box.title) + 12 + width_of("#" + std::to_string(ray.id));
        for (const std::string& line : box.lines) {
            text = std::max(text, Sizes::swatch + 6 + width_of(line));
        }
        for (const std::string& note : box.notes) {
            text = std::max(text, width_of(note));
        }
        frame(box, text);
        add_lights(box, ray);
        return box;
    }

    /// Makes the frame large enough for its text, and as wide as the label above it.
    static void frame(Box& box, double text) {
        const double label = 1.05 * width_of(std::string(word_of(box.branch))) + 10;
        box.card_width = std::max(label, text + 2 * Sizes::margin);
        box.card_height =
            2 * Sizes::margin - 2 +
            Sizes::line * static_cast<double>(1 + box.lines.size() + box.notes.size());
    }

    /// One line where the channels are equal. What the swatch cannot show is marked.
    std::vector<std::string> intensity_lines(const Ray& ray) const {
        const EightBit shown = eight_bit(ray.intensity, tree_.settings.quantize);
        std::vector<std::string> lines;
        for (std::size_t c = 0; c < 3; ++c) {
            const double value = channels(ray.intensity)[c];
            lines.push_back(number_text(value) + (!shown.clamped[c] ? ""
                                                  : value > 1       ? " > 1"
                                                                    : " < 0"));
        }
        if (lines[0] == lines[1] && lines[1] == lines[2]) {
            lines.resize(1);
        }
        return lines;
    }

    void add_lights(Box& box, const Ray& ray) const {
        for (const std::size_t child : children_[ray.id]) {
            if (tree_.rays[child].shadow) {
                box.lights.push_back(sent_row(tree_.rays[child]));
            }
        }
        add_absent_lights(box, ray);
        double name = 0, fate = 0;
        for (LightRow& row : box.lights) {
            row.light = fitted_text(row.light, Sizes::font, widest_text);
            row.fate = fitted_text(row.fate, Sizes::font, widest_text);
            name = std::max(name, 1.08 * width_of(row.light));
            fate = std::max(fate, width_of(row.fate));
        }
        if (box.lights.size() > most_high_rows) {
            constexpr double gap = 18;  // a sign may stand before the name
            box.light_row = Sizes::light_line;
            box.fate_x = name + gap;
            box.fate_y = 0;
        }
        if (!box.lights.empty()) {
            box.lights_width = Sizes::light_indent + std::max(name, box.fate_x + fate);
        }
    }

    /// A row for each light that was not asked, or one for many that were not for one reason.
    void add_absent_lights(Box& box, const Ray& ray) const {
        std::map<Reason, std::size_t> counts;
        for (const Skipped& skipped : ray.skipped) {
            counts[skipped.reason] += skipped.kind == RayKind::shadow ? 1 : 0;
        }
        std::map<Reason, std::size_t> rows;  // of those that stand together
        for (std::size_t k = 0; k < ray.skipped.size(); ++k) {
            const Skipped& skipped = ray.skipped[k];
            if (skipped.kind != RayKind::shadow) {
                continue;
            }
            const std::string why =
                "no shadow ray to " + skipped.light + ": " + skipped_text(tree_, ray, skipped);
            const std::size_t together = counts[skipped.reason];
            const auto [row, first] = rows.try_emplace(skipped.reason, box.lights.size());
            if (together <= most_alike || first) {
                box.lights.push_back({LightRow::State::absent, skipped.light,
                                      short_reason(skipped.reason), why, std::nullopt, k});
            } else {
                LightRow& shared = box.lights[row->second];
                shared.light = std::to_string(together) + " lights";
                shared.tooltip += "\n" + why;
                shared.skipped = k;
            }
        }
    }

    static LightRow sent_row(const Ray& ray) {
        const ShadowPart<double>& shadow = *ray.shadow;
        LightRow row;
        row.light = shadow.light;
        row.ray = ray.id;
        row.state = reaches_light(ray) ? LightRow::State::lit : LightRow::State::blocked;
        row.fate = short_fate(ray);
        row.tooltip = "#" + std::to_string(ray.id) + " shadow ray to " + shadow.light + " " +
                      shadow_text(ray) + "\nadds diffuse " + triple_text(ray.diffuse) +
                      " + specular " + triple_text(ray.specular);
        return row;
    }

    Box absent_box(const Ray& ray, const Skipped& skipped, std::size_t parent) const {
        Box box;
        box.absent = true;
        box.parent = parent;
        box.ray = &ray;
        box.branch = skipped.kind;
        box.title = "not sent";
        box.lines = broken(short_reason(skipped.reason));
        box.tooltip = "no " + std::string(word_of(skipped.kind)) +
                      " ray: " + skipped_text(tree_, ray, skipped);
        frame_words(box);
        return box;
    }

    /// How many rays a branch has, its first one included.
    std::size_t rays_of(std::size_t branch) const {
        std::size_t count = 1;
        for (const std::size_t child : children_[branch]) {
            count += rays_of(child);
        }
        return count;
    }

    Box folded_box(const Ray& ray, std::size_t parent) const {
        Box box;
        box.folded = rays_of(ray.id);
        box.parent = parent;
        box.ray = &ray;
        box.branch = ray.kind;
        box.title = "folded";
        box.lines = {std::to_string(box.folded) + (box.folded == 1 ? " ray" : " rays")};
        box.tooltip = "#" + std::to_string(ray.id) + " " + std::string(word_of(ray.kind)) +
                      " ray and what hangs from it: " + box.lines.front() +
                      "\nshare of the pixel: " + triple_text(ray.weight);
        frame_words(box);
        return box;
    }

    static void frame_words(Box& box) {
        double text = width_of(box.title);
        for (const std::string& line : box.lines) {
            text = std::max(text, width_of(line));
        }
        frame(box, text);
    }

    void place() {
        std::vector<LayoutNode> nodes;
        for (const Box& box : diagram_.boxes) {
            const double lights = box.light_row * static_cast<double>(box.lights.size());
            nodes.push_back({box.parent, box.card_width + box.lights_width,
                             Sizes::label + std::max(box.card_height, lights)});
        }
        const TreeLayout layout = lay_out(nodes, gaps);
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            diagram_.boxes[k].x = layout.places[k].middle - nodes[k].breadth / 2;
            diagram_.boxes[k].y = layout.places[k].start;
        }
        diagram_.width = layout.breadth;
        diagram_.height = layout.depth;
    }

    const RayTree<double>& tree_;
    double fold_below_;
    std::vector<std::vector<std::size_t>> children_;
    Diagram diagram_;
};

}  // namespace

Diagram diagram_of(const RayTree<double>& tree, double fold_below) {
    return DiagramMaker(tree, fold_below).make();
}

std::string short_fate(const TreeRay<double>& shadow_ray) {
    const ShadowPart<double>& shadow = *shadow_ray.shadow;
    if (shadow.blocked_by) {
        return "blocked: " + shadow.blocked_by->object;
    }
    if (!reaches_light(shadow_ray)) {
        return "blocked";
    }
    return shadow.transmittance == Rgb<double>(1) ? "reaches it" : "reaches it, dimmed";
}

std::vector<std::string> notes_of(const TreeRay<double>& ray) {
    std::vector<std::string> notes;
    if (ray.termination) {
        notes.push_back(short_reason(*ray.termination));
    }
    for (const Skipped& skipped : ray.skipped) {
        if (is_lacking(skipped.reason) && !told_by_termination(ray, skipped)) {
            notes.push_back(short_reason(skipped.reason));
        }
    }
    return notes;
}

bool has_frame(const TreeRay<double>& ray, const Skipped& branch) {
    return !is_lacking(branch.reason) && !told_by_termination(ray, branch);
}

std::string short_reason(Reason reason) {
    std::string text(word_of(reason));
    std::ranges::replace(text, '_', ' ');
    return text;
}

}  // namespace raytree
