#include "window/explained_pictures.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "window/qt_text.h"

namespace raytree::inspector {
namespace {

QFont small_font() {
    QFont font;
    font.setPixelSize(12);
    return font;
}

QString percent(double share) { return QStringLiteral("%1 %").arg(std::lround(100 * share)); }

/// Nearest and farthest of what the light sees on one side.
std::pair<double, double> extremes(const DepthPicture& picture, std::size_t side) {
    double near = 1e300, far = 0;
    for (int j = 0; j < picture.size(); ++j) {
        for (int i = 0; i < picture.size(); ++i) {
            if (const double depth = picture.depth({side, i, j}); std::isfinite(depth)) {
                near = std::min(near, depth);
                far = std::max(far, depth);
            }
        }
    }
    return {near, far};
}

/// A ring around the pixel, so that it is found at any size.
void mark(QPainter& painter, QPointF middle, double pixel, const Palette& palette) {
    const double side = std::max(pixel, 5.0);
    const QRectF box(middle.x() - side / 2, middle.y() - side / 2, side, side);
    painter.setPen(QPen(qt(palette.selection), 2));
    painter.drawRect(box.adjusted(-1, -1, 1, 1));
    painter.drawEllipse(middle, side / 2 + 7, side / 2 + 7);
}

/// A scale of powers of ten along one axis.
struct LogAxis {
    int least = 0, most = 1;  ///< exponents
    double from = 0, to = 1;  ///< places on the picture

    double place(double value) const {
        const double share = (std::log10(value) - least) / std::max(1, most - least);
        return from + share * (to - from);
    }
};

/// The powers of ten around values above 0.
std::pair<int, int> powers_around(const std::vector<double>& values) {
    double least = 1e300, most = 0;
    for (const double value : values) {
        if (value > 0) {
            least = std::min(least, value);
            most = std::max(most, value);
        }
    }
    if (most == 0) {
        return {-1, 0};
    }
    return {static_cast<int>(std::floor(std::log10(least))),
            static_cast<int>(std::floor(std::log10(most))) + 1};
}

QString power_text(int exponent) {
    static const QString digits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    QString text = exponent < 0 ? QStringLiteral("10⁻") : QStringLiteral("10");
    for (const QChar digit : QString::number(std::abs(exponent))) {
        text += digits[digit.digitValue()];
    }
    return text;
}

/// Draws the points of a WorkPrecision into one picture.
class AccuracyDrawing {
  public:
    AccuracyDrawing(const WorkPrecision& measured, QImage& image, const Palette& palette)
        : measured_(measured), palette_(palette), painter_(&image) {
        painter_.setRenderHint(QPainter::Antialiasing);
        painter_.setFont(small_font());
        plot_ = QRectF(52, 8, image.width() - 74, image.height() - 50);
        std::vector<double> times, errors;
        for (const auto* const points : {&measured.arithmetics, &measured.levels}) {
            for (const WorkPoint& point : *points) {
                times.push_back(1e6 * point.seconds);
                errors.push_back(point.error);
            }
        }
        const auto [least_time, most_time] = powers_around(times);
        const auto [least_error, most_error] = powers_around(errors);
        time_ = {least_time, most_time, plot_.left(), plot_.right()};
        // The lowest part is for what is exact: no power of ten is 0.
        error_ = {least_error, most_error, plot_.bottom() - exact_room, plot_.top()};
    }

    void draw() {
        draw_frame();
        draw_levels();
        const Ink inks[] = {palette_[RayLook::reflected], palette_[RayLook::refracted],
                            palette_[RayLook::primary]};
        for (std::size_t k = 0; k < measured_.arithmetics.size(); ++k) {
            const WorkPoint& point = measured_.arithmetics[k];
            const QColor colour = qt(inks[std::min(k, std::size(inks) - 1)]);
            draw_diamond(place_of(point), colour);
            draw_name(place_of(point), qt(point.label), colour);
        }
    }

  private:
    static constexpr double exact_room = 26;

    QPointF place_of(const WorkPoint& point) const {
        return {time_.place(1e6 * point.seconds),
                point.error > 0 ? error_.place(point.error) : plot_.bottom() - exact_room / 2};
    }

    void draw_frame() {
        painter_.fillRect(
            QRectF(plot_.left(), plot_.bottom() - exact_room, plot_.width(), exact_room),
            qt(mixed(palette_.panel, palette_.text, 0.06)));
        const QColor grid = qt(mixed(palette_.panel, palette_.text, 0.14));
        const QColor words = qt(palette_.dim_text);
        const auto text = [&](const QRectF& room, int how, const QString& said) {
            painter_.setPen(words);
            painter_.drawText(room, how, said);
        };
        const int every = 1 + (error_.most - error_.least) / 7;
        for (int power = error_.most; power >= error_.least; power -= every) {
            const double y = error_.place(std::pow(10, power));
            painter_.setPen(grid);
            painter_.drawLine(QPointF(plot_.left(), y), QPointF(plot_.right(), y));
            text({0, y - 9, plot_.left() - 6, 18}, Qt::AlignRight | Qt::AlignVCenter,
                 power_text(power));
        }
        text({0, plot_.bottom() - exact_room, plot_.left() - 6, exact_room},
             Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("exact"));
        for (int power = time_.least; power <= time_.most; ++power) {
            const double x = time_.place(std::pow(10, power));
            painter_.setPen(grid);
            painter_.drawLine(QPointF(x, plot_.top()), QPointF(x, plot_.bottom()));
            text({x - 30, plot_.bottom() + 2, 60, 18}, Qt::AlignHCenter | Qt::AlignTop,
                 power < 0 || power > 4 ? power_text(power)
                                        : QString::number(std::lround(std::pow(10, power))));
        }
        text({plot_.left(), plot_.bottom() + 20, plot_.width(), 18},
             Qt::AlignHCenter | Qt::AlignTop, QStringLiteral("time for a pixel, in µs"));
    }

