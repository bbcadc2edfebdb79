#include "window/scene_overlay.h"

#include <QPainter>
#include <algorithm>
#include <array>

#include "drawing/picking.h"
#include "drawing/ray_mesh.h"
#include "drawing/words.h"
#include "window/icons.h"
#include "window/qt_text.h"

namespace raytree::inspector {
namespace {

constexpr int pad = 6;

struct LegendEntry {
    std::optional<RayLook> look;  ///< none: an escaped ray's ring
    QString text;
};

const std::array<LegendEntry, 6>& legend() {
    static const std::array<LegendEntry, 6> entries = {{
        {RayLook::primary, QStringLiteral("primary")},
        {RayLook::reflected, QStringLiteral("reflected")},
        {RayLook::refracted, QStringLiteral("refracted")},
        {RayLook::lit, QStringLiteral("shadow, reaches light")},
        {RayLook::blocked, QStringLiteral("shadow, blocked")},
        {std::nullopt, QStringLiteral("meets nothing")},
    }};
    return entries;
}

Point3 middle_of(const std::vector<Point3>& points) {
    Point3 sum(0);
    for (const Point3& p : points) {
        sum += p;
    }
    return points.empty() ? sum : sum / static_cast<double>(points.size());
}

WordBox box_of(const QRectF& r) { return {r.x(), r.y(), r.width(), r.height()}; }

}  // namespace

SceneOverlay::SceneOverlay(const State& state, const View& view, QWidget* parent)
    : QWidget(parent), state_(state), view_(view) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
}

void SceneOverlay::set_labels(std::vector<SceneLabel> labels) { labels_ = std::move(labels); }

void SceneOverlay::set_notes(const QStringList& notes) {
    notes_ = notes;
    update();
}

void SceneOverlay::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF box = draw_legend(painter);
    if (state_.look().names) {
        draw_labels(painter, box);
    }
}

/// In rows along the lower edge, as many as the width asks for.
QRectF SceneOverlay::draw_legend(QPainter& painter) const {
    const Palette& palette = palette_of(state_.look().theme);
    const QFontMetricsF metrics(painter.font());
    constexpr double sign = 24, gap = 5, between = 16;
    const double line = metrics.height() + 4;
    std::vector<QPointF> places;
    double x = 0, y = 0, widest = 0;
    for (const LegendEntry& entry : legend()) {
        const double width = sign + gap + metrics.horizontalAdvance(entry.text);
        if (x > 0 && x + width > this->width() - 4 * pad) {
            x = 0;
            y += line;
        }
        places.emplace_back(x, y);
        widest = std::max(widest, x + width);
        x += width + between;
    }
    const double below = line * notes_.size();
    for (const QString& note : notes_) {
        const double room = this->width() - 4 * pad;
        widest = std::max(widest, std::min(room, metrics.horizontalAdvance(note)));
    }
    const QSizeF size(widest + 2 * pad, y + line + below + pad);
    const QRectF box(QPointF(pad, height() - pad - size.height()), size);
    painter.setPen(QPen(qt(palette.rule), 1));
    painter.setBrush(qt(palette.panel, 225));
    painter.drawRoundedRect(box, 4, 4);
    for (std::size_t k = 0; k < places.size(); ++k) {
        const LegendEntry& entry = legend()[k];
        const QPointF at = box.topLeft() + places[k] + QPointF(pad, pad / 2.0);
        const QRectF sign_box(at + QPointF(0, (line - 16) / 2), QSizeF(sign, 16));
        if (entry.look) {
            draw_sign(painter, sign_box, *entry.look, palette);
        } else {
            painter.setBrush(Qt::NoBrush);
            painter.setPen(QPen(qt(palette.text), 1.8));
            painter.drawEllipse(sign_box.center(), 4, 4);
        }
        painter.setPen(qt(palette.text));
        painter.drawText(QRectF(at + QPointF(sign + gap, 0), QSizeF(400, line)),
                         Qt::AlignLeft | Qt::AlignVCenter, entry.text);
    }
    draw_notes(painter, QRectF(box.left() + pad, box.bottom() - pad / 2.0 - below,
                               box.width() - 2 * pad, below));
    return box;
}

