#include "window/scene_pane.h"

#include <QVTKInteractor.h>
#include <QVTKOpenGLNativeWidget.h>
#include <vtkGenericOpenGLRenderWindow.h>

#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <utility>

#include "drawing/angles.h"
#include "drawing/coverage.h"
#include "drawing/picking.h"
#include "drawing/standard_views.h"
#include "state/details.h"
#include "state/emphasis.h"
#include "state/marked_texts.h"
#include "state/outline.h"
#include "state/thing_details.h"
#include "window/qt_text.h"
#include "window/scene_overlay.h"

namespace raytree::inspector {
namespace {

constexpr double click_reach = 9;  // pixels around the cursor
constexpr double drag_from = 4;    // pixels that make a click a drag
constexpr double degrees_a_pixel = 0.4;
const std::vector<std::shared_ptr<const PixelTree>> no_neighbours;
constexpr int settle_time = 90;  // milliseconds without another view, shape or picture

}  // namespace

/// The widget that VTK draws into; it has itself prepared before every frame.
class SceneCanvas : public QVTKOpenGLNativeWidget {
  public:
    explicit SceneCanvas(ScenePane* pane)
        : QVTKOpenGLNativeWidget(pane->scene3d_.window(), pane), pane_(pane) {
        interactor()->SetInteractorStyle(nullptr);  // mouse and keys are the pane's
    }

  protected:
    void paintGL() override {
        // The widget alone may show once more what VTK drew last, so what is new is drawn here.
        if (pane_->prepare_frame()) {
            // VTK tells the widget of the new frame, which would have all be painted once more.
            setAttribute(Qt::WA_UpdatesDisabled, true);
            renderWindow()->Render();
            setAttribute(Qt::WA_UpdatesDisabled, false);
        }
        QVTKOpenGLNativeWidget::paintGL();
    }