    void draw_levels() {
        const QColor colour = qt(mixed(palette_.text, palette_.panel, 0.4));
        QPolygonF line;
        for (const WorkPoint& point : measured_.levels) {
            line << place_of(point);
        }
        painter_.setPen(QPen(colour, 1.5));
        painter_.drawPolyline(line);
        painter_.setBrush(colour);
        for (const QPointF& at : line) {
            painter_.drawEllipse(at, 3, 3);
        }
        if (!measured_.levels.empty()) {
            draw_name(line.back(), qt(measured_.levels.back().label), colour);
        }
    }

    void draw_diamond(QPointF at, const QColor& colour) {
        painter_.setPen(Qt::NoPen);
        painter_.setBrush(colour);
        constexpr double r = 7;
        painter_.drawPolygon(QPolygonF(
            {at + QPointF(0, -r), at + QPointF(r, 0), at + QPointF(0, r), at + QPointF(-r, 0)}));
    }

    /// To the right of its point, or to the left where the picture ends.
    void draw_name(QPointF at, const QString& name, const QColor& colour) {
        const int width = painter_.fontMetrics().horizontalAdvance(name);
        const bool left = at.x() + 11 + width > plot_.right();
        painter_.setPen(colour);
        painter_.drawText(at + QPointF(left ? -11 - width : 11, 4), name);
    }

    const WorkPrecision& measured_;
    const Palette& palette_;
    QPainter painter_;
    QRectF plot_;
    LogAxis time_, error_;
};

}  // namespace

QImage depth_picture(const DepthPicture& picture, const std::optional<DepthComparison>& chosen,
                     int side, const Palette& palette) {
    const std::size_t seen = chosen ? chosen->place.side : 0;
    const int size = picture.size();
    const auto [near, far] = extremes(picture, seen);
    QImage image(size, size, QImage::Format_RGB32);
    for (int j = 0; j < size; ++j) {
        for (int i = 0; i < size; ++i) {
            const double depth = picture.depth({seen, i, j});
            const double share =
                far > near ? std::clamp((depth - near) / (far - near), 0.0, 1.0) : 0;
            const int grey = static_cast<int>(245 - 190 * share);
            image.setPixelColor(
                i, j, std::isfinite(depth) ? QColor(grey, grey, grey) : qt(palette.space_top));
        }
    }
    image = image.scaled(side, side, Qt::IgnoreAspectRatio,
                         side < size ? Qt::SmoothTransformation : Qt::FastTransformation);
    if (chosen) {
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        const double pixel = static_cast<double>(side) / size;
        mark(painter, {(chosen->place.i + 0.5) * pixel, (chosen->place.j + 0.5) * pixel}, pixel,
             palette);
    }
    return image;
}

QImage time_picture(const TimeShare& share, int width, const Palette& palette) {
    QImage image(width, 144, QImage::Format_RGB32);
    image.fill(qt(palette.panel));
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(small_font());
    const double rest = std::max(0.0, share.all - share.intersection);
    const double longest = rest + share.brute_force_intersection;
    const double room = width - 12;
    const auto bar = [&](double top, const QString& name, double hits) {
        const double blue = room * hits / longest, grey = room * rest / longest;
        const QRectF finding(4, top + 18, blue, 26), others(4 + blue, top + 18, grey, 26);
        painter.fillRect(finding, qt(palette[RayLook::refracted]));
        painter.fillRect(others, qt(mixed(palette.panel, palette.text, 0.28)));
        painter.setPen(qt(palette.text));
        painter.drawText(QRectF(4, top, room, 18), Qt::AlignLeft | Qt::AlignVCenter, name);
        const QString words = QStringLiteral("finding hits: ") + percent(hits / (hits + rest));
        const bool inside = painter.fontMetrics().horizontalAdvance(words) + 12 < blue;
        painter.setPen(inside ? QColor(Qt::white) : qt(palette.text));
        painter.drawText(inside ? finding.adjusted(8, 0, 0, 0)
                                : QRectF(others.right() + 8, finding.top(), room, 26),
                         Qt::AlignLeft | Qt::AlignVCenter, words);
    };
    bar(0, QStringLiteral("Every object asked"), share.brute_force_intersection);
    // The lecture's range, below the bar that it is about.
    const double from = 4 + room * lecture_intersection_share[0];
    const double to = 4 + room * lecture_intersection_share[1];
    painter.setPen(QPen(qt(palette.text), 1.5));
    painter.drawPolyline(QPolygonF({{from, 47}, {from, 52}, {to, 52}, {to, 47}}));
    painter.drawText(
        QRectF(0, 53, to + 4, 18), Qt::AlignRight | Qt::AlignTop,
        QStringLiteral("the lecture: %1 to %2")
            .arg(percent(lecture_intersection_share[0]), percent(lecture_intersection_share[1])));
    bar(76, QStringLiteral("With the hierarchy"), share.intersection);
    painter.setPen(qt(palette.dim_text));
    painter.drawText(QRectF(4, 124, room, 18), Qt::AlignLeft | Qt::AlignTop,
                     QStringLiteral("Length is time. Grey: all else."));
    return image;
}

QImage accuracy_picture(const WorkPrecision& measured, QSize size, const Palette& palette) {
    QImage image(size, QImage::Format_RGB32);
    image.fill(qt(palette.panel));
    AccuracyDrawing(measured, image, palette).draw();
    return image;
}

}  // namespace raytree::inspector
