#include "window/scene_overlay.h"

#include <QPainter>
#include <algorithm>
#include <array>

#include "drawing/explained_mesh.h"
#include "drawing/ray_mesh.h"
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

/// Where the names of a thing may stand, beside its mark, the best first.
std::array<QRectF, 4> places_beside(QPointF at, QSizeF size) {
    constexpr double off = 12;
    const double w = size.width(), h = size.height();
    return {QRectF(at + QPointF(off, -h / 2), size), QRectF(at + QPointF(-off - w, -h / 2), size),
            QRectF(at + QPointF(-w / 2, -off - h), size), QRectF(at + QPointF(-w / 2, off), size)};
}

}  // namespace

SceneOverlay::SceneOverlay(const State& state, const View& view, QWidget* parent)
    : QWidget(parent), state_(state), view_(view) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
}

void SceneOverlay::set_labels(std::vector<SceneLabel> labels) {
    labels_ = std::move(labels);
    update();
}

void SceneOverlay::set_note(const QString& note) { note_ = note; }

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
    const QSizeF size(widest + 2 * pad, y + line + pad);
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
    if (!note_.isEmpty()) {
        painter.setPen(qt(palette.dim_text));
        painter.drawText(box.topLeft() - QPointF(0, 6), note_);
    }
    return box;
}

void SceneOverlay::draw_labels(QPainter& painter, QRectF legend_box) const {
    const Palette& palette = palette_of(state_.look().theme);
    std::vector<QRectF> taken = {legend_box};
    const QRectF all = rect();
    for (const SceneLabel& label : labels_) {
        const auto at = project(view_, label.at);
        if (!at || !all.contains(QPointF(at->x, at->y))) {
            continue;
        }
        QFont font = painter.font();
        font.setBold(label.strong);
        const QFontMetricsF metrics(font);
        const QSizeF size(metrics.horizontalAdvance(label.text) + 8, metrics.height() + 2);
        for (const QRectF& place : places_beside({at->x, at->y}, size)) {
            const bool free = all.contains(place) && std::ranges::none_of(taken, [&](auto& other) {
                                  return other.intersects(place);
                              });
            if (free) {
                painter.setPen(Qt::NoPen);
                painter.setBrush(qt(palette.panel, 190));
                painter.drawRoundedRect(place, 3, 3);
                painter.save();
                painter.setFont(font);
                painter.setPen(qt(palette.text));
                painter.drawText(place, Qt::AlignCenter, label.text);
                painter.restore();
                taken.push_back(place);
                break;
            }
        }
    }
}

std::vector<SceneLabel> scene_labels(const State& state, const Extent& extent, bool from_the_eye) {
    std::vector<SceneLabel> labels;
    if (!state.document()) {
        return labels;
    }
    const Scene& scene = state.document()->scene();
    const TreeRay<double>* const ray = state.selected();
    if (ray && ray->hit) {
        labels.push_back({ray->hit->point, qt(ray->hit->object), true});
        labels.push_back({normal_tip(*ray->hit, extent), QStringLiteral("n"), false});
    } else if (ray && ray->shadow && ray->shadow->blocked_by) {
        labels.push_back({along(ray->origin, ray->shadow->blocked_by->t, ray->direction),
                          qt(ray->shadow->blocked_by->object), true});
    }
    for (const ExplainedMark& mark : explained_marks(state, extent)) {
        labels.push_back({mark.at, qt(mark.words), true});
    }
    for (const Light& light : scene.lights) {
        labels.push_back({place_of(light, extent), qt(light.name), false});
    }
    if (!from_the_eye) {
        labels.push_back({scene.camera.eye, QStringLiteral("eye"), false});
        labels.push_back({picture_corners(*state.document(), extent.plane_distance)[0],
                          QStringLiteral("picture"), false});
    }
    return labels;
}

}  // namespace raytree::inspector
