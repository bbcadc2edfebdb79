#include "window/scene_pane.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkGenericOpenGLRenderWindow.h>

#include <QMouseEvent>
#include <QToolTip>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "state/details.h"
#include "state/outline.h"
#include "window/qt_text.h"
#include "window/scene_overlay.h"

namespace raytree::inspector {
namespace {

constexpr double click_reach = 9;      // pixels around the cursor
constexpr double drag_from = 4;        // pixels that make a click a drag
constexpr double degrees_a_pixel = 0.4;
constexpr double side_fov = 30;

}  // namespace

/// The widget that VTK draws into; it has itself prepared before every frame.
class SceneCanvas : public QVTKOpenGLNativeWidget {
  public:
    explicit SceneCanvas(ScenePane* pane)
        : QVTKOpenGLNativeWidget(pane->scene3d_.window(), pane), pane_(pane) {}

  protected:
    void paintGL() override {
        pane_->prepare_frame();
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
    scene3d_.set_theme(palette_of(state_.look().theme));
    state_.observe([this](const Changes& changes) { obey(changes); });
    connect(&feed_, &PictureFeed::updated, this, &ScenePane::take_picture);
}

ScenePane::~ScenePane() = default;

void ScenePane::obey(const Changes& changes) {
    if (changes.document) {
        take_document();
    }
    if (changes.look) {
        scene3d_.set_theme(palette_of(state_.look().theme));
        stale_shapes_ = true;
    }
    if (changes.tree || changes.look) {
        take_tree();
    }
    if (changes.document) {
        look_from_side();
    }
    if (changes.request) {
        obey(*changes.request);
    }
    if (changes.document || changes.tree || changes.selection || changes.look) {
        redraw();
    }
}

void ScenePane::obey(Request request) {
    if (!state_.document()) {
        return;
    }
    if (request == Request::through_camera) {
        look_through_camera();
    } else if (request == Request::from_side) {
        look_from_side();
    } else if (request == Request::fit_tree) {
        fit(points_of(paths_, extent_));
    } else if (request == Request::fit_ray && state_.tree()) {
        std::vector<RayPath> chosen;
        for (const RayPath& path : paths_) {
            if (path.ray == state_.selected()->id) {
                chosen.push_back(path);
            }
        }
        fit(points_of(chosen, extent_), 0.3);
    }
}

void ScenePane::take_document() {
    extent_ = extent_of(*state_.document());
    mesh_ = scene_mesh(*state_.document(), extent_);
    stale_shapes_ = true;
    stale_picture_ = true;
}

void ScenePane::take_tree() {
    paths_.clear();
    if (state_.tree()) {
        paths_ = ray_paths(*state_.tree(), extent_, state_.look().hidden);
        const std::size_t all = state_.tree()->tree.rays.size();
        const bool cut = state_.look().hidden.empty() && paths_.size() < all;
        overlay_->set_note(cut ? QStringLiteral("drawn are the %1 weightiest of %2 rays")
                                     .arg(paths_.size())
                                     .arg(all)
                               : QString());
    }
}

void ScenePane::take_picture() {
    stale_picture_ = true;
    redraw();
}

void ScenePane::look_from_side() {
    const CameraRays<double>& camera = state_.document()->world().camera;
    const Point3 eye = state_.document()->scene().camera.eye;
    const Point3 up = glm::normalize(state_.document()->scene().camera.up);
    View view = view_;
    view.up = up;
    view.fov_degrees = side_fov;
    view.target = extent_.seen.centre();
    view.eye = view.target + extent_.diagonal * (0.8 * camera.right().vec() -
                                                 0.85 * camera.forward().vec() + 0.45 * up);
    // What is far off does not make all the rest small.
    std::vector<Point3> points = points_of(paths_, extent_);
    std::erase_if(points, [&](const Point3& p) {
        return glm::length(p - view.target) > 0.95 * extent_.diagonal;
    });
    for (const Point3& corner : picture_corners(*state_.document(), extent_.plane_distance)) {
        points.push_back(corner);
    }
    points.push_back(eye);
    view_ = view;
    fit(points);
}

/// The field of view is that of the camera, widened to the pane's shape.
void ScenePane::look_through_camera() {
    const Document& document = *state_.document();
    const CameraRays<double>& camera = document.world().camera;
    View view = view_;
    view.eye = document.scene().camera.eye;
    view.target = view.eye + camera.forward().vec() * extent_.far_distance;
    view.up = camera.up();
    double high = 0, wide = 0;
    for (const Point3& corner : picture_corners(document, 1)) {
        high = std::max(high, std::abs(glm::dot(corner - view.eye, camera.up())));
        wide = std::max(wide, std::abs(glm::dot(corner - view.eye, camera.right().vec())));
    }
    const double shape = static_cast<double>(view.width) / std::max(1, view.height);
    constexpr double margin = 1.06;  // the frame of the picture is to be seen
    view.fov_degrees =
        2 * std::atan(margin * std::max(high, wide / shape)) * 180 / std::numbers::pi;
    change_view(view);
}

void ScenePane::fit(const std::vector<Point3>& points, double margin) {
    View view = view_;
    view.fov_degrees = side_fov;
    // The legend's strip is left free: fitted into a lower view, the aim then moved up by half of
    // what was taken away.
    const int strip = std::min(34, view.height / 6);
    view.height -= strip;
    view.fov_degrees *= static_cast<double>(view.height) / view_.height;
    view = fitted(view, points, margin);
    view.height = view_.height;
    view.fov_degrees = side_fov;
    change_view(panned(view, 0, strip / 2.0));
}

void ScenePane::change_view(const View& view) {
    view_ = view;
    redraw();
}

bool ScenePane::looks_from_the_eye() const {
    return glm::length(view_.eye - state_.document()->scene().camera.eye) <
           0.6 * extent_.plane_distance;
}

void ScenePane::redraw() {
    stale_rays_ = true;
    canvas_->update();
    if (state_.document()) {
        overlay_->set_labels(scene_labels(state_, extent_, looks_from_the_eye()));
    }
}

/// Hands over what has changed since the last frame.
void ScenePane::prepare_frame() {
    ++frames_;
    if (!state_.document()) {
        return;
    }
    const Palette& palette = palette_of(state_.look().theme);
    if (std::exchange(stale_shapes_, false)) {
        scene3d_.set_shapes(mesh_, state_.look().shapes);
    }
    if (std::exchange(stale_picture_, false) && !feed_.picture().cells.empty()) {
        const ShownPicture& picture = feed_.picture();
        scene3d_.set_picture(picture.width, picture.height, picture.cells);
    }
    if (std::exchange(stale_rays_, false)) {
        scene3d_.set_picture_place(picture_corners(*state_.document(), extent_.plane_distance),
                                   !looks_from_the_eye());
        if (state_.look().shapes == ShapeStyle::see_through && mesh_.objects.size() < 2000) {
            scene3d_.set_shape_order(sorted_triangles(mesh_, extent_, view_.eye));
        }
        scene3d_.set_landmarks(landmarks({*state_.document(), state_.selected(), state_.pixel(),
                                          extent_, view_, palette}));
        scene3d_.set_rays(state_.tree() ? ray_meshes({paths_, *state_.tree(),
                                                      state_.selected()->id, extent_, view_,
                                                      palette})
                                        : RayMeshes{});
        scene3d_.set_view(view_);
    }
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
    if (state_.document() && !canvas_->isVisible()) {
        look_from_side();
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
            change_view(zoomed(
                view_, std::pow(1.15, static_cast<QWheelEvent*>(event)->angleDelta().y() / 120.0)));
            return true;
        default:
            return QWidget::eventFilter(watched, event);
    }
}

void ScenePane::drag(QPointF by, bool move) {
    change_view(move ? panned(view_, by.x(), -by.y())
                     : orbited(view_, by.x() * degrees_a_pixel, by.y() * degrees_a_pixel));
}

std::optional<std::size_t> ScenePane::ray_at(QPointF at) const {
    const auto path = path_at(paths_, view_, at.x(), at.y(), click_reach);
    return path ? std::optional(paths_[*path].ray) : std::nullopt;
}

void ScenePane::click(QPointF at) {
    if (const auto ray = ray_at(at)) {
        state_.select(*ray);
    }
}

void ScenePane::show_hint(QPointF at, QPoint global) {
    const auto ray = ray_at(at);
    canvas_->setCursor(ray ? Qt::PointingHandCursor : Qt::ArrowCursor);
    if (!ray) {
        QToolTip::hideText();
        return;
    }
    OutlineRow row;
    row.ray = *ray;
    const OutlineTexts texts = texts_of(*state_.tree(), row);
    const std::string t = texts.t.empty() ? "" : ", t = " + texts.t;
    QToolTip::showText(
        global, qt(title_of(state_.tree()->tree.rays[*ray]) + ": " + texts.met + t), canvas_);
}

}  // namespace raytree::inspector
