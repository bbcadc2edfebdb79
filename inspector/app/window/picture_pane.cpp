#include "window/picture_pane.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "state/neighbours.h"
#include "state/numbers.h"
#include "tree/eight_bit.h"
#include "window/icons.h"
#include "window/qt_text.h"

namespace raytree::inspector {
namespace {

constexpr double largest_scale = 160;
constexpr double grid_from = 9;     // pixels of the pane to one of the picture's
constexpr double values_from = 44;  // likewise
constexpr double raw_values_from = 112;
constexpr double wheel_zoom = 1.4;  // a notch
constexpr double key_zoom = 2;
constexpr int margin = 8;

}  // namespace

PicturePane::PicturePane(State& state, PictureFeed& feed, QWidget* parent)
    : QWidget(parent), state_(state), feed_(feed) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::CrossCursor);
    setMinimumSize(160, 120);
    connect(&feed_, &PictureFeed::updated, this, &PicturePane::take_picture);
    state_.observe([this](const Changes& changes) {
        if (changes.document) {
            fit();
        } else if (changes.tree) {
            show_chosen();
        }
        if (changes.request) {
            obey(*changes.request);
        }
        draw_again();
    });
}

void PicturePane::obey(Request request) {
    if (request == Request::fit_picture) {
        fit();
    } else if (request == Request::picture_closer) {
        zoom_onto_chosen(key_zoom);
    } else if (request == Request::picture_further) {
        zoom_onto_chosen(1 / key_zoom);
    } else if (request == Request::picture_values) {
        show_values();
    }
}

/// What lies under the cursor may be something else, too, though it has not moved.
void PicturePane::draw_again() {
    update();
    Q_EMIT hovered(cursor_ ? pixel_at(*cursor_) : std::nullopt);
}

void PicturePane::take_picture() {
    const ShownPicture& shown = feed_.picture();
    // The feed's cells stay where they are until it has others, which it tells first.
    image_ = QImage(reinterpret_cast<const uchar*>(shown.cells.data()), shown.width, shown.height,
                    shown.width * 4, QImage::Format_RGB32)
                 .copy();
    if (fitted_) {
        fit();
    }
    draw_again();
}

QSizeF PicturePane::picture_size() const {
    if (!state_.document()) {
        return {1, 1};
    }
    const Camera& camera = state_.document()->scene().camera;
    return QSizeF(camera.width, camera.height);
}

void PicturePane::fit() {
    const QSizeF size = picture_size();
    scale_ =
        std::min((width() - 2 * margin) / size.width(), (height() - 2 * margin) / size.height());
    scale_ = std::min(std::max(scale_, 1e-3), largest_scale);
    origin_ =
        QPointF((width() - scale_ * size.width()) / 2, (height() - scale_ * size.height()) / 2);
    fitted_ = true;
    draw_again();
}

/// The picture does not get lost outside the pane; beyond its edge there is room for a frame.
void PicturePane::keep_in_place() {
    const QSizeF size = picture_size() * scale_;
    const auto kept = [](double at, double length, double room) {
        const double least = room - margin - length;
        return least >= margin ? (room - length) / 2
                               : std::clamp(at, least, static_cast<double>(margin));
    };
    origin_ = {kept(origin_.x(), size.width(), width()),
               kept(origin_.y(), size.height(), height())};
}

void PicturePane::zoom(double factor, QPointF about) {
    const QSizeF size = picture_size();
    const double whole = std::min(width() / size.width(), height() / size.height());
    const double scale =
        std::clamp(scale_ * factor, std::min(whole * 0.9, largest_scale), largest_scale);
    origin_ = about + (origin_ - about) * (scale / scale_);
    scale_ = scale;
    fitted_ = false;
    keep_in_place();
    draw_again();
}

void PicturePane::zoom_onto_chosen(double factor) {
    zoom(factor, place_of(state_.pixel()));
    show_chosen();
}

/// The chosen pixel in the middle, so large that the numbers in it and around it can be read.
void PicturePane::show_values() {
    origin_ += QRectF(rect()).center() - place_of(state_.pixel());
    zoom(raw_values_from / scale_, QRectF(rect()).center());
}

/// Moves the picture when the chosen pixel's square is not whole in the pane.
void PicturePane::show_chosen() {
    const QPointF at = place_of(state_.pixel());
    const double wanted = std::max(40.0, scale_ / 2 + margin);
    const double across = std::min(wanted, width() / 2.0), along = std::min(wanted, height() / 2.0);
    const QPointF inside(std::clamp(at.x(), across, width() - across),
                         std::clamp(at.y(), along, height() - along));
    if (!fitted_ && at != inside) {
        origin_ += inside - at;
        keep_in_place();
    }
}

