#include "window/scene_overlay.h"

#include <QPainter>
#include <algorithm>
#include <array>

#include "window/icons.h"
#include "window/qt_text.h"

namespace raytree::inspector {
namespace {

constexpr int pad = 6;
constexpr double sign_width = 24, gap = 5;  // of the legend's entries

}  // namespace

SceneOverlay::SceneOverlay(const State& state, QWidget* parent) : QWidget(parent), state_(state) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
}

void SceneOverlay::set_labels(const View& view, std::vector<SceneLabel> labels,
                              std::vector<WordLine> lines) {
    view_ = view;
    labels_ = std::move(labels);
    lines_ = std::move(lines);
    update();
}

void SceneOverlay::take_words_of(const SceneOverlay& other) {
    legend_ = other.legend_;
    notes_ = other.notes_;
    setFont(other.font());
}

void SceneOverlay::set_legend(const SceneLegend& legend) {
    legend_ = legend;
    update();
}

void SceneOverlay::set_notes(const QStringList& notes) {
    if (notes_ != notes) {
        notes_ = notes;
        update();
    }
}

void SceneOverlay::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF box = draw_legend(painter);
    if (state_.look().names) {
        draw_labels(painter, box);
    }
    if (parentWidget()) {
        draw_focus(painter, *parentWidget(), palette_of(state_.look().theme));
    }
}

std::vector<SceneOverlay::Entry> SceneOverlay::entries() const {
    static const std::array<QString, look_count> names = {
        QStringLiteral("primary"), QStringLiteral("reflected"), QStringLiteral("refracted"),
        QStringLiteral("shadow, lit"), QStringLiteral("shadow, blocked")};
    std::vector<Entry> all;
    for (std::size_t k = 0; k < look_count; ++k) {
        if (legend_.looks[k]) {
            all.push_back({static_cast<RayLook>(k), names[k], false, legend_.dimmed[k]});
        }
    }
    if (legend_.open) {
        all.push_back({std::nullopt, QStringLiteral("meets nothing")});
    }
    if (legend_.unsent) {
        all.push_back({std::nullopt, QStringLiteral("not sent"), true});
    }
    return all;
}

/// In rows along the lower edge, as many as the width asks for.
SceneOverlay::Layout SceneOverlay::layout(const QFontMetricsF& metrics, int width) const {
    constexpr double between = 14;
    Layout out;
    out.line = metrics.height() + 4;
    const double room = width - 4 * pad;
    double x = 0, y = 0, widest = 0;
    const std::vector<Entry> all = entries();
    for (const Entry& entry : all) {
        const double wide = sign_width + gap + metrics.horizontalAdvance(entry.text);
        if (x > 0 && x + wide > room) {
            x = 0;
            y += out.line;
        }
        out.places.emplace_back(x, y);
        widest = std::max(widest, x + wide);
        x += wide + between;
    }
    for (int k = 0; k < notes_.size(); ++k) {
        const double wide = metrics.horizontalAdvance(notes_[k]);
        const bool beside = k == 0 && x > 0 && x + wide <= room;
        out.notes.push_back(beside ? QPointF(x, y)
                                   : QPointF(0, all.empty() && k == 0 ? 0 : y + out.line));
        y = out.notes.back().y();
        widest = std::max(widest, std::min(room, out.notes.back().x() + wide));
    }
    const double rows = all.empty() && notes_.isEmpty() ? 0 : y + out.line;
    out.size = rows > 0 ? QSizeF(widest + 2 * pad, rows + pad) : QSizeF(0, 0);
    return out;
}

int SceneOverlay::foot(int width) const {
    const double height = layout(QFontMetricsF(font()), width).size.height();
    return height > 0 ? static_cast<int>(height) + 2 * pad : 0;
}

QRectF SceneOverlay::draw_legend(QPainter& painter) const {
    const Palette& palette = palette_of(state_.look().theme);
    const auto [places, notes, size, line] = layout(QFontMetricsF(painter.font()), width());
    constexpr double most = 0.6;  // of the height: a very small image shows the scene instead
    if (size.isEmpty() || size.height() > most * height()) {
        return {};
    }
    const QRectF box(QPointF(pad, height() - pad - size.height()), size);
    painter.setPen(QPen(qt(palette.rule), 1));
    painter.setBrush(qt(palette.panel, 225));
    painter.drawRoundedRect(box, 4, 4);
    const std::vector<Entry> all = entries();
    for (std::size_t k = 0; k < all.size(); ++k) {
        const QPointF at = box.topLeft() + places[k] + QPointF(pad, pad / 2.0);
        draw_entry(painter, all[k], {at, QSizeF(400, line)});
    }
    const QFontMetricsF metrics(painter.font());
    painter.setPen(qt(palette.text));
    for (int k = 0; k < notes_.size(); ++k) {
        const QPointF at =
            box.topLeft() + notes[static_cast<std::size_t>(k)] + QPointF(pad, pad / 2.0);
        const double room = box.right() - pad - at.x();
        painter.drawText(QRectF(at, QSizeF(room, line)), Qt::AlignLeft | Qt::AlignVCenter,
                         metrics.elidedText(notes_[k], Qt::ElideRight, room + 1));
    }
    return box;
}

void SceneOverlay::draw_entry(QPainter& painter, const Entry& entry, const QRectF& place) const {
    const Palette& palette = palette_of(state_.look().theme);
    const QRectF sign(place.left(), place.center().y() - 8, sign_width, 16);
    if (entry.look) {
        painter.setOpacity(entry.dimmed ? 0.35 : 1);  // as the rays are
        draw_sign(painter, sign, *entry.look, palette);
        painter.setOpacity(1);
    } else if (entry.dotted) {
        painter.setPen(QPen(qt(palette.dim_text), 2, Qt::DotLine));
        painter.drawLine(QPointF(sign.left() + 1, sign.center().y()),
                         QPointF(sign.right() - 3, sign.center().y()));
    } else {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(qt(palette.text), 1.8));
        painter.drawEllipse(sign.center(), 4, 4);
    }
    painter.setPen(qt(entry.dimmed ? palette.dim_text : palette.text));
    painter.drawText(place.adjusted(sign_width + gap, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                     entry.text);
}

}  // namespace raytree::inspector
