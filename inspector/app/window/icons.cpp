#include "window/icons.h"

#include <QPainterPath>
#include <QPixmap>
#include <functional>
#include <map>

#include "window/qt_text.h"

namespace raytree::inspector {
namespace {

constexpr int oversampling = 3;  // drawn larger, for displays of any pixel ratio

/// An icon drawn in a box of `width` x `height` units.
template <class Draw> QIcon drawn(int width, int height, Draw draw) {
    QPixmap pixmap(width * oversampling, height * oversampling);
    pixmap.setDevicePixelRatio(oversampling);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    draw(painter);
    painter.end();
    QIcon icon;
    icon.addPixmap(pixmap, QIcon::Normal);
    icon.addPixmap(pixmap, QIcon::Selected);  // colours mean something: they are not tinted
    return icon;
}

QPen line_pen(const QColor& colour, double width, bool dashed = false) {
    QPen pen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    if (dashed) {
        pen.setCapStyle(Qt::FlatCap);
        pen.setDashPattern({2.2, 1.5});
    }
    return pen;
}

void draw_arrow(QPainter& painter, QPointF at, QPointF way, double size) {
    const QPointF across(-way.y(), way.x());
    const QPolygonF head({at + way * size, at - way * size * 0.6 + across * size * 0.75,
                          at - way * size * 0.6 - across * size * 0.75});
    painter.save();
    painter.setBrush(painter.pen().color());
    painter.setPen(Qt::NoPen);
    painter.drawPolygon(head);
    painter.restore();
}

void draw_cross(QPainter& painter, QPointF at, double arm) {
    painter.drawLine(at + QPointF(-arm, -arm), at + QPointF(arm, arm));
    painter.drawLine(at + QPointF(-arm, arm), at + QPointF(arm, -arm));
}

void draw_kind(QPainter& painter, const QRectF& box, RayKind kind) {
    const double l = box.left() + 1.5, r = box.right() - 1.5, t = box.top() + 2.5;
    const double b = box.bottom() - 2, m = box.center().y(), c = box.center().x();
    switch (kind) {
        case RayKind::primary:
            painter.drawLine(QPointF(l, m), QPointF(r - 3, m));
            draw_arrow(painter, {r - 3, m}, {1, 0}, 4);
            break;
        case RayKind::reflected:
            painter.drawPolyline(QPolygonF({{l + 1, t}, {c, b}, {r - 3, t + 1.5}}));
            draw_arrow(painter, {r - 3, t + 2}, {0.77, -0.64}, 3.6);
            break;
        case RayKind::refracted:
            painter.drawPolyline(QPolygonF({{l + 1, t}, {c, m}, {c + 3.5, b - 2}}));
            draw_arrow(painter, {c + 3.5, b - 2.5}, {0.55, 0.83}, 3.6);
            break;
        case RayKind::shadow:
            painter.drawLine(QPointF(l, m), QPointF(r - 5, m));
            break;
    }
}

using Draw = std::function<void(QPainter&)>;

void triangle(QPainter& p, QPointF a, QPointF b, QPointF c) {
    p.save();
    p.setBrush(p.pen().color());
    p.drawPolygon(QPolygonF({a, b, c}));
    p.restore();
}

/// Drawings in a box of 18 x 18.
const std::map<std::string_view, Draw>& command_drawings() {
    static const std::map<std::string_view, Draw> drawings = {
        {"file.open",
         [](QPainter& p) {
             p.drawPolyline(
                 QPolygonF({{2.5, 14.5}, {2.5, 3.5}, {7, 3.5}, {8.5, 5.5}, {14, 5.5}, {14, 8}}));
             p.drawPolygon(QPolygonF({{2.5, 14.5}, {5, 8}, {16.5, 8}, {14, 14.5}}));
         }},
        {"file.reload",
         [](QPainter& p) {
             p.drawArc(QRectF(3.5, 3.5, 11, 11), 40 * 16, 290 * 16);
             triangle(p, {14.5, 2.5}, {14.8, 7.2}, {10.6, 5.2});
         }},
        {"ray.previous",
         [](QPainter& p) {
             triangle(p, {5, 9}, {12.5, 4}, {12.5, 14});
         }},
        {"ray.next",
         [](QPainter& p) {
             triangle(p, {13, 9}, {5.5, 4}, {5.5, 14});
         }},
        {"ray.parent",
         [](QPainter& p) {
             triangle(p, {9, 3}, {13.5, 8}, {4.5, 8});
             p.drawLine(QPointF(9, 8), QPointF(9, 15));
         }},
        {"ray.child",
         [](QPainter& p) {
             triangle(p, {9, 15}, {13.5, 10}, {4.5, 10});
             p.drawLine(QPointF(9, 10), QPointF(9, 3));
         }},
        {"view.camera",
         [](QPainter& p) {
             p.drawEllipse(QPointF(3.5, 9), 1.6, 1.6);
             p.drawPolyline(QPolygonF({{14, 3}, {5, 9}, {14, 15}}));
             p.drawLine(QPointF(14, 3), QPointF(14, 15));
         }},
        {"view.side",
         [](QPainter& p) {
             p.drawPolygon(QPolygonF({{9, 2.5}, {15, 6}, {15, 12}, {9, 15.5}, {3, 12}, {3, 6}}));
             p.drawPolyline(QPolygonF({{3, 6}, {9, 9}, {15, 6}}));
             p.drawLine(QPointF(9, 9), QPointF(9, 15.5));
         }},
        {"view.fit_tree",
         [](QPainter& p) {
             for (const double x : {3.0, 15.0}) {
                 for (const double y : {3.0, 15.0}) {
                     p.drawLine(QPointF(x, y), QPointF(x + (9 - x) * 0.6, y));
                     p.drawLine(QPointF(x, y), QPointF(x, y + (9 - y) * 0.6));
                 }
             }
             p.drawPolyline(QPolygonF({{6.5, 6.5}, {9, 10}, {6.8, 12}}));
             p.drawLine(QPointF(9, 10), QPointF(12, 8));
         }},
        {"view.fit_selection",
         [](QPainter& p) {
             for (const double x : {3.0, 15.0}) {
                 for (const double y : {3.0, 15.0}) {
                     p.drawLine(QPointF(x, y), QPointF(x + (9 - x) * 0.6, y));
                     p.drawLine(QPointF(x, y), QPointF(x, y + (9 - y) * 0.6));
                 }
             }
             p.drawLine(QPointF(6.5, 11.5), QPointF(11.5, 6.5));
         }},
        {"show.shadow",
         [](QPainter& p) {
             p.save();
             p.setPen(line_pen(p.pen().color(), 1.5, true));
             p.drawLine(QPointF(3, 15), QPointF(11, 7));
             p.restore();
             p.drawEllipse(QPointF(13, 5), 2.4, 2.4);
         }},
        {"show.ghosts",
         [](QPainter& p) {
             QPen dotted = p.pen();
             dotted.setDashPattern({1, 2.4});
             p.save();
             p.setPen(dotted);
             p.drawLine(QPointF(3, 9), QPointF(11, 9));
             p.restore();
             draw_cross(p, {13.5, 9}, 2.2);
         }},
        {"step.mode",
         [](QPainter& p) {
             p.drawPolyline(QPolygonF({{2.5, 14.5}, {6.5, 14.5}, {6.5, 10.5}, {10.5, 10.5}}));
             p.drawPolyline(QPolygonF({{10.5, 10.5}, {10.5, 6.5}, {14.5, 6.5}}));
             draw_arrow(p, {14.5, 4.5}, {0, -1}, 2.6);
             p.drawLine(QPointF(14.5, 6.5), QPointF(14.5, 4.5));
         }},
        {"pane.change",
         [](QPainter& p) {
             for (const auto& [y, x] :
                  {std::pair(4.0, 11.0), std::pair(9.0, 6.0), std::pair(14.0, 12.5)}) {
                 p.drawLine(QPointF(2.5, y), QPointF(x - 2, y));
                 p.drawLine(QPointF(x + 2, y), QPointF(15.5, y));
                 p.drawEllipse(QPointF(x, y), 2, 2);
             }
         }},
        {"pane.compare",
         [](QPainter& p) {
             p.drawLine(QPointF(3, 6.5), QPointF(15, 6.5));
             p.drawLine(QPointF(3, 11.5), QPointF(15, 11.5));
             p.drawLine(QPointF(12, 2.5), QPointF(6, 15.5));
         }},
        {"lesson.list",
         [](QPainter& p) {
             p.drawPolyline(QPolygonF({{9, 4.5},
                                       {6.5, 3},
                                       {2.5, 3},
                                       {2.5, 13.5},
                                       {6.5, 13.5},
                                       {9, 15},
                                       {11.5, 13.5},
                                       {15.5, 13.5},
                                       {15.5, 3},
                                       {11.5, 3},
                                       {9, 4.5},
                                       {9, 15}}));
         }},
        {"tab.outline",
         [](QPainter& p) {
             for (const auto& [y, x] : {std::pair(3.5, 2.5), std::pair(7.5, 5.5),
                                        std::pair(11.0, 8.5), std::pair(14.5, 5.5)}) {
                 p.drawLine(QPointF(x, y), QPointF(15.5, y));
             }
         }},
        {"tab.diagram",
         [](QPainter& p) {
             p.drawRect(QRectF(6.5, 2.5, 5, 4));
             p.drawRect(QRectF(2, 11.5, 5, 4));
             p.drawRect(QRectF(11, 11.5, 5, 4));
             p.drawPolyline(QPolygonF({{4.5, 11.5}, {4.5, 9}, {13.5, 9}, {13.5, 11.5}}));
             p.drawLine(QPointF(9, 6.5), QPointF(9, 9));
         }},
        {"tab.counts",
         [](QPainter& p) {
             p.drawLine(QPointF(2.5, 15.5), QPointF(15.5, 15.5));
             for (const auto& [x, y] :
                  {std::pair(4.5, 9.5), std::pair(9.0, 3.0), std::pair(13.5, 7.0)}) {
                 p.drawRect(QRectF(x - 1, y, 2, 15.5 - y));
             }
         }},
        {"tab.filter",
         [](QPainter& p) {
             p.drawPolygon(
                 QPolygonF({{2.5, 3}, {15.5, 3}, {10.8, 9}, {10.8, 13}, {7.2, 15.5}, {7.2, 9}}));
         }},
        {"tab.explained",
         [](QPainter& p) {
             p.drawEllipse(QPointF(9, 9), 6.5, 6.5);
             p.drawLine(QPointF(9, 8.5), QPointF(9, 12.5));
             p.drawPoint(QPointF(9, 5.7));
         }},
        {"look.dark",
         [](QPainter& p) {
             QPainterPath moon;
             moon.addEllipse(QPointF(9, 9), 6, 6);
             p.drawPath(moon);
             QPainterPath half;
             half.moveTo(9, 3);
             half.arcTo(QRectF(3, 3, 12, 12), 90, -180);
             half.closeSubpath();
             p.fillPath(half, p.pen().color());
         }},
    };
    return drawings;
}

}  // namespace

void draw_sign(QPainter& painter, const QRectF& box, RayLook look, const Palette& palette) {
    const bool shadow = look == RayLook::lit || look == RayLook::blocked;
    const QColor colour = qt(palette[look]);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(line_pen(colour, 2.0, shadow));
    draw_kind(painter, box, shadow ? RayKind::shadow : static_cast<RayKind>(look));
    const QPointF end(box.right() - 3.5, box.center().y());
    if (look == RayLook::lit) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour);
        painter.drawEllipse(end, 2.8, 2.8);
    } else if (look == RayLook::blocked) {
        painter.setPen(line_pen(colour, 1.8));
        draw_cross(painter, end, 2.6);
    }
}

