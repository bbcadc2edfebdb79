#include "state/contrast_lines.h"
#include "state/state.h"

/// The state's part in comparing trees.
namespace raytree::inspector {
namespace {

using What = Contrast::What;

std::string maker_of(const check::Submission& recorded) {
    return recorded.tree.generator.empty() ? "" : " by " + recorded.tree.generator;
}

}  // namespace

/// Selects the ray that corresponds to one of the tree before, which is the other one now; where
/// that is not laid over this one, a ray of the same kind in the same place.
void State::take_counterpart(std::size_t ray, const PixelTree* before) {
    keep_selected_.reset();
    if (!tree_->contrast) {
        const auto& rays = tree_->tree.rays;
        if (before && ray < rays.size() && rays[ray].kind == before->tree.rays[ray].kind) {
            selected_ = ray;
        }
        return;
    }
    const auto& counterparts = tree_->contrast->counterparts;
    for (std::size_t here = 0; here < counterparts.size(); ++here) {
        if (counterparts[here] == ray) {
            selected_ = here;
            return;
        }
    }
}

/// Says whose numbers are shown, where that is not plain.
void State::say_whose() {
    const Contrast* const contrast = tree_->contrast.get();
    if (!contrast || contrast->what == What::cut) {
        return;
    }
    std::string text;
    if (contrast->what == What::file) {
        const bool theirs = tree_->recorded != nullptr;
        text = theirs ? "The numbers shown are those of " + name_of(*tree_->recorded) +
                            maker_of(*tree_->recorded) + ", as recorded"
                      : "The numbers shown are those that raytree has traced";
        text += "; beside them " + contrast->other_name + ". ";
    } else {
        text = "Shown: " + contrast->shown_name + "; beside it: " + contrast->other_name + ". ";
    }
    const std::string notes = contrast->what == What::file && !notes_.empty() ? "  " + notes_ : "";
    message_ = text + summary_of(*contrast) + notes;
}

void State::compare_with(std::shared_ptr<const check::Submission> recorded) {
    const Pixel pixel{recorded->tree.pixel_i, recorded->tree.pixel_j};
    if (!document_->contains(pixel)) {
        throw InputError(recorded->file, "/pixel",
                         "pixel " + text_of(pixel) + " lies outside the scene's picture");
    }
    const bool has_one = against_ && against_->what == What::file && against_->pixel == pixel_;
    auto reference = has_one && pixel == pixel_ ? against_->subject : nullptr;
    against_ = Against{What::file, pixel, std::move(reference), std::move(recorded), false};
    if (pixel != pixel_) {
        history_.add(pixel, Pick::apart);
        pixel_ = pixel;
    }
    keep_selected_.reset();
    side_pane_ = SidePane::compare;
    trace_again();
    tell({.side_pane = true});
}

void State::compare_with_pixel(Pixel pixel) {
    if (!document_->contains(pixel)) {
        throw InputError("", "", "pixel " + text_of(pixel) + " lies outside the picture");
    }
    against_ = Against{What::pixel, pixel, nullptr, nullptr, false};
    side_pane_ = SidePane::compare;
    keep_selected_.reset();
    trace_again();
    tell({.side_pane = true});
}

std::optional<Pixel> State::compared_pixel() const {
    return against_ && against_->what == What::pixel ? std::optional(against_->pixel)
                                                     : std::nullopt;
}

void State::compare_with_before() {
    against_ = Against{What::change, pixel_, nullptr, nullptr, false};
    side_pane_ = SidePane::compare;
    keep_selected_.reset();
    trace_again();
    tell({.side_pane = true});
}

void State::go_to_difference(std::size_t line) {
    difference_ = line;
    select(tree_->contrast->lines[line].ray);
}

void State::swap_compared() {
    const auto there = tree_ && !tree_->is_own(selected_) ? tree_->contrast->counterparts[selected_]
                                                          : std::nullopt;
    keep_selected_ = there ? std::nullopt : std::optional(selected_);
    against_->swapped = !against_->swapped;
    trace_again();
    if (there) {
        select(*there);
    }
}

void State::end_comparing() {
    against_.reset();
    before_.reset();
    keep_selected_.reset();
    trace_again();
}

}  // namespace raytree::inspector
