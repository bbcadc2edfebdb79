#include "state/state.h"

/// The state's part in changing a scene.
namespace raytree::inspector {

void State::change(const std::string& place, std::string_view text, Pick how) {
    const Scene changed = with_value(document_->scene(), document_->file().string(), place, text);
    Values values = values_of(changed);
    auto document = document_with(values);
    auto before = how == Pick::on_the_way && edits_.goes_on(place) ? before_ : document_;
    edits_.add(std::move(values), place, how);
    install(std::move(document), std::move(before));
}

std::shared_ptr<const Document> State::document_with(const Values& values) const {
    const LoadedScene& old = document_->loaded();
    LoadedScene loaded{old.scene, old.format, {}, old.warnings, old.output};
    put(values, loaded.scene);
    return std::make_shared<const Document>(document_->file(), std::move(loaded));
}

/// What this cuts off the tree stays as ghosts.
void State::install(std::shared_ptr<const Document> document,
                    std::shared_ptr<const Document> before, bool other_shapes) {
    const bool coats =
        other_shapes || !same_coats(values_of(document_->scene()), values_of(document->scene()));
    document_ = std::move(document);
    before_ = std::move(before);
    keep_selected_ = tree_ && tree_->is_own(selected_) ? std::optional(selected_) : std::nullopt;
    playback_.reset();
    playing_ = false;
    message_.clear();
    trace();
    tell({.tree = true,
          .selection = true,
          .message = true,
          .values = true,
          .coats = coats,
          .playback = true});
}

void State::undo() {
    edits_.undo();
    install(document_with(edits_.values()), document_);
}

void State::redo() {
    edits_.redo();
    install(document_with(edits_.values()), document_);
}

void State::reset_values() {
    edits_.reset();
    install(document_with(edits_.values()), document_);
}

void State::dismiss_cut() {
    if (has_cut()) {
        before_.reset();
        keep_selected_.reset();
        const std::size_t selected = tree_ && tree_->is_own(selected_) ? selected_ : 0;
        trace();
        selected_ = tree_ ? selected : 0;
        tell({.tree = true, .selection = true});
    }
}

void State::save_scene_as(const std::filesystem::path& file) {
    Scene scene = document_->scene();
    relocate_meshes(scene, document_->file().parent_path(), file.parent_path());
    std::string message = "Saved: " + file.string();
    for (const std::string& lost : save_scene(scene, file)) {
        message += "\nNot said in it: " + lost;
    }
    if (file.extension() == ".json") {
        own_file_ = opened_file_ = file;
        edits_.mark_saved();
        if (file != document_->file()) {
            LoadedScene loaded{std::move(scene), SceneFormat::json, {}, {}, {}};
            document_ = std::make_shared<const Document>(file, std::move(loaded));
        }
    }
    message_ = std::move(message);
    tell({.tree = true, .message = true, .values = true});
}

}  // namespace raytree::inspector
