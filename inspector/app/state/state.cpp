#include "state/state.h"

#include <algorithm>

#include "state/start_pixel.h"
#include "tree/explain.h"
#include "tree/record.h"

namespace raytree::inspector {

const TreeRay<double>* State::selected() const {
    return tree_ ? &tree_->tree.rays[selected_] : nullptr;
}

void State::show(const Opened& opened) {
    document_ = opened.document;
    pixel_ = opened.pixel ? *opened.pixel : start_pixel(*document_);
    message_.clear();
    for (const std::string& note : opened.notes) {
        message_ += (message_.empty() ? "" : "  ") + note;
    }
    trace();
    tell({.document = true, .tree = true, .selection = true, .message = true});
}

void State::pick(Pixel pixel) {
    if (!document_) {
        return;
    }
    const Camera& camera = document_->scene().camera;
    pixel = {std::clamp(pixel.i, 0, camera.width - 1), std::clamp(pixel.j, 0, camera.height - 1)};
    if (pixel == pixel_ && tree_) {
        return;
    }
    pixel_ = pixel;
    message_.clear();
    trace();
    tell({.tree = true, .selection = true, .message = true});
}

void State::trace() {
    tree_.reset();
    selected_ = 0;
    try {
        auto traced = std::make_shared<PixelTree>();
        traced->tree = record_tree(document_->world(), pixel_.i, pixel_.j);
        traced->tree.scene_sha256 = document_->loaded().sha256;
        traced->children = children_of(traced->tree);
        tree_ = std::move(traced);
    } catch (const InputError& error) {
        message_ = error.what();
    }
}

void State::select(std::size_t ray) {
    if (tree_ && ray < tree_->tree.rays.size() && ray != selected_) {
        selected_ = ray;
        tell({.selection = true});
    }
}

void State::change_look(const std::function<void(Look&)>& change) {
    change(look_);
    tell({.look = true});
}

void State::request(Request request) { tell({.request = request}); }

void State::say(std::string message) {
    message_ = std::move(message);
    tell({.message = true});
}

void State::tell(const Changes& changes) const {
    for (const Observer& observer : observers_) {
        observer(changes);
    }
}

std::optional<std::size_t> parent_of(const PixelTree& tree, std::size_t ray) {
    return tree.tree.rays[ray].parent;
}

std::optional<std::size_t> first_child_of(const PixelTree& tree, std::size_t ray) {
    const auto& children = tree.children[ray];
    return children.empty() ? std::nullopt : std::optional(children.front());
}

std::optional<std::size_t> sibling_of(const PixelTree& tree, std::size_t ray, int by) {
    const auto parent = parent_of(tree, ray);
    if (!parent) {
        return std::nullopt;
    }
    const auto& all = tree.children[*parent];
    const auto place = std::ranges::find(all, ray) - all.begin() + by;
    if (place < 0 || place >= static_cast<std::ptrdiff_t>(all.size())) {
        return std::nullopt;
    }
    return all[static_cast<std::size_t>(place)];
}

bool belongs_to(const PixelTree& tree, std::size_t selected, std::size_t ray) {
    if (selected == 0 || ray == selected || parent_of(tree, ray) == selected) {
        return true;
    }
    for (auto up = parent_of(tree, selected); up; up = parent_of(tree, *up)) {
        if (*up == ray) {
            return true;
        }
    }
    return false;
}

}  // namespace raytree::inspector