void SceneOverlay::draw_notes(QPainter& painter, QRectF lines) const {
    const QFontMetricsF metrics(painter.font());
    const double line = notes_.isEmpty() ? 0 : lines.height() / notes_.size();
    painter.setPen(qt(palette_of(state_.look().theme).text));
    for (int k = 0; k < notes_.size(); ++k) {
        painter.drawText(QRectF(lines.left(), lines.top() + k * line, lines.width(), line),
                         Qt::AlignLeft | Qt::AlignVCenter,
                         metrics.elidedText(notes_[k], Qt::ElideRight, lines.width()));
    }
}

void SceneOverlay::draw_labels(QPainter& painter, QRectF legend_box) const {
    std::vector<WordBox> taken = {box_of(legend_box)};
    const WordBox room = box_of(rect());
    for (const SceneLabel& label : labels_) {
        const auto at = project(view_, label.at);
        if (!at || !room.holds({at->x, at->y, 0, 0})) {
            continue;
        }
        QFont font = painter.font();
        font.setBold(label.strong);
        const QFontMetricsF metrics(font);
        WordWish wish{at->x, at->y, std::nullopt, metrics.horizontalAdvance(label.text) + 8,
                      metrics.height() + 2};
        if (const auto out = label.out ? project(view_, *label.out) : std::nullopt) {
            wish.out = {out->x, out->y};
            wish.far = label.strong ? 150 : 45;
        }
        if (const auto place = place_words(wish, room, taken)) {
            const QRectF box(place->x, place->y, place->width, place->height);
            if (wish.out) {
                draw_leader(painter, {at->x, at->y}, box);
            }
            draw_label(painter, label, box);
            taken.push_back(*place);
        }
    }
}

/// From a place to the words that had to stand apart from it.
void SceneOverlay::draw_leader(QPainter& painter, QPointF from, const QRectF& box) const {
    const QPointF to(std::clamp(from.x(), box.left(), box.right()),
                     std::clamp(from.y(), box.top(), box.bottom()));
    if ((to - from).manhattanLength() > 10) {
        painter.setPen(QPen(qt(palette_of(state_.look().theme).dim_text), 1));
        painter.drawLine(from, to);
    }
}

void SceneOverlay::draw_label(QPainter& painter, const SceneLabel& label,
                              const QRectF& place) const {
    const Palette& palette = palette_of(state_.look().theme);
    painter.save();
    painter.setPen(Qt::NoPen);
    painter.setBrush(qt(palette.panel, 205));
    painter.drawRoundedRect(place, 3, 3);
    QFont font = painter.font();
    font.setBold(label.strong);
    painter.setFont(font);
    painter.setPen(qt(palette.text));
    painter.drawText(place, Qt::AlignCenter, label.text);
    painter.restore();
}

std::vector<SceneLabel> scene_labels(const State& state, const Extent& extent, const View& view,
                                     bool from_the_eye) {
    std::vector<SceneLabel> labels;
    if (!state.document()) {
        return labels;
    }
    const Scene& scene = state.document()->scene();
    const TreeRay<double>* const ray = state.selected();
    if (state.thing() && state.thing()->kind == Thing::Kind::object) {
        const Point3 at = middle_of(corners_of(*state.document(), extent, *state.thing()));
        labels.push_back({at, qt(name_of(scene, *state.thing())), true});
    }
    if (ray && ray->hit) {
        if (object_named(scene, ray->hit->object) != state.thing()) {
            labels.push_back({ray->hit->point, qt(ray->hit->object), true});
        }
        labels.push_back({normal_tip(*ray->hit, extent, view), QStringLiteral("n"), false});
    } else if (ray && ray->shadow && ray->shadow->blocked_by) {
        labels.push_back({along(ray->origin, ray->shadow->blocked_by->t, ray->direction),
                          qt(ray->shadow->blocked_by->object), true});
    }
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        const bool chosen = state.thing() == Thing{Thing::Kind::light, k};
        labels.push_back({place_of(scene.lights[k], extent), qt(scene.lights[k].name), chosen});
    }
    if (!from_the_eye) {
        labels.push_back({scene.camera.eye, QStringLiteral("eye"), false});
        labels.push_back({picture_corners(*state.document(), extent.plane_distance)[0],
                          QStringLiteral("picture"), false});
    }
    return labels;
}

}  // namespace raytree::inspector