std::optional<Pixel> PicturePane::pixel_at(QPointF place) const {
    const QPointF in = (place - origin_) / scale_;
    const Pixel pixel{static_cast<int>(std::floor(in.x())), static_cast<int>(std::floor(in.y()))};
    return state_.document() && state_.document()->contains(pixel) ? std::optional(pixel)
                                                                   : std::nullopt;
}

QRectF PicturePane::rect_of(Pixel pixel) const {
    return {origin_ + QPointF(pixel.i, pixel.j) * scale_, QSizeF(scale_, scale_)};
}

QPointF PicturePane::place_of(Pixel pixel) const { return rect_of(pixel).center(); }

void PicturePane::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Palette& palette = palette_of(state_.look().theme);
    painter.fillRect(rect(), qt(mixed(palette.window, palette.text, 0.08)));
    if (!state_.document() || image_.isNull()) {
        return;
    }
    painter.setRenderHint(QPainter::SmoothPixmapTransform, scale_ < 1.5);
    draw_image(painter);
    if (scale_ >= grid_from) {
        draw_grid(painter);
    }
    if (scale_ >= values_from) {
        draw_values(painter);
    }
    draw_neighbours(painter);
    draw_compared(painter);
    draw_cross(painter);
    draw_focus(painter, *this, palette);
}

/// The picture, or the overlay once it is there.
void PicturePane::draw_image(QPainter& painter) const {
    if (const auto& overlay = feed_.overlay()) {
        const QImage map(reinterpret_cast<const uchar*>(overlay->cells.data()), overlay->width,
                         overlay->height, overlay->width * 4, QImage::Format_RGB32);
        painter.drawImage(QRectF(origin_, picture_size() * scale_), map);
        return;
    }
    const double cell = scale_ * feed_.picture().stride;
    painter.drawImage(QRectF(origin_, QSizeF(image_.width() * cell, image_.height() * cell)),
                      image_);
}

void PicturePane::draw_grid(QPainter& painter) const {
    const QSizeF size = picture_size() * scale_;
    painter.setPen(QPen(QColor(128, 128, 128, 70), 1));
    const auto first = [this](double at) {  // the first line that can be seen
        return at + std::max(0.0, std::floor(-at / scale_)) * scale_;
    };
    const double first_x = first(origin_.x());
    for (double x = first_x; x < std::min<double>(width(), origin_.x() + size.width());
         x += scale_) {
        painter.drawLine(QPointF(x, origin_.y()), QPointF(x, origin_.y() + size.height()));
    }
    const double first_y = first(origin_.y());
    for (double y = first_y; y < std::min<double>(height(), origin_.y() + size.height());
         y += scale_) {
        painter.drawLine(QPointF(origin_.x(), y), QPointF(origin_.x() + size.width(), y));
    }
}

/// The 8-bit values in each pixel that is large enough.
void PicturePane::draw_values(QPainter& painter) const {
    QFont font = painter.font();
    const double line = scale_ >= raw_values_from ? 8 : 4.6;  // to a square
    font.setPixelSize(std::clamp(static_cast<int>(scale_ / line), 9, 18));
    painter.setFont(font);
    const auto first = (QPointF(0, 0) - origin_) / scale_;
    const auto last = (QPointF(width(), height()) - origin_) / scale_;
    for (int j = static_cast<int>(first.y()); j <= static_cast<int>(last.y()); ++j) {
        for (int i = static_cast<int>(first.x()); i <= static_cast<int>(last.x()); ++i) {
            bool bright = false;
            const QString value = value_in({i, j}, &bright);
            painter.setPen(bright ? QColor(0, 0, 0, 210) : QColor(255, 255, 255, 220));
            painter.drawText(rect_of({i, j}).adjusted(4, 2, -4, -2),
                             Qt::AlignCenter | Qt::TextWordWrap, value);
        }
    }
}

/// What is written into a pixel, and whether its colour is bright. An arrow points from a clamped
/// value to where it came from.
QString PicturePane::value_in(Pixel pixel, bool* bright) const {
    const auto is_bright = [](int r, int g, int b) { return 2 * r + 5 * g + b > 8 * 128; };
    if (!state_.document()->contains(pixel)) {
        return {};
    }
    if (const auto& overlay = feed_.overlay()) {
        const QRgb colour = overlay->cells[overlay->place_of(pixel)];
        *bright = is_bright(qRed(colour), qGreen(colour), qBlue(colour));
        return qt(value_text(*overlay, pixel));
    }
    const auto intensity = feed_.intensity(pixel);
    if (!intensity) {
        return {};
    }
    const EightBit shown = eight_bit(*intensity, state_.document()->scene().settings.quantize);
    *bright = is_bright(shown.value[0], shown.value[1], shown.value[2]);
    QStringList lines;
    const double raw[] = {intensity->r, intensity->g, intensity->b};
    const std::vector<std::string> raw_texts = aligned(*intensity, 3);
    for (std::size_t c = 0; c < 3; ++c) {
        QString value = QString::number(shown.value[c]);
        if (shown.clamped[c]) {
            value += raw[c] > 1 ? QStringLiteral("↑") : QStringLiteral("↓");
        }
        lines << (scale_ < raw_values_from ? value
                                           : qt(raw_texts[c]) + QStringLiteral(" → ") + value);
    }
    return lines.join(QLatin1Char('\n'));
}

