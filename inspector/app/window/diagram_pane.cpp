#include "window/diagram_pane.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "state/emphasis.h"
#include "state/folding.h"
#include "tree/explain.h"
#include "window/diagram_drawing.h"
#include "window/qt_text.h"

namespace raytree::inspector {
namespace {

constexpr double margin = 14;  // around the diagram
constexpr double least_scale = 0.02, most_scale = 4;
constexpr double least_readable = 0.85, most_at_first = 1.25;

/// The next number of two digits: what is less than a share is less than that, too.
double rounded_up(double share) {
    const double unit = std::pow(10, std::floor(std::log10(share)) - 1);
    return std::ceil(share / unit * (1 - 1e-12)) * unit;
}

}  // namespace

DiagramPane::DiagramPane(State& state, QWidget* parent) : QWidget(parent), state_(state) {
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(QStringLiteral("Diagram of the ray tree"));
    state_.observe([this](const Changes& changes) { obey(changes); });
}

/// The diagram is made once it is looked at.
void DiagramPane::obey(const Changes& changes) {
    stale_ |= changes.tree || changes.tree_pane;
    stale_looks_ |= stale_ || changes.playback;
    own_view_ |= changes.tree && !changes.values;
    reveal_ |= changes.selection || changes.tree_pane;
    const QPointF centre(width() / 2.0, height() / 2.0);
    if (changes.request == Request::fit_diagram) {
        prepare();
        fit();
    } else if (changes.request == Request::diagram_closer) {
        zoom_by(1.25, centre);
    } else if (changes.request == Request::diagram_further) {
        zoom_by(0.8, centre);
    }
    update();
}

void DiagramPane::prepare() {
    if (stale_) {
        stale_ = false;
        tree_ = state_.tree();
        folded_below_ = tree_ ? fold_of(*tree_, state_.tree_pane()) : 0;
        diagram_ = tree_ ? diagram_of(tree_->tree, folded_below_) : Diagram();
        own_view_ ? begin_view() : fitted_ ? fit() : keep_in_place();
    }
    if (std::exchange(stale_looks_, false)) {
        looks_ = tree_ ? box_looks(diagram_, *tree_, state_.playback()) : std::vector<BoxLook>();
    }
    if (reveal_ && tree_) {
        reveal_ = false;
        reveal_selection();
    }
}

/// All of its width where that can be read, or else the middle of its top.
void DiagramPane::begin_view() {
    if (diagram_.boxes.empty()) {
        return;
    }
    own_view_ = true;
    fitted_ = false;
    const DiagramBox& root = diagram_.boxes.front();
    scale_ = std::clamp(std::min((width() - 2 * margin) / diagram_.width,
                                 (room_height() - 2 * margin) / diagram_.height),
                        least_readable, most_at_first);
    origin_ = {width() / 2.0 - scale_ * (root.x + root.card_width / 2), margin};
    keep_in_place();
    reveal_ = true;
}

void DiagramPane::fit() {
    if (diagram_.boxes.empty()) {
        return;
    }
    own_view_ = false;
    fitted_ = true;
    scale_ = std::clamp(std::min((width() - 2 * margin) / diagram_.width,
                                 (room_height() - 2 * margin) / diagram_.height),
                        least_scale, 1.5);
    keep_in_place();
}

void DiagramPane::zoom_by(double factor, QPointF about) {
    const double before = scale_;
    scale_ = std::clamp(scale_ * factor, least_scale, most_scale);
    origin_ = about - (about - origin_) * (scale_ / before);
    own_view_ = false;
    fitted_ = false;
    keep_in_place();
    update();
}

/// Centred where it is smaller than the pane; else none of its edges comes inside.
void DiagramPane::keep_in_place() {
    const auto kept = [](double at, double size, double room) {
        const double least = room - margin - size;
        return least >= margin ? (room - size) / 2 : std::clamp(at, least, margin);
    };
    origin_ = {kept(origin_.x(), scale_ * diagram_.width, width()),
               kept(origin_.y(), scale_ * diagram_.height, room_height())};
}

void DiagramPane::reveal_selection() {
    const DiagramPlace place = place_of(diagram_, spot_of(diagram_, *tree_, state_.selected()->id));
    const auto shift = [this](double at, double size, double room) {
        const double from = at - margin - scale_ * DiagramSizes::label;
        const double to = at + scale_ * size + margin;
        return from < 0 ? -from : to > room ? std::max(room - to, -from) : 0;
    };
    origin_ += {shift(origin_.x() + scale_ * place.x, place.width, width()),
                shift(origin_.y() + scale_ * place.y, place.height, room_height())};
    keep_in_place();
}

QPointF DiagramPane::place_of_ray(std::size_t ray) {
    prepare();
    const DiagramPlace place = place_of(diagram_, spot_of(diagram_, *tree_, ray));
    return origin_ + scale_ * QPointF(place.x + place.width / 2, place.y + place.height / 2);
}

std::optional<DiagramSpot> DiagramPane::spot_under(QPointF place) {
    prepare();
    const QPointF at = to_diagram(place);
    const auto spot = spot_at(diagram_, at.x(), at.y());
    const bool hidden = spot && (spot->light ? looks_[spot->box].hidden_lights[*spot->light]
                                             : looks_[spot->box].hidden);
    return hidden ? std::nullopt : spot;
}

void DiagramPane::resizeEvent(QResizeEvent*) {
    TreePane pane = state_.tree_pane();
    pane.room = std::max(0.0, (width() - 2 * margin) / least_readable);
    if (pane.room != state_.tree_pane().room) {
        state_.change_tree_pane(pane);
    }
    prepare();
    fitted_ ? fit() : own_view_ ? begin_view() : keep_in_place();
}

void DiagramPane::paintEvent(QPaintEvent*) {
    prepare();
    const Palette& palette = palette_of(state_.look().theme);
    QPainter painter(this);
    painter.fillRect(rect(), qt(palette.panel));
    if (tree_) {
        painter.save();
        painter.setRenderHint(QPainter::Antialiasing);
        painter.translate(origin_);
        painter.scale(scale_, scale_);
        const QRectF visible(to_diagram({0, 0}), QSizeF(size()) / scale_);
        DiagramDrawing(painter, diagram_, looks_, palette, tree_->tree.settings.quantize)
            .draw(visible, spot_of(diagram_, *tree_, state_.selected()->id), emphasis_of(state_));
        painter.restore();
        draw_bars(painter);
        draw_note(painter);
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(qt(hasFocus() ? palette.accent : palette.rule));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

/// Says that branches are folded, and below which share of the pixel.
void DiagramPane::draw_note(QPainter& painter) const {
    if (folded_below_ <= 0) {
        return;
    }
    const QString text = std::isinf(folded_below_)
                             ? QStringLiteral("all branches folded · Shift+K unfolds")
                             : QStringLiteral(
                                   "folded: branches that are less than %1 of the pixel "
                                   "· K folds more, Shift+K less")
                                   .arg(qt(number_text(rounded_up(folded_below_))));
    const Palette& palette = palette_of(state_.look().theme);
    const QRectF strip(0, room_height(), width(), height() - room_height());
    painter.fillRect(strip, qt(palette.window));
    painter.setPen(qt(palette.dim_text));
    painter.drawText(strip.adjusted(8, 0, -8, 0), Qt::AlignVCenter | Qt::AlignLeft, text);
}

/// Along the edges beyond which the diagram goes on: which part of it is to be seen.
void DiagramPane::draw_bars(QPainter& painter) const {
    constexpr double thick = 5, off = 3;
    const Palette& palette = palette_of(state_.look().theme);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(qt(mixed(palette.panel, palette.dim_text, 0.7)));
    const auto draw = [&](double origin, double size, double room, auto bar) {
        const double all = size + 2 * margin;
        if (all > room + 1) {
            const double length = std::max(20.0, room * room / all);
            painter.drawRoundedRect(bar((margin - origin) / (all - room) * (room - length), length),
                                    thick / 2, thick / 2);
        }
    };
    draw(origin_.x(), scale_ * diagram_.width, width(), [&](double from, double length) {
        return QRectF(from, room_height() - thick - off, length, thick);
    });
    draw(origin_.y(), scale_ * diagram_.height, room_height(), [&](double from, double length) {
        return QRectF(width() - thick - off, from, thick, length);
    });
}

/// The height that the diagram has, without the note.
double DiagramPane::room_height() const {
    return height() - (folded_below_ > 0 ? fontMetrics().height() + 6 : 0);
}

bool DiagramPane::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* const help = static_cast<QHelpEvent*>(event);
        QToolTip::showText(help->globalPos(), tooltip_at(help->pos()), this);
        return true;
    }
    return QWidget::event(event);
}

QString DiagramPane::tooltip_at(QPointF place) {
    const auto spot = spot_under(place);
    if (!spot) {
        return {};
    }
    const DiagramBox& box = diagram_.boxes[spot->box];
    return qt(spot->light ? box.lights[*spot->light].tooltip : box.tooltip);
}

void DiagramPane::mousePressEvent(QMouseEvent* event) {
    pressed_ = last_ = event->localPos();
    dragged_ = false;
}

void DiagramPane::mouseMoveEvent(QMouseEvent* event) {
    constexpr double slack = 4;  // a hand is never quite still
    dragged_ |= (event->localPos() - pressed_).manhattanLength() > slack;
    if (dragged_ && event->buttons() != Qt::NoButton) {
        origin_ += event->localPos() - last_;
        last_ = event->localPos();
        own_view_ = false;
        fitted_ = false;
        keep_in_place();
        update();
    }
}

void DiagramPane::mouseReleaseEvent(QMouseEvent* event) {
    if (!dragged_ && event->button() == Qt::LeftButton) {
        if (const auto spot = spot_under(event->localPos())) {
            state_.select(ray_of(diagram_, *spot));
        }
    }
}

void DiagramPane::wheelEvent(QWheelEvent* event) {
    zoom_by(std::pow(1.2, event->angleDelta().y() / 120.0), event->position());
    event->accept();
}

void DiagramPane::go(std::optional<std::size_t> ray) {
    if (ray) {
        state_.select(*ray);
    }
}

void DiagramPane::keyPressEvent(QKeyEvent* event) {
    if (!state_.tree()) {
        return;
    }
    const std::size_t ray = state_.selected()->id;
    switch (event->key()) {
        case Qt::Key_Up:
            return go(parent_of(*state_.tree(), ray));
        case Qt::Key_Down:
            return go(first_child_of(*state_.tree(), ray));
        case Qt::Key_Left:
            return go(sibling_of(*state_.tree(), ray, -1));
        case Qt::Key_Right:
            return go(sibling_of(*state_.tree(), ray, 1));
        case Qt::Key_Home:
            return go(0);
        default:
            QWidget::keyPressEvent(event);
    }
}

}  // namespace raytree::inspector