  private:
    ScenePane* pane_;
};

ScenePane::ScenePane(State& state, PictureFeed& feed, QWidget* parent)
    : QWidget(parent), state_(state), feed_(feed) {
    canvas_ = new SceneCanvas(this);
    canvas_->installEventFilter(this);
    canvas_->setMouseTracking(true);
    canvas_->setFocusPolicy(Qt::StrongFocus);
    setFocusProxy(canvas_);
    connect(canvas_, &QOpenGLWidget::frameSwapped, this, &ScenePane::drawn);
    overlay_ = new SceneOverlay(state_, view_, canvas_);
    setMinimumSize(240, 180);
    settled_.setSingleShot(true);
    settled_.setInterval(settle_time);
    connect(&settled_, &QTimer::timeout, this, [this] {
        scene3d_.keep();
        redraw();
    });
    meshed_.setInterval(20);
    connect(&meshed_, &QTimer::timeout, this, [this] {
        if (take_mesh({})) {
            redraw();
        }
    });
    scene3d_.set_theme(palette_of(state_.look().theme));
    state_.observe([this](const Changes& changes) { obey(changes); });
    connect(&feed_, &PictureFeed::updated, this, &ScenePane::take_picture);
}

ScenePane::~ScenePane() = default;

void ScenePane::obey(const Changes& changes) {
    if (changes.document) {
        mesh_ = {};
        stale_shapes_ = true;
        take_document();
    }
    if (changes.look) {
        scene3d_.set_theme(palette_of(state_.look().theme));
        stale_shapes_ = true;
    }
    if (changes.coats) {
        take_document();
    }
    if (changes.tree || changes.look || changes.playback) {
        take_tree();
    }
    if (changes.document) {
        obey(Request::from_side);
    }
    if (changes.request) {
        obey(*changes.request);
    }
    if (changes.view_from) {
        View view = view_;
        view.eye = changes.view_from->eye;
        view.target = changes.view_from->target;
        view.up = changes.view_from->up;
        standing_.reset();
        change_view(view);
    }
    if (changes.document || changes.tree || changes.selection || changes.look || changes.playback ||
        changes.explained) {
        redraw();
    }
}

void ScenePane::obey(Request request) {
    if (!state_.document()) {
        return;
    }
    const auto view = asked_view(request);
    if (view) {
        standing_ = request;
        change_view(*view);
    }
}

std::optional<View> ScenePane::asked_view(Request request) const {
    const Document& document = *state_.document();
    View now = view_;
    now.foot = overlay_->foot(now.width);
    switch (request) {
        case Request::through_camera:
            return camera_view(document, extent_, now);
        case Request::from_side:
            return side_view(document, extent_, paths_, now);
        case Request::onto_hit:
            return state_.tree() && state_.selected()->hit
                       ? std::optional(hit_view(document, *state_.selected(), extent_, now))
                       : std::nullopt;
        case Request::fit_tree:
            return fitted_above_legend(now, points_of(paths_, extent_));
        case Request::fit_selection:
            return fitted_above_legend(now, selected_points(), 0.3);
        default:
            return std::nullopt;
    }
}

std::vector<Point3> ScenePane::selected_points() const {
    if (state_.thing()) {
        return corners_of(*state_.document(), extent_, *state_.thing());
    }
    std::vector<RayPath> chosen;
    if (state_.tree()) {
        std::ranges::copy_if(paths_, std::back_inserter(chosen), [&](const RayPath& path) {
            return path.ray == state_.selected()->id;
        });
    }
    return points_of(chosen, extent_);
}

void ScenePane::take_document() {
    extent_ = extent_of(*state_.document());
    mesh_pixel_ = 0;
    stale_picture_ = true;
}

void ScenePane::take_tree() {
    paths_.clear();
    if (state_.tree()) {
        paths_ = ray_paths(*state_.tree(), extent_, state_.look().filter);
        if (const auto& playback = state_.playback()) {
            std::erase_if(paths_, [&](const RayPath& path) {
                return playback->stage(path.ray) == Stage::unsent;
            });
        }
    }
    beside_.clear();
    for (const auto& tree : state_.tree() ? state_.tree()->neighbours : no_neighbours) {
        constexpr std::size_t most = 2000;  // of each
        std::ranges::copy(ray_paths(*tree, extent_, state_.look().filter, most),
                          std::back_inserter(beside_));
    }
    show_notes();
    std::vector<RayPath> all = paths_;
    all.insert(all.end(), beside_.begin(), beside_.end());
    overlay_->set_legend(legend_of(state_, all));
}

/// What of the tree is not drawn as it is.
void ScenePane::show_notes() {
    constexpr std::size_t most = 100'000;
    QStringList notes;
    const RayFilter& filter = state_.look().filter;
    if (state_.tree() && !filter.empty()) {
        notes << qt(text_of(filter));
    }
    if (state_.tree() && paths_.size() >= most && state_.tree()->tree.rays.size() > most) {
        notes << QStringLiteral("drawn are the %1 weightiest of %2 rays")
                     .arg(paths_.size())
                     .arg(state_.tree()->tree.rays.size());
    }
    if (mesh_.thinned_from > 0) {
        notes << QStringLiteral("meshes of %1 triangles are drawn with fewer")
                     .arg(mesh_.thinned_from);
    }
    if (state_.tree() && !state_.tree()->neighbours.empty()) {
        notes << QStringLiteral("thin: the trees of %1 pixels around")
                     .arg(state_.tree()->neighbours.size());
    }
    if (const std::string contrast = contrast_note(state_); !contrast.empty()) {
        notes << qt(contrast);
    }
    overlay_->set_notes(notes);
}

/// With another picture all shapes are drawn anew; of many, that is not done at every step of it.
void ScenePane::take_picture() {
    constexpr std::size_t many = 20'000;  // triangles
    constexpr qint64 seldom = 300;        // milliseconds
    const bool may_wait = mesh_.faces.triangle_count() > many && !feed_.done();
    if (may_wait && pictured_.isValid() && pictured_.elapsed() < seldom) {
        return;
    }
    pictured_.start();
    stale_picture_ = true;
    redraw();
}

void ScenePane::change_view(const View& view) {
    view_ = view;
    stale_view_ = true;
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
        settled_.start();
    }
    if (std::exchange(stale_view_, false)) {
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
    auto mesh = mesh_work_.take(patience);
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
        return covered.meets(mesh_.objects[k].centre, mesh_.objects[k].radius);
    });
    if (over.size() < shape_order_.size() / 2) {
        scene3d_.set_shapes_over(part_of(mesh_, over, view_.eye));
    } else {
        scene3d_.set_all_shapes_over();
    }
}

