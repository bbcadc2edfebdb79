#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tree/layout.h"
#include "tree/ray_tree.h"

namespace raytree {

/// What is drawn of one shadow ray, sent or not, or of several that were not sent for one reason.
struct LightRow {
    enum class State { lit, blocked, absent };
    State state = State::absent;
    std::string light;    ///< "key", "12 lights"
    std::string fate;     ///< "reaches it", "ball in between", or the reason in a few words
    std::string tooltip;  ///< the whole sentence
    std::optional<std::size_t> ray;      ///< of one that was sent
    std::optional<std::size_t> skipped;  ///< of others: the last one in the ray's `skipped`
};

/// Sizes that the drawing shares with the layout, in CSS pixels.
struct DiagramSizes {
    static constexpr double font = 11;
    static constexpr double line = 14;
    static constexpr double label = 17;  ///< above each frame: the kind of its ray
    static constexpr double margin = 7;  ///< inside a frame
    static constexpr double swatch = 13;
    static constexpr double light_row = 29;     ///< with what became of it below
    static constexpr double light_line = 15;    ///< with that beside it
    static constexpr double light_indent = 30;  ///< from the frame to a light's name
};

/// A box of the diagram: a ray with what it hit and the shadow rays from there, a ray that was not
/// sent, or a branch that is folded.
struct DiagramBox {
    bool absent = false;
    std::size_t folded = 0;             ///< of a folded branch: its rays
    std::optional<std::size_t> parent;  ///< an earlier box
    const TreeRay<double>* ray =
        nullptr;  ///< of one that was not sent, the ray that hit; of a folded branch, its first
    RayKind branch = RayKind::primary;  ///< what kind of ray leads here
    std::string title;                  ///< what was hit
    std::vector<std::string> lines;     ///< its intensity; of one not sent, the reason
    std::vector<std::string> notes;     ///< of a ray, as of `notes_of`
    std::string tooltip;
    std::vector<LightRow> lights;
    double x = 0, y = 0;                         ///< of the whole, in CSS pixels, y down
    double card_width = 0;                       ///< of the frame, which stands at the left
    double card_height = 0;                      ///< without the label above it
    double lights_width = 0;                     ///< beside the frame
    double light_row = DiagramSizes::light_row;  ///< how high each light's row is
    /// From the beginning of a light's name to that of its fate: below it, or of many beside it.
    double fate_x = 0, fate_y = 12;
};

struct Diagram {
    std::vector<DiagramBox> boxes;  ///< placed; the first is the primary ray's
    double width = 0;
    double height = 0;
};

/// Branches whose share of the pixel is below `fold_below` in every channel are one box each.
Diagram diagram_of(const RayTree<double>& tree, double fold_below = 0);

/// What became of a shadow ray in two or three words: "reaches it", "blocked: ball".
std::string short_fate(const TreeRay<double>& shadow_ray);

/// What stands inside the frame of a ray, each in a few words: why it ended, and which branch its
/// surface does not have.
std::vector<std::string> notes_of(const TreeRay<double>& ray);

/// Whether a branch that was not sent has a frame of its own: not where the notes say it all.
bool has_frame(const TreeRay<double>& ray, const Skipped& branch);

/// A reason in two or three words: its word in the format, with blanks.
std::string short_reason(Reason reason);

}  // namespace raytree
