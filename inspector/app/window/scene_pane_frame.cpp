#include <algorithm>
#include <glm/geometric.hpp>
#include <iterator>
#include <new>
#include <utility>

#include "drawing/angles.h"
#include "drawing/picking.h"
#include "state/emphasis.h"
#include "state/marked_texts.h"
#include "window/qt_text.h"
#include "window/scene_canvas.h"
#include "window/scene_overlay.h"
#include "window/scene_pane.h"

/// The 3D view's part in what a frame consists of.
namespace raytree::inspector {

View ScenePane::cut_open(View view) const {
    view.cut = state_.look().shapes == ShapeStyle::solid ? view.cut : 0;
    return view;
}

bool ScenePane::looks_from_the_eye(const View& view) const {
    return glm::length(view.eye - state_.document()->scene().camera.eye) <
           0.6 * extent_.plane_distance;
}

void ScenePane::redraw() {
    stale_ = true;
    begin_frame();
}

/// One frame is drawn at a time: the next one shows all that has changed meanwhile. For a little
/// more of the picture alone it need not come at once.
void ScenePane::begin_frame() {
    constexpr int soon = 100;  // milliseconds
    if (shown_ == asked_ && isVisible() && (stale_ || !changed_.isActive())) {
        changed_.start(stale_ ? 0 : soon);
    }
}

void ScenePane::ask_for_frame() {
    if (!state_.document()) {
        return;
    }
    changed_.stop();
    if (const double pixel = mesh_pixel(extent_, view_); pixel != mesh_pixel_) {
        make_mesh(pixel);
    }
    if (std::exchange(stale_picture_, false) && !feed_.picture().cells.empty()) {
        picture_ = std::make_shared<ShownPicture>(feed_.picture());
    }
    described_ = describe(view_, mesh_);
    asked_ = drawing_.draw(described_.frame);
    current_ = std::exchange(stale_, false) ? asked_ : current_;
}

void ScenePane::take_frames() {
    while (const auto frame = drawing_.take()) {
        show_frame(*frame);
    }
}

void ScenePane::show_frame(const DrawnFrame& frame) {
    shown_ = frame.number;
    rough_ = frame.rough;
    keeps_ = frame.keeps;
    if (frame.failed) {
        state_.say("There is too little memory to draw the 3D view.");
    } else {
        ++frames_;
        canvas_->show_frame(image_of(frame.image, described_.frame.ratio));
    }
    if (shown_ == asked_) {
        overlay_->set_labels(described_.frame.view, described_.labels, described_.lines);
        if (stale_ || stale_picture_) {
            begin_frame();
        }
    }
}

void ScenePane::catch_up() {
    if (stale_ || stale_picture_) {
        ask_for_frame();
    }
    while (shown_ != asked_) {
        show_frame(drawing_.wait());
    }
}

void ScenePane::set_many(int many) {
    many_ = many;
    redraw();
}

/// What takes longer than a glance is drawn when it is there, and what was drawn stays until then.
void ScenePane::make_mesh(double pixel) {
    constexpr std::chrono::milliseconds glance(10);
    mesh_pixel_ = pixel;
    meshing_ = true;
    mesh_work_.ask([document = state_.document(), extent = extent_, pixel](const std::stop_token&) {
        return scene_mesh(*document, extent, pixel);
    });
    if (!take_mesh(glance)) {
        meshed_.start();
    }
}

bool ScenePane::take_mesh(std::chrono::milliseconds patience) {
    std::optional<SceneMesh> mesh;
    try {
        mesh = mesh_work_.take(patience);
    } catch (const std::bad_alloc&) {
        mesh.emplace();  // rays can be followed without
        state_.say("There is too little memory to draw the shapes.");
    }
    if (!mesh) {
        return false;
    }
    meshing_ = false;
    meshed_.stop();
    mesh_ = std::make_shared<const SceneMesh>(std::move(*mesh));
    show_notes();
    return true;
}

/// As they are drawn in another view, no matter how long it takes.
ScenePane::Shapes ScenePane::shapes_for(const View& view) {
    const double pixel = mesh_pixel(extent_, view);
    Shapes shapes = mesh_;
    if (pixel != mesh_pixel_ || meshing_) {
        state_.do_beside("Drawing the 3D view", [&] {
            shapes = std::make_shared<SceneMesh>(scene_mesh(*state_.document(), extent_, pixel));
        });
    }
    return shapes;
}

/// Its pixels are squares as soon as they are as large as those of the screen.
PicturePlace ScenePane::picture_place(const View& view) const {
    const auto corners = picture_corners(*state_.document(), extent_.plane_distance);
    const double pixel =
        glm::length(corners[1] - corners[0]) / std::max(1, state_.document()->scene().camera.width);
    const Point3 middle = (corners[0] + corners[2]) * 0.5;
    return {corners, pixel >= length_per_pixel(view, middle), !looks_from_the_eye(view)};
}

/// All that stands beside the shapes: it is made anew for each view and selection.
ScenePane::Described ScenePane::describe(const View& view, const Shapes& shapes) const {
    auto things = std::make_shared<SceneThings>(this->things(view, *shapes));
    std::vector<SceneLabel> labels;
    for (const DrawnWords& words : things->angles.words) {
        labels.push_back({words.at, qt(words.text), words.strong, words.out});
    }
    std::ranges::copy(scene_labels(state_, extent_, view, looks_from_the_eye(view)),
                      std::back_inserter(labels));
    if (state_.look().shapes == ShapeStyle::solid) {
        mark_hidden(labels, *state_.document(), cut_open(view));
    }
    std::ranges::stable_partition(labels, &SceneLabel::strong);
    return {
        {state_.look().theme, shapes, state_.look().shapes, extent_, picture_, picture_place(view),
         std::move(things), cut_open(view), devicePixelRatioF(), false, many_},
        std::move(labels),
        ray_lines(view)};
}

SceneThings ScenePane::things(const View& view, const SceneMesh& shapes) const {
    const Palette& palette = palette_of(state_.look().theme);
    // The normal comes and goes with the angles that are measured from it.
    const auto* const marked = state_.look().angles ? selected_and_found(state_) : nullptr;
    SceneThings things;
    things.marks = landmarks({*state_.document(), marked, state_.pixel(), extent_, view, palette,
                              state_.thing(), &shapes});
    things.explained = explained_mesh(state_, extent_, view);
    if (state_.tree()) {
        const PixelTree& tree = *state_.tree();
        const std::size_t ray = state_.selected()->id;
        things.rays = ray_meshes(
            {paths_, tree, ray, extent_, view, palette, set_aside(state_), !state_.thing()});
        if (can_derive(tree, ray, state_.playback())) {
            things.angles = angle_drawing({*state_.document(), tree, ray, extent_, view, palette,
                                           state_.look().angles, state_.look().ghosts,
                                           state_.playback() ? &*state_.playback() : nullptr,
                                           state_.look().filter});
        }
    }
    add_thin(things.rays.lines, beside_, palette);
    return things;
}

/// Rays as they stand on the screen; none where there are too many for words to keep clear of.
std::vector<WordLine> ScenePane::ray_lines(const View& view) const {
    constexpr std::size_t most = 400;
    std::vector<WordLine> lines;
    for (std::size_t k = 0; k < paths_.size() && paths_.size() <= most; ++k) {
        if (const auto ends = on_screen(paths_[k], view)) {
            lines.push_back({ends->first.x, ends->first.y, ends->second.x, ends->second.y});
        }
    }
    return lines;
}

}  // namespace raytree::inspector