QImage ScenePane::image(QSize size) {
    const View before = view_;
    const auto take_size = [this](QSize to) {
        canvas_->resize(to);
        overlay_->resize(to);
        view_.width = std::max(1, to.width());
        view_.height = std::max(1, to.height());
        stale_rays_ = stale_view_ = true;
    };
    take_size(size);
    const auto patience = std::exchange(mesh_patience_, std::chrono::minutes(1));
    QImage image = canvas_->grabFramebuffer().convertToFormat(QImage::Format_RGB32);
    QPainter painter(&image);
    overlay_->render(&painter, {}, {}, {});
    painter.end();
    mesh_patience_ = patience;
    take_size(this->size());
    view_ = before;
    redraw();
    return image;
}

std::optional<QPointF> ScenePane::place_of(const Point3& p) const {
    const auto at = project(view_, p);
    return at ? std::optional(QPointF(at->x, at->y)) : std::nullopt;
}

void ScenePane::resizeEvent(QResizeEvent*) {
    canvas_->setGeometry(rect());
    overlay_->setGeometry(canvas_->rect());
    view_.width = std::max(1, width());
    view_.height = std::max(1, height());
    stale_view_ = true;
    if (state_.document() && standing_) {
        obey(*standing_);
    }
    redraw();
}

bool ScenePane::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::MouseButtonPress:
            pressed_ = last_ = static_cast<QMouseEvent*>(event)->localPos();
            dragged_ = false;
            canvas_->setFocus(Qt::MouseFocusReason);
            return true;
        case QEvent::MouseMove: {
            const auto* mouse = static_cast<QMouseEvent*>(event);
            if (mouse->buttons() == Qt::NoButton) {
                show_hint(mouse->localPos(), mouse->globalPos());
                return true;
            }
            const QPointF way = mouse->localPos() - pressed_;
            dragged_ = dragged_ || std::hypot(way.x(), way.y()) > drag_from;
            if (dragged_) {
                drag(mouse->localPos() - last_, !(mouse->buttons() & Qt::LeftButton) ||
                                                    (mouse->modifiers() & Qt::ShiftModifier));
                last_ = mouse->localPos();
            }
            return true;
        }
        case QEvent::MouseButtonRelease:
            if (!dragged_ && static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton) {
                click(pressed_);
            }
            return true;
        case QEvent::MouseButtonDblClick:
            return true;
        case QEvent::Wheel:
            standing_.reset();
            change_view(zoomed(
                view_, std::pow(1.15, static_cast<QWheelEvent*>(event)->angleDelta().y() / 120.0)));
            return true;
        default:
            return QWidget::eventFilter(watched, event);
    }
}

void ScenePane::drag(QPointF by, bool move) {
    standing_.reset();
    change_view(move ? panned(view_, by.x(), -by.y())
                     : orbited(view_, by.x() * degrees_a_pixel, by.y() * degrees_a_pixel));
}

std::optional<std::size_t> ScenePane::ray_at(QPointF at) const {
    const auto path = path_at(paths_, view_, at.x(), at.y(), click_reach);
    return path ? std::optional(paths_[*path].ray) : std::nullopt;
}

/// A light's mark before the rays that end at it, rays before the shapes that they cross.
std::optional<Thing> ScenePane::thing_at(QPointF at) const {
    if (!state_.document()) {
        return std::nullopt;
    }
    const auto light =
        light_at(state_.document()->scene(), extent_, view_, at.x(), at.y(), click_reach);
    return light        ? light
           : ray_at(at) ? std::nullopt
                        : object_at(*state_.document(), view_, at.x(), at.y());
}

void ScenePane::click(QPointF at) {
    const auto thing = thing_at(at);
    const auto ray = thing ? std::nullopt : ray_at(at);
    if (ray) {
        state_.select(*ray);
    } else {
        state_.select(thing);
    }
}

void ScenePane::show_hint(QPointF at, QPoint global) {
    const auto thing = thing_at(at);
    const auto ray = thing ? std::nullopt : ray_at(at);
    canvas_->setCursor(thing || ray ? Qt::PointingHandCursor : Qt::ArrowCursor);
    QString hint;
    if (thing) {
        hint = qt(title_of(state_.document()->scene(), *thing));
    } else if (ray) {
        OutlineRow row;
        row.ray = *ray;
        const OutlineTexts texts = texts_of(*state_.tree(), row);
        const std::string t = texts.t.empty() ? "" : ", t = " + texts.t;
        hint = qt(title_of(state_.tree()->tree.rays[*ray]) + ": " + texts.met + t);
    }
    hint.isEmpty() ? QToolTip::hideText() : QToolTip::showText(global, hint, canvas_);
}

}  // namespace raytree::inspector
