#include "window/overlay_legend.h"

#include <QPainter>
#include <algorithm>

#include "window/qt_text.h"

namespace raytree::inspector {
namespace {

constexpr int margin = 8, bar_height = 10;
constexpr int swatch_room = 19, share_room = 14;  // before and after a kind's name

QColor colour_of(const Colour8& c) { return {c[0], c[1], c[2]}; }

/// "62 %"; what is less than half of one is "< 1 %".
QString percent(std::size_t part, std::size_t whole) {
    const double share = 100.0 * static_cast<double>(part) / static_cast<double>(whole);
    return share < 0.5 ? QStringLiteral("< 1 %") : QStringLiteral("%1 %").arg(qRound(share));
}

}  // namespace

OverlayLegend::OverlayLegend(State& state, PictureFeed& feed, QWidget* parent)
    : QWidget(parent), state_(state), feed_(feed) {
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    hide();
    connect(&feed_, &PictureFeed::updated, this, &OverlayLegend::renew);
    state_.observe([this](const Changes& changes) {
        if (changes.look || changes.explained || changes.tree || changes.document) {
            renew();
        }
    });
}

void OverlayLegend::renew() {
    setVisible(feed_.overlaid());
    updateGeometry();
    update();
}

int OverlayLegend::line() const { return fontMetrics().height() + 2; }

QSize OverlayLegend::sizeHint() const {
    const auto& overlay = feed_.overlay();
    const bool kinds = overlay && !overlay->kinds.empty();
    const int columns = kinds ? kind_columns(*overlay) : 1;
    const int count = kinds ? static_cast<int>(overlay->kinds.size()) : 0;
    const int body = kinds ? line() * ((count + columns - 1) / columns) : bar_height + 6 + line();
    return {200, margin + line() + 4 + body + margin / 2};
}

void OverlayLegend::resizeEvent(QResizeEvent*) { updateGeometry(); }

int OverlayLegend::kind_columns(const Overlay& overlay) const {
    int widest = 0;
    for (const OverlayKind& kind : overlay.kinds) {
        widest = std::max(widest, fontMetrics().horizontalAdvance(qt(kind.name)) +
                                      fontMetrics().horizontalAdvance(
                                          percent(kind.pixels, overlay.values.size())));
    }
    return 2 * (widest + swatch_room + share_room) <= width() - 2 * margin ? 2 : 1;
}

void OverlayLegend::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Palette& palette = palette_of(state_.look().theme);
    painter.setPen(qt(palette.text));
    const QRect title(margin, margin, width() - 2 * margin, line());
    const auto draw_title = [&](const QString& text) {
        painter.drawText(title, Qt::AlignLeft | Qt::AlignVCenter,
                         fontMetrics().elidedText(text, Qt::ElideRight, title.width()));
    };
    const auto& overlay = feed_.overlay();
    if (!overlay) {
        draw_title(feed_.overlay_failed()
                       ? QStringLiteral("This cannot be measured.")
                       : QStringLiteral("Measuring… %1 %")
                             .arg(static_cast<int>(100 * feed_.overlay_share())));
        return;
    }
    draw_title(qt(title_of(*overlay)));
    overlay->kinds.empty() ? draw_scale(painter, *overlay) : draw_kinds(painter, *overlay);
}

/// A bar from the least value to the most, and under it a mark with the chosen pixel's value.
void OverlayLegend::draw_scale(QPainter& painter, const Overlay& overlay) const {
    const Palette& palette = palette_of(state_.look().theme);
    const MapRange& range = overlay.range;
    const QRect bar(margin, margin + line() + 4, width() - 2 * margin, bar_height);
    for (int x = 0; x < bar.width(); ++x) {
        const double share = static_cast<double>(x) / std::max(1, bar.width() - 1);
        painter.fillRect(bar.left() + x, bar.top(), 1, bar.height(),
                         colour_of(scale_colour(range.most > range.least ? share : 0)));
    }
    const double value = overlay.at(state_.pixel());
    const double share =
        range.most > range.least
            ? std::clamp((value - range.least) / (range.most - range.least), 0.0, 1.0)
            : 0;
    const double x = bar.left() + share * (bar.width() - 1);
    const double y = bar.bottom() + 2;
    painter.setPen(Qt::NoPen);
    painter.setBrush(qt(palette.text));
    painter.drawPolygon(QPolygonF({{x, y - 3}, {x - 5, y + 5}, {x + 5, y + 5}}));

    const QRect below(bar.left(), bar.bottom() + 6, bar.width(), line());
    const QString least = qt(amount_text(overlay, range.least));
    const QString most = (range.beyond > range.most ? QStringLiteral("≥ ") : QString()) +
                         qt(amount_text(overlay, range.most));
    const QString here = QStringLiteral("this pixel: ") + qt(value_text(overlay, state_.pixel()));
    painter.setPen(qt(palette.dim_text));
    painter.drawText(below, Qt::AlignLeft | Qt::AlignVCenter, least);
    painter.drawText(below, Qt::AlignRight | Qt::AlignVCenter, most);
    painter.setPen(qt(palette.text));
    painter.drawText(below, Qt::AlignHCenter | Qt::AlignVCenter, here);
}

/// The most frequent kind first; the chosen pixel's has a frame.
void OverlayLegend::draw_kinds(QPainter& painter, const Overlay& overlay) const {
    const Palette& palette = palette_of(state_.look().theme);
    const int columns = kind_columns(overlay);
    const int column = (width() - 2 * margin) / columns;
    const OverlayKind* const chosen = overlay.kind_at(state_.pixel());
    for (std::size_t k = 0; k < overlay.kinds.size(); ++k) {
        const OverlayKind& kind = overlay.kinds[k];
        const int place = static_cast<int>(k);
        const QRect row(margin + place % columns * column,
                        margin + line() * (1 + place / columns) + 4, column - 6, line());
        const QRect swatch(row.left() + 3, row.top() + (row.height() - 10) / 2, 10, 10);
        painter.fillRect(swatch, colour_of(kind.colour));
        if (&kind == chosen) {
            painter.setPen(QPen(qt(palette.text), 1.2));
            painter.setBrush(Qt::NoBrush);
            painter.drawRoundedRect(QRectF(row).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
        }
        const QString share = percent(kind.pixels, overlay.values.size());
        const int room =
            row.width() - swatch_room - fontMetrics().horizontalAdvance(share) - share_room + 6;
        painter.setPen(qt(palette.text));
        painter.drawText(row.adjusted(swatch_room, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                         fontMetrics().elidedText(qt(kind.name), Qt::ElideRight, room));
        painter.setPen(qt(palette.dim_text));
        painter.drawText(row.adjusted(0, 0, -5, 0), Qt::AlignRight | Qt::AlignVCenter, share);
    }
}

}  // namespace raytree::inspector
