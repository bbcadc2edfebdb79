#include <QMouseEvent>
#include <QToolTip>
#include <cmath>

#include "drawing/picking.h"
#include "formats/tree_diagram.h"
#include "state/outline.h"
#include "state/thing_details.h"
#include "window/qt_text.h"
#include "window/scene_canvas.h"
#include "window/scene_overlay.h"
#include "window/scene_pane.h"

/// The 3D view's part in what a hand does: turning, moving, zooming, choosing.
namespace raytree::inspector {
namespace {

constexpr double click_reach = 9;  // pixels around the cursor
constexpr double drag_from = 4;    // pixels that make a click a drag
constexpr double degrees_a_pixel = 0.4;
constexpr double notch_zoom = 1.15;  // of the wheel
constexpr double key_degrees = 10;
constexpr double stroke_zoom = 1.3;  // of a key

}  // namespace

bool ScenePane::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::FocusIn:
        case QEvent::FocusOut:
            overlay_->update();
            return QWidget::eventFilter(watched, event);
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
                view_,
                std::pow(notch_zoom, static_cast<QWheelEvent*>(event)->angleDelta().y() / 120.0)));
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

/// What keys do as the hand does; none for other requests.
std::optional<View> ScenePane::moved_view(Request request) const {
    switch (request) {
        case Request::view_closer:
            return zoomed(view_, stroke_zoom);
        case Request::view_further:
            return zoomed(view_, 1 / stroke_zoom);
        case Request::turn_left:
            return orbited(view_, -key_degrees, 0);
        case Request::turn_right:
            return orbited(view_, key_degrees, 0);
        case Request::turn_up:
            return orbited(view_, 0, -key_degrees);
        case Request::turn_down:
            return orbited(view_, 0, key_degrees);
        default:
            return std::nullopt;
    }
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
                        : object_at(*state_.document(), cut_open(view_), at.x(), at.y());
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
        const TreeRay<double>& one = state_.tree()->tree.rays[*ray];
        hint = qt(title_of(one) + ": " + (one.shadow ? short_fate(one) : texts.met) + t);
    }
    hint.isEmpty() ? QToolTip::hideText() : QToolTip::showText(global, hint, canvas_);
}

}  // namespace raytree::inspector
