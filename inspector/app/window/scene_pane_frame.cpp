#include <algorithm>
#include <glm/geometric.hpp>
#include <iterator>
#include <new>
#include <utility>

#include "drawing/angles.h"
#include "drawing/coverage.h"
#include "drawing/picking.h"
#include "state/emphasis.h"
#include "state/marked_texts.h"
#include "window/qt_text.h"
#include "window/scene_canvas.h"
#include "window/scene_overlay.h"
#include "window/scene_pane.h"

/// The 3D view's part in what a frame consists of.
namespace raytree::inspector {

void ScenePane::take_picture() {
    stale_picture_ = true;
    redraw();
}

bool ScenePane::looks_from_the_eye() const {
    return glm::length(view_.eye - state_.document()->scene().camera.eye) <
           0.6 * extent_.plane_distance;
}

void ScenePane::redraw() {
    stale_rays_ = true;
    canvas_->update();
}

void ScenePane::settle() {
    scene3d_.keep();
    scene3d_.is_rough() ? finish_frame() : redraw();
}

/// Many shapes are shown as they are when all are drawn, and no sooner.
void ScenePane::finish_frame() {
    if (scene3d_.is_rough() && scene3d_.is_keeping()) {
        drawing_.start();
    }
}

void ScenePane::draw_more() {
    constexpr std::chrono::milliseconds glance(25);
    canvas_->makeCurrent();
    const bool done = scene3d_.draw_more(glance);
    canvas_->doneCurrent();
    if (done) {
        drawing_.stop();
        redraw();
    }
}

void ScenePane::set_many(int many) {
    scene3d_.set_many(many);
    redraw();
}

bool ScenePane::prepare_frame() {
    ++frames_;
    if (!state_.document()) {
        return false;
    }
    const bool changed = stale_shapes_ || stale_picture_ || stale_rays_;
    if (const double pixel = mesh_pixel(extent_, view_); pixel != mesh_pixel_) {
        make_mesh(pixel);
    }
    if (std::exchange(stale_shapes_, false)) {
        scene3d_.set_shapes(mesh_, state_.look().shapes);
        stale_view_ = true;
    }
    if (std::exchange(stale_picture_, false) && !feed_.picture().cells.empty()) {
        const ShownPicture& picture = feed_.picture();
        scene3d_.set_picture(picture.width, picture.height, picture.cells);
        place_picture();
    }
    if (std::exchange(stale_view_, false)) {
        drawing_.stop();
        settled_.start();
        place_picture();
        if (state_.look().shapes == ShapeStyle::see_through) {
            shape_order_ = drawing_order(mesh_, extent_, view_.eye);
            scene3d_.set_shape_order(triangles_of(mesh_, shape_order_, view_.eye));
        }
    }
    if (std::exchange(stale_rays_, false)) {
        prepare_rays();
    }
    if (!scene3d_.is_keeping() && !settled_.isActive()) {
        drawing_.stop();
        settled_.start();
    }
    return changed;
}

/// What takes longer than a glance is drawn when it is there, and what was drawn stays until then.
void ScenePane::make_mesh(double pixel) {
    mesh_pixel_ = pixel;
    meshing_ = true;
    mesh_work_.ask([document = state_.document(), extent = extent_, pixel](const std::stop_token&) {
        return scene_mesh(*document, extent, pixel);
    });
    if (!take_mesh(mesh_patience_)) {
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
    mesh_ = std::move(*mesh);
    stale_shapes_ = true;
    show_notes();
    return true;
}

/// Its pixels are squares as soon as they are as large as those of the screen.
void ScenePane::place_picture() {
    const auto corners = picture_corners(*state_.document(), extent_.plane_distance);
    const double pixel =
        glm::length(corners[1] - corners[0]) / std::max(1, state_.document()->scene().camera.width);
    const Point3 middle = (corners[0] + corners[2]) * 0.5;
    scene3d_.set_picture_place(corners, pixel >= length_per_pixel(view_, middle),
                               !looks_from_the_eye());
}

/// All that stands beside the shapes: it is made anew for each view and selection.
void ScenePane::prepare_rays() {
    const Palette& palette = palette_of(state_.look().theme);
    // The normal comes and goes with the angles that are measured from it.
    const auto* const marked = state_.look().angles ? state_.selected() : nullptr;
    const Landmarks marks = landmarks({*state_.document(), marked, state_.pixel(), extent_, view_,
                                       palette, state_.thing(), &mesh_});
    const ExplainedMesh explained = explained_mesh(state_, extent_, view_);
    RayMeshes rays;
    AngleDrawing angles;
    if (state_.tree()) {
        const PixelTree& tree = *state_.tree();
        const std::size_t ray = state_.selected()->id;
        rays = ray_meshes({paths_, tree, ray, extent_, view_, palette, set_aside(state_)});
        if (can_derive(tree, ray, state_.playback())) {
            angles = angle_drawing({*state_.document(), tree, ray, extent_, view_, palette,
                                    state_.look().angles, state_.look().ghosts,
                                    state_.playback() ? &*state_.playback() : nullptr,
                                    state_.look().filter});
        }
    }
    add_thin(rays.lines, beside_, palette);
    scene3d_.set_landmarks(marks);
    scene3d_.set_rays(rays);
    scene3d_.set_angles(angles);
    scene3d_.set_explained(explained);
    lay_shapes_over({&marks.solid, &rays.solid, &rays.halo, &angles.solid, &explained.solid});
    scene3d_.set_view(view_);
    std::vector<SceneLabel> labels;
    for (const DrawnWords& words : angles.words) {
        labels.push_back({words.at, qt(words.text), words.strong, words.out});
    }
    std::ranges::copy(scene_labels(state_, extent_, view_, looks_from_the_eye()),
                      std::back_inserter(labels));
    std::ranges::stable_partition(labels, &SceneLabel::strong);
    overlay_->set_labels(std::move(labels), ray_lines());
}

/// Rays as they stand on the screen; none where there are too many for words to keep clear of.
std::vector<WordLine> ScenePane::ray_lines() const {
    constexpr std::size_t most = 400;
    std::vector<WordLine> lines;
    for (std::size_t k = 0; k < paths_.size() && paths_.size() <= most; ++k) {
        if (const auto ends = on_screen(paths_[k], view_)) {
            lines.push_back({ends->first.x, ends->first.y, ends->second.x, ends->second.y});
        }
    }
    return lines;
}

/// Of many shapes only those are drawn once more that may stand before a ray or a mark.
void ScenePane::lay_shapes_over(std::initializer_list<const Mesh*> things) {
    constexpr std::size_t many = 20'000;  // triangles
    if (state_.look().shapes != ShapeStyle::see_through || mesh_.faces.triangle_count() < many) {
        return;
    }
    Coverage covered(view_);
    for (const Mesh* const thing : things) {
        covered.add(*thing);
    }
    std::vector<std::size_t> over;
    std::ranges::copy_if(shape_order_, std::back_inserter(over), [&](std::size_t k) {
        return covered.is_behind(mesh_.objects[k].centre, mesh_.objects[k].radius);
    });
    if (over.size() < shape_order_.size() / 2) {
        scene3d_.set_shapes_over(part_of(mesh_, over, view_.eye));
    } else {
        scene3d_.set_all_shapes_over();
    }
}

}  // namespace raytree::inspector