/// A frame around the pixels whose trees are shown beside the chosen one's.
void PicturePane::draw_neighbours(QPainter& painter) const {
    QRectF frame = rect_of(state_.pixel());
    for (const Pixel pixel : neighbours_of(state_.pixel(), state_.look().neighbours,
                                           state_.document()->scene().camera)) {
        frame |= rect_of(pixel);
    }
    if (frame == rect_of(state_.pixel())) {
        return;
    }
    // Where pixels are small, outside the mark of the chosen one.
    const double across = std::max(3.0, 8 - frame.width() / 2),
                 along = std::max(3.0, 8 - frame.height() / 2);
    frame.adjust(-across, -along, across, along);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(255, 255, 255, 235), 3.2));
    painter.drawRoundedRect(frame, 3, 3);
    painter.setPen(QPen(QColor(16, 21, 27), 1.2, Qt::DashLine));
    painter.drawRoundedRect(frame, 3, 3);
}

/// Dark within light, so that it shows on any colour.
void PicturePane::draw_cross(QPainter& painter) const {
    constexpr double least = 7, arm = 15;
    QRectF box = rect_of(state_.pixel());
    if (box.width() < least) {
        const QPointF middle = box.center();
        box = QRectF(middle - QPointF(least / 2, least / 2), QSizeF(least, least));
    }
    box.adjust(-1, -1, 1, 1);
    const QPointF c = box.center();
    const auto draw = [&](const QColor& colour, double width) {
        painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(box);
        if (scale_ >= values_from) {
            return;  // the arms would cross out the numbers beside it
        }
        const double gap = 2;
        painter.drawLine(QPointF(box.left() - gap, c.y()), QPointF(box.left() - arm, c.y()));
        painter.drawLine(QPointF(box.right() + gap, c.y()), QPointF(box.right() + arm, c.y()));
        painter.drawLine(QPointF(c.x(), box.top() - gap), QPointF(c.x(), box.top() - arm));
        painter.drawLine(QPointF(c.x(), box.bottom() + gap), QPointF(c.x(), box.bottom() + arm));
    };
    painter.setRenderHint(QPainter::Antialiasing);
    draw(QColor(255, 255, 255, 235), 3.6);
    draw(QColor(16, 21, 27), 1.4);
}

/// The pixel that others are compared with, by a letter beside it.
void PicturePane::draw_compared(QPainter& painter) const {
    const auto pixel = state_.compared_pixel();
    if (!pixel) {
        return;
    }
    const QPointF at = rect_of(*pixel).center();
    const QRectF tag(at + QPointF(5, -21), QSizeF(16, 16));
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(255, 255, 255, 235), 1.4));
    painter.setBrush(QColor(16, 21, 27));
    painter.drawLine(at, tag.bottomLeft() + QPointF(2, -2));
    painter.drawEllipse(at, 2.5, 2.5);
    painter.drawRoundedRect(tag, 3, 3);
    painter.drawText(tag, Qt::AlignCenter, QStringLiteral("A"));
}

void PicturePane::resizeEvent(QResizeEvent*) {
    if (fitted_) {
        fit();
    } else {
        keep_in_place();
        show_chosen();
        draw_again();
    }
}

void PicturePane::mousePressEvent(QMouseEvent* event) {
    grabbed_ = event->localPos();
    moving_ = event->button() != Qt::LeftButton;
    if (const auto pixel = pixel_at(event->localPos()); pixel && !moving_) {
        state_.pick(*pixel);
    }
}

void PicturePane::mouseMoveEvent(QMouseEvent* event) {
    cursor_ = event->localPos();
    const auto pixel = pixel_at(event->localPos());
    if (event->buttons() != Qt::NoButton && moving_) {
        origin_ += event->localPos() - grabbed_;
        grabbed_ = event->localPos();
        fitted_ = false;
        keep_in_place();
    } else if (pixel && (event->buttons() & Qt::LeftButton)) {
        state_.pick(*pixel, Pick::on_the_way);
    }
    draw_again();
}

void PicturePane::mouseReleaseEvent(QMouseEvent*) { moving_ = false; }

void PicturePane::leaveEvent(QEvent*) {
    cursor_.reset();
    draw_again();
}

void PicturePane::wheelEvent(QWheelEvent* event) {
    cursor_ = event->position();
    zoom(std::pow(wheel_zoom, event->angleDelta().y() / 120.0), event->position());
    event->accept();
}

}  // namespace raytree::inspector
