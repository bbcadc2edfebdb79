#include "state/marked_texts.h"

#include <algorithm>

#include "state/bounds_details.h"
#include "state/contrast_lines.h"
#include "tree/explain.h"

namespace raytree::inspector {
namespace {

constexpr const char* pending = "…";

Stage stage_of(const std::optional<Playback>& playback, std::size_t ray) {
    return playback ? playback->stage(ray) : Stage::evaluated;
}

/// Takes out what has not happened yet.
void veil(OutlineTexts& texts, Stage stage) {
    if (stage != Stage::evaluated) {
        texts.intensity = pending;
        texts.ended.clear();
    }
    if (stage == Stage::sent) {
        texts.met = pending;
        texts.t.clear();
    }
}

/// The same of details: what is met, and with which intensity.
void veil(DetailSection& section, Stage stage) {
    static constexpr std::array<std::string_view, 6> of_intensity = {
        "ambient", "diffuse", "specular", "intensity", "weight·f·I", "termination"};
    static constexpr std::array<std::string_view, 7> at_once = {
        "its name", "origin", "direction", "weight", "light", "level", "sent from"};
    const auto is_in = [](const auto& names, const DetailRow& row) {
        return std::ranges::find(names, row.label) != names.end();
    };
    std::erase_if(section.rows, [&](const DetailRow& row) {
        const bool is_heading = row.label.empty();
        return (stage != Stage::evaluated && is_in(of_intensity, row)) ||
               (stage == Stage::sent && !is_heading && !is_in(at_once, row));
    });
}

/// Takes out what a file does not give.
void blank(OutlineTexts& texts, const PixelTree& tree, std::size_t ray) {
    if (!tree.gives_intensity(ray)) {
        texts.intensity = "not given";
    }
    const bool tells_end = tree.tree.rays[ray].shadow
                               ? tree.gives(ray, Field::blocked_by) ||
                                     tree.gives(ray, Field::transmittance) ||
                                     tree.gives_intensity(ray)
                               : tree.gives(ray, Field::hit) || tree.gives(ray, Field::object);
    if (!tells_end) {
        texts.met = "not given";
    }
}

}  // namespace

Outline::Shown happened_rows(const std::optional<Playback>& playback) {
    if (!playback) {
        return nullptr;
    }
    return [steps = *playback](const OutlineRow& row) {
        return row.skipped ? steps.decided(row.ray, *row.skipped)
                           : steps.stage(row.ray) != Stage::unsent;
    };
}

OutlineTexts marked_texts_of(const PixelTree& tree, const OutlineRow& row,
                             const std::optional<Playback>& playback) {
    OutlineTexts texts = texts_of(tree, row);
    if (row.skipped) {
        return texts;
    }
    blank(texts, tree, row.ray);
    veil(texts, stage_of(playback, row.ray));
    if (in_doubt(tree, row.ray)) {
        texts.ray += "   ≈ in doubt";
    }
    const std::string mark = mark_text(tree.mark(row.ray));
    if (!mark.empty()) {
        texts.ray += "   " + mark;
    }
    return texts;
}

std::string marked_title_of(const PixelTree& tree, std::size_t ray) {
    const TreeRay<double>& one = tree.tree.rays[ray];
    const std::string mark = mark_text(tree.mark(ray));
    std::string title = title_of(one);
    if (!tree.is_own(ray)) {
        title.replace(0, title.find(' '), number_of(tree, ray));
    }
    return mark.empty() ? title : title + "   " + mark;
}

std::vector<DetailSection> known_details(const PixelTree& tree, std::size_t ray,
                                         const std::optional<Playback>& playback) {
    std::vector<DetailSection> sections;
    const Stage stage = stage_of(playback, ray);
    const bool graft = !tree.is_own(ray);
    if (stage != Stage::evaluated && !graft) {
        DetailSection waiting{"Step by step", {}, {}};
        for (const CallText& call : call_texts(*playback)) {
            if (call.ray == ray) {
                waiting.sentences.push_back("… Its intensity is not known yet: it waits for " +
                                            call.waits_for + ".");
                if (!call.sum.empty()) {
                    waiting.sentences.push_back("What has come in so far: " + call.sum + ".");
                }
            }
        }
        sections.push_back(std::move(waiting));
    }
    if (tree.contrast && (stage == Stage::evaluated || graft)) {
        for (DetailSection& section : contrast_details(tree, ray)) {
            sections.push_back(std::move(section));
        }
    }
    if (tree.recorded && !graft) {
        sections.push_back(recorded_details(tree, ray));
        veil(sections.back(), stage);
        return sections;
    }
    static constexpr std::array<std::string_view, 3> known_at_once = {"Ray", "Share of the pixel",
                                                                      "Light"};
    static constexpr std::array<std::string_view, 2> known_last = {"Intensity", "Where it ends"};
    for (DetailSection& section : details_of(tree, ray)) {
        const bool at_once = std::ranges::find(known_at_once, section.title) != known_at_once.end();
        const bool last = std::ranges::find(known_last, section.title) != known_last.end();
        const bool shadow_pending =
            tree.tree.rays[ray].shadow.has_value() && section.title != "Ray";
        if (graft || stage == Stage::evaluated ||
            (stage == Stage::found && !last && !shadow_pending) ||
            (stage == Stage::sent && at_once && !shadow_pending)) {
            if (!graft) {
                veil(section, stage);
            }
            sections.push_back(std::move(section));
        }
    }
    if (!graft) {
        add_bounds(sections, tree, ray);
    }
    return sections;
}

bool is_found(const std::optional<Playback>& playback, std::size_t ray) {
    const Stage stage = stage_of(playback, ray);
    return stage != Stage::unsent && stage != Stage::sent;
}

bool can_derive(const PixelTree& tree, std::size_t ray, const std::optional<Playback>& playback) {
    return tree.is_own(ray) && !tree.recorded && is_found(playback, ray);
}

}  // namespace raytree::inspector
