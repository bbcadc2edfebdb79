#include "state/state.h"

#include <algorithm>

/// The state's part in changing a scene.
namespace raytree::inspector {

void State::change(const std::string& place, std::string_view text, Pick how) {
    Values values =
        with_value(document_->scene(), edits_.values(), document_->file().string(), place, text);
    const bool goes_on = how == Pick::on_the_way && edits_.goes_on(place);
    auto before = !goes_on ? document_ : coming_ ? coming_->before : before_;
    edits_.add(values, place, how);
    install({document_, std::move(values), std::move(before)});
}

/// What is shown stays until the tree has come; what the change cuts off it stays as ghosts.
void State::install(Coming coming) {
    coming_ = std::move(coming);
    keep_selected_ = tree_ && tree_->is_own(selected_) ? std::optional(selected_) : std::nullopt;
    same_selected_.reset();
    message_.clear();
    tell(await_tree().value_or(Changes{.message = true}));
}

/// The document with the values asked for, its tree being there.
void State::take_coming(std::shared_ptr<const Document> document, Changes& changes) {
    changes.values = changes.playback = true;
    changes.coats = coming_->other_shapes ||
                    !same_coats(values_of(document_->scene()), values_of(document->scene()));
    document_ = std::move(document);
    before_ = std::move(coming_->before);
    coming_.reset();
    playback_.reset();
    playing_ = false;
    changes.explained |= forget_measured();
}

void State::undo() {
    edits_.undo();
    install({document_, edits_.values(), document_});
}

void State::redo() {
    edits_.redo();
    install({document_, edits_.values(), document_});
}

void State::reset_values() {
    edits_.reset();
    install({document_, edits_.values(), document_});
}

void State::dismiss_cut() {
    if (has_cut()) {
        before_.reset();
        keep_selected_.reset();
        same_selected_ = tree_ && tree_->is_own(selected_) ? selected_ : 0;
        tell(await_tree().value_or(Changes{.message = true}));
    }
}

namespace {

/// What the format cannot say, each once, and of much the first few.
std::string left_out_text(const std::vector<std::string>& lost) {
    constexpr std::size_t most = 4;
    std::vector<std::string> told;
    for (const std::string& one : lost) {
        if (std::ranges::find(told, one) == told.end()) {
            told.push_back(one);
        }
    }
    std::string text;
    for (std::size_t k = 0; k < std::min(told.size(), most); ++k) {
        text += (k == 0 ? "\nNot said in it: " : " ") + told[k];
    }
    return told.size() > most ? text + " And " + std::to_string(told.size() - most) +
                                    " more: raytree convert tells all."
                              : text;
}

}  // namespace

void State::save_scene_as(const std::filesystem::path& file) {
    Scene scene;
    std::string message = "Saved: " + file.string();
    do_beside("Writing " + file.filename().string(), [&] {
        scene = document_->scene();
        put(edits_.values(), scene);
        relocate_meshes(scene, document_->file().parent_path(), file.parent_path());
        message += left_out_text(save_scene(scene, file));
    });
    if (file.extension() == ".json") {
        own_file_ = opened_file_ = file;
        edits_.mark_saved();
        if (file != document_->file()) {
            LoadedScene loaded{std::move(scene), SceneFormat::json, {}, {}, {}};
            document_ = std::make_shared<const Document>(file, std::move(loaded));
        }
    }
    if (coming_) {
        install({document_, edits_.values(), coming_->before});
    }
    message_ = std::move(message);
    tell({.tree = true, .message = true, .values = true});
}

}  // namespace raytree::inspector
