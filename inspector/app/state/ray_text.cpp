#include "state/ray_text.h"

#include "formats/tree_json.h"
#include "state/derivation_details.h"
#include "state/details.h"
#include "state/lighting_details.h"
#include "state/marked_texts.h"
#include "state/numbers.h"

namespace raytree::inspector {
namespace {

void add(std::string& text, const DetailSection& section) {
    text += "\n" + section.title + "\n";
    for (const DetailRow& row : section.rows) {
        text += row.label;
        for (std::size_t k = 0; k < row.cells.size(); ++k) {
            text += "\t" + (k < row.values.size() ? exact(row.values[k]) : row.cells[k]);
        }
        text += "\n";
    }
    for (const std::string& sentence : section.sentences) {
        text += sentence + "\n";
    }
}

}  // namespace

std::string ray_as_text(const State& state) {
    const std::size_t ray = state.selected()->id;
    std::string text = title_of(*state.selected()) + " of pixel " + text_of(state.pixel()) + "\n";
    const PixelTree& tree = *state.tree();
    for (const DetailSection& section : known_details(tree, ray, state.playback())) {
        add(text, section);
    }
    if (!can_derive(tree, ray, state.playback())) {
        return text;
    }
    if (!state.playback() || state.playback()->stage(ray) == Stage::evaluated) {
        for (const DetailSection& section : lighting_details(*state.document(), tree, ray)) {
            add(text, section);
        }
    }
    const Derivation derivation = derive(state.document()->world(), tree.tree, ray);
    for (const DetailSection& section : derivation_details(derivation)) {
        add(text, section);
    }
    return text;
}

std::string ray_as_json(const State& state) { return write_ray_json(*state.selected()); }

}  // namespace raytree::inspector