QIcon sign_of(RayLook look, const Palette& palette) {
    return drawn(24, 16, [&](QPainter& p) { draw_sign(p, QRectF(0, 0, 24, 16), look, palette); });
}

QIcon ghost_sign(RayKind kind, const Palette& palette) {
    return drawn(24, 16, [&](QPainter& p) {
        QPen pen = line_pen(qt(palette.dim_text, 170), 1.3);
        pen.setDashPattern({0.6, 2});
        p.setPen(pen);
        draw_kind(p, QRectF(0, 0, 24, 16), kind);
    });
}

QIcon swatch(QColor colour, const Palette& palette) {
    return drawn(16, 16, [&](QPainter& p) {
        p.setBrush(colour);
        p.setPen(QPen(qt(palette.dim_text, 160), 1));
        p.drawRoundedRect(QRectF(1.5, 1.5, 13, 13), 2, 2);
    });
}

QIcon command_icon(std::string_view id, const Palette& palette) {
    const auto found = command_drawings().find(id);
    if (found == command_drawings().end()) {
        return {};
    }
    return drawn(18, 18, [&](QPainter& p) {
        p.setPen(line_pen(qt(palette.text), 1.5));
        found->second(p);
    });
}

void draw_focus(QPainter& painter, const QWidget& pane, const Palette& palette) {
    if (pane.hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(qt(palette.accent));
        painter.drawRect(pane.rect().adjusted(0, 0, -1, -1));
    }
}

}  // namespace raytree::inspector
