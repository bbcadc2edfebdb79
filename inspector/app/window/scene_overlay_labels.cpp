#include <QPainter>
#include <algorithm>
#include <array>
#include <tuple>

#include "drawing/edge_place.h"
#include "state/commands.h"
#include "window/qt_text.h"
#include "window/scene_overlay.h"

/// The overlay's part in names beside things, and in arrows to those that are outside.
namespace raytree::inspector {
namespace {

WordBox word_box(const QRectF& r) { return {r.x(), r.y(), r.width(), r.height()}; }

}  // namespace

void SceneOverlay::draw_labels(QPainter& painter, QRectF legend_box) const {
    std::vector<WordBox> taken = {word_box(legend_box)};
    const WordBox room = word_box(rect());
    for (const SceneLabel& label : labels_) {
        const auto at = project(view_, label.at);
        if (!at || !room.holds({at->x, at->y, 0, 0})) {
            if (!label.away.isEmpty()) {
                draw_away(painter, label, taken);
            }
            continue;
        }
        if (label.hidden) {
            draw_through(painter, label, {at->x, at->y});
        }
        if (label.text.isEmpty()) {
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
        if (const auto place = place_words(wish, room, taken, lines_)) {
            const QRectF box(place->x, place->y, place->width, place->height);
            if (wish.out) {
                draw_leader(painter, {at->x, at->y}, box);
            }
            draw_label(painter, label, box);
            taken.push_back(*place);
        }
    }
}

/// What a solid shape hides is drawn through it, in dashes.
void SceneOverlay::draw_through(QPainter& painter, const SceneLabel& label, QPointF at) const {
    const Palette& palette = palette_of(state_.look().theme);
    const auto stem = label.stem ? project(view_, *label.stem) : std::nullopt;
    for (const auto& [colour, width, style] :
         {std::tuple{qt(palette.panel, 160), 3.5, Qt::SolidLine},
          {qt(palette.text), 1.5, Qt::DashLine}}) {
        painter.setPen(QPen(colour, width, style));
        painter.setBrush(Qt::NoBrush);
        if (stem) {
            painter.drawLine(QPointF(stem->x, stem->y), at);
        } else if (label.ringed) {
            painter.drawEllipse(at, 5, 5);
        }
    }
}

/// An arrow at the edge towards what is outside and its name; of what is selected, too, the key
/// that shows it.
void SceneOverlay::draw_away(QPainter& painter, const SceneLabel& label,
                             std::vector<WordBox>& taken) const {
    constexpr double edge = 14;
    const double size = label.strong ? 8 : 5.5;
    const double foot = taken.front().height > 0 ? height() - taken.front().y : 0;
    const WordBox frame{edge, edge, width() - 2 * edge, height() - foot - 2 * edge};
    const auto place = label.seen_from ? edge_place(view_, frame, label.at, *label.seen_from)
                                       : edge_place(view_, frame, label.at);
    if (!place) {
        return;
    }
    const Palette& palette = palette_of(state_.look().theme);
    painter.setPen(QPen(qt(palette.panel), 1.5));
    painter.setBrush(qt(label.strong ? palette.selection : palette.light));
    const QPointF ahead(place->dx, place->dy), aside(-place->dy, place->dx);
    const QPointF tip = QPointF(place->x, place->y) + ahead * size;
    const QPointF foot_of_tip = tip - ahead * 2 * size;
    painter.drawPolygon(QPolygonF({tip, foot_of_tip + aside * size, foot_of_tip - aside * size}));

    SceneLabel words = label;
    words.text = label.away;
    if (label.strong && parentWidget()) {  // not in an exported image
        const QString key = qt(find_command("view.fit_selection")->keys);
        words.text += QStringLiteral(", outside: %1 shows it").arg(key);
    }
    QFont font = painter.font();
    font.setBold(label.strong);
    const QFontMetricsF metrics(font);
    const std::array<double, 2> inwards = {foot_of_tip.x() - place->dx,
                                           foot_of_tip.y() - place->dy};
    const WordWish wish{foot_of_tip.x(), foot_of_tip.y(), inwards,
                        metrics.horizontalAdvance(words.text) + 8, metrics.height() + 2};
    if (const auto box = place_words(wish, word_box(rect()), taken, lines_)) {
        draw_label(painter, words, QRectF(box->x, box->y, box->width, box->height));
        taken.push_back(*box);
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
    painter.setPen(label.hidden ? QPen(qt(palette.dim_text), 1, Qt::DashLine) : QPen(Qt::NoPen));
    painter.setBrush(qt(palette.panel, 205));
    painter.drawRoundedRect(place, 3, 3);
    QFont font = painter.font();
    font.setBold(label.strong);
    painter.setFont(font);
    painter.setPen(qt(label.hidden ? palette.dim_text : palette.text));
    painter.drawText(place, Qt::AlignCenter, label.text);
    painter.restore();
}

}  // namespace raytree::inspector
