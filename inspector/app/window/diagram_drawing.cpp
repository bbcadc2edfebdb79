#include "window/diagram_drawing.h"

#include <QPainterPath>
#include <algorithm>

#include "formats/tree_colours.h"
#include "tree/eight_bit.h"
#include "window/qt_text.h"

namespace raytree::inspector {
namespace {

using Sizes = DiagramSizes;
using Box = DiagramBox;

constexpr double edge_gap = 40;  // at least that much is between two levels

QRectF rectangle(const DiagramPlace& place) {
    return {place.x, place.y, place.width, place.height};
}

RayLook look_of_light(LightRow::State state) {
    return state == LightRow::State::lit ? RayLook::lit : RayLook::blocked;
}

/// Whether the box is of a ray in the list.
bool has(const std::vector<bool>& rays, const Box& box) {
    return !rays.empty() && !box.absent && rays[box.ray->id];
}

QRectF extent_of(const Box& box) {
    const QRectF frame = rectangle(frame_of(box));
    const double lights = box.light_row * static_cast<double>(box.lights.size());
    return {frame.left(), frame.top() - Sizes::label, box.card_width + box.lights_width,
            Sizes::label + std::max(frame.height(), lights)};
}

}  // namespace

DiagramDrawing::DiagramDrawing(QPainter& painter, const Diagram& diagram,
                               const std::vector<BoxLook>& looks, const Palette& palette,
                               Quantize quantize)
    : painter_(painter),
      diagram_(diagram),
      looks_(looks),
      palette_(palette),
      quantize_(quantize),
      font_(painter.font()) {
    font_.setPixelSize(static_cast<int>(Sizes::font));
    font_.setHintingPreference(QFont::PreferNoHinting);  // text keeps its width at every zoom
}

void DiagramDrawing::draw(const QRectF& visible, DiagramSpot chosen, const Emphasis& emphasis) {
    for (const Box& box : diagram_.boxes) {
        if (!look(box).hidden) {
            draw_edge(box, stroke_of(box));
        }
    }
    draw_way(chosen.box);
    for (const Box& box : diagram_.boxes) {
        if (!look(box).hidden && extent_of(box).adjusted(-8, -8, 8, 8).intersects(visible)) {
            painter_.setOpacity(has(emphasis.faded, box) ? 0.35 : 1);
            draw_box(box);
            painter_.setOpacity(1);
        }
    }
    for (std::size_t k = 0; k < diagram_.boxes.size(); ++k) {
        mark_rays(k, emphasis.marked);
    }
    mark(chosen);
}

/// Dashed frames around a box and its shadow rays, where they are marked.
void DiagramDrawing::mark_rays(std::size_t k, const std::vector<bool>& marked) {
    const Box& box = diagram_.boxes[k];
    if (look(box).hidden) {
        return;
    }
    const auto frame = [&](DiagramSpot spot) {
        use({palette_.selection, 1.8, Qt::DashLine});
        painter_.drawRoundedRect(rectangle(place_of(diagram_, spot)).adjusted(-3, 2, 3, 4), 6, 6);
    };
    if (has(marked, box)) {
        frame({k, std::nullopt});
    }
    for (std::size_t row = 0; row < box.lights.size(); ++row) {
        const auto& ray = box.lights[row].ray;
        if (ray && !marked.empty() && marked[*ray] && !look(box).hidden_lights[row]) {
            frame({k, row});
        }
    }
}

DiagramDrawing::Stroke DiagramDrawing::stroke_of(const Box& box) const {
    if (box.absent) {
        return {palette_.dim_text, 1.3, Qt::DotLine};
    }
    const Qt::PenStyle style = look(box).graft ? Qt::DashDotLine : Qt::SolidLine;
    return {palette_[inspector::look_of(*box.ray)], thickness_of(box.ray->weight), style};
}

Ink DiagramDrawing::letters_of(const Box& box) const {
    return box.absent ? palette_.dim_text : letters(palette_[inspector::look_of(*box.ray)]);
}

void DiagramDrawing::use(const Stroke& stroke, int alpha) {
    painter_.setPen(
        QPen(qt(stroke.ink, alpha), stroke.width, stroke.style, Qt::FlatCap, Qt::RoundJoin));
    painter_.setBrush(Qt::NoBrush);
}

void DiagramDrawing::write(const QRectF& line, const QString& text, const Lettering& lettering,
                           Qt::Alignment alignment) {
    font_.setBold(lettering.bold);
    font_.setItalic(lettering.italic);
    painter_.setFont(font_);
    painter_.setPen(qt(lettering.ink));
    painter_.drawText(line, static_cast<int>(alignment | Qt::AlignVCenter) | Qt::TextDontClip,
                      text);
}

/// Marks the edges that lead to a box.
void DiagramDrawing::draw_way(std::size_t box) {
    for (std::optional<std::size_t> at = box; at; at = diagram_.boxes[*at].parent) {
        const Box& on_way = diagram_.boxes[*at];
        draw_edge(on_way, {palette_.selection, stroke_of(on_way).width + 5, Qt::SolidLine}, 90);
    }
}

/// From the bottom of the parent's frame to the label above the box.
void DiagramDrawing::draw_edge(const Box& box, const Stroke& stroke, int alpha) {
    if (!box.parent) {
        return;
    }
    const Box& parent = diagram_.boxes[*box.parent];
    const QRectF from = rectangle(frame_of(parent));
    const double side = box.branch == RayKind::reflected ? 0.3 : 0.7;
    const double from_x = from.left() + side * from.width();
    const double x = box.x + box.card_width / 2;
    // What is beside the parent may reach further down than its frame.
    const double turn = std::max(from.bottom(), box.y - edge_gap - 4);
    QPainterPath path({from_x, from.bottom()});
    path.lineTo(from_x, turn);
    path.cubicTo(from_x, turn + 30, x, box.y - 30, x, box.y);
    use(stroke, alpha);
    painter_.drawPath(path);
}

/// The kind of the ray, on the end of its line.
void DiagramDrawing::draw_label(const Box& box) {
    const QRectF line(box.x, box.y, box.card_width, Sizes::label - 3);
    const RayMark mark = look(box).mark;
    const QString sign =
        mark == RayMark::none ? QString() : qt(text_of(mark).sign) + QLatin1Char(' ');
    const bool stands_out = mark != RayMark::none && mark != RayMark::same;
    write(line, sign + qt(word_of(box.branch)), {letters_of(box), stands_out, box.absent},
          Qt::AlignHCenter);
}

void DiagramDrawing::draw_box(const Box& box) {
    draw_label(box);
    const QRectF frame = rectangle(frame_of(box));
    const bool hollow = box.absent || !box.ray->hit;
    Stroke stroke = stroke_of(box);
    stroke.width = 1.5;
    if (!box.absent && hollow) {
        stroke.style = Qt::DashLine;
    }
    use(stroke);
    const bool faint = hollow || look(box).graft;
    painter_.setBrush(qt(faint ? palette_.panel : mixed(palette_.panel, stroke.ink, 0.08)));
    painter_.drawRoundedRect(frame, 4, 4);
    if (box.folded > 0) {  // one more frame behind it
        painter_.drawLine(frame.bottomLeft() + QPointF(5, 3), frame.bottomRight() + QPointF(-1, 3));
        painter_.drawLine(frame.topRight() + QPointF(3, 5), frame.bottomRight() + QPointF(3, -1));
    }
    if (box.absent || box.folded > 0) {
        draw_words(box, frame);
    } else {
        draw_ray(box, frame);
    }
    bool any = false;
    for (std::size_t row = box.lights.size(); row-- > 0;) {
        if (!look(box).hidden_lights[row]) {
            draw_light(box, row);
            any = true;
        }
    }
    if (any) {
        write({frame.right() + Sizes::light_indent, box.y, 60, Sizes::label - 3},
              QStringLiteral("shadow"), {palette_.dim_text});
    }
}

void DiagramDrawing::draw_ray(const Box& box, const QRectF& frame) {
    const double left = frame.left() + Sizes::margin;
    QRectF line(left, frame.top() + Sizes::margin - 2, frame.width() - 2 * Sizes::margin,
                Sizes::line);
    const bool escaped = !box.ray->hit;
    const QString title = look(box).met ? qt(box.title) : QStringLiteral("…");
    write(line, title, {palette_.text, !escaped, escaped});
    write(line, QStringLiteral("#%1").arg(box.ray->id), {palette_.dim_text}, Qt::AlignRight);
    if (look(box).pending) {
        line.translate(0, Sizes::line);
        write(line, QStringLiteral("pending"), {palette_.dim_text, false, true});
        return;
    }
    if (look(box).given) {
        const auto [r, g, b] = eight_bit(box.ray->intensity, quantize_).value;
        painter_.setPen(QPen(qt(palette_.dim_text), 0.75));
        painter_.setBrush(QColor(r, g, b));
        painter_.drawRect(QRectF(left, line.bottom() + 1, Sizes::swatch,
                                 Sizes::line * static_cast<double>(box.lines.size()) - 2));
        for (const std::string& text : box.lines) {
            line.translate(0, Sizes::line);
            write(line.adjusted(Sizes::swatch + 6, 0, 0, 0), qt(text), {palette_.text});
        }
    } else {
        line.translate(0, Sizes::line);
        write(line, QStringLiteral("not given"), {palette_.dim_text, false, true});
    }
    for (const std::string& note : box.notes) {
        line.translate(0, Sizes::line);
        write(line, qt(note), {palette_.dim_text, false, true});
    }
}

/// Of a ray that was not sent, and of a folded branch.
void DiagramDrawing::draw_words(const Box& box, const QRectF& frame) {
    QRectF line(frame.left(), frame.top() + Sizes::margin - 2, frame.width(), Sizes::line);
    // What is folded away may be what is looked for.
    const RayMark inside = look(box).inside;
    if (inside == RayMark::none || inside == RayMark::same) {
        write(line, qt(box.title), {palette_.dim_text}, Qt::AlignHCenter);
    } else {
        write(line, qt(box.title) + QStringLiteral("  ") + qt(text_of(inside).sign),
              {palette_.text, true}, Qt::AlignHCenter);
    }
    for (const std::string& text : box.lines) {
        line.translate(0, Sizes::line);
        write(line, qt(text), {palette_.dim_text, false, true}, Qt::AlignHCenter);
    }
}

/// Beside the frame: a line to the light as seen from the hit: full, crossed out, or not looked at.
void DiagramDrawing::draw_light(const Box& box, std::size_t row) {
    const LightRow& light = box.lights[row];
    const bool absent = light.state == LightRow::State::absent;
    const bool lit = light.state == LightRow::State::lit;
    const Ink ink = absent ? palette_.dim_text : palette_[look_of_light(light.state)];
    const QRectF frame = rectangle(frame_of(box));
    const QPointF lamp(frame.right() + Sizes::light_indent - 9,
                       frame.top() + box.light_row * static_cast<double>(row) + 9);
    use({ink, 1.5, absent ? Qt::DotLine : Qt::DashLine});
    const double from = std::min(lamp.y(), frame.bottom() - 6);
    painter_.drawPolyline(QPolygonF({{frame.right() + 1, from},
                                     {frame.right() + 7, from},
                                     {frame.right() + 7, lamp.y()},
                                     {lamp.x() - 5, lamp.y()}}));
    use({ink, 1.3, absent ? Qt::DotLine : Qt::SolidLine});
    painter_.setBrush(qt(lit ? palette_.light : palette_.panel));
    painter_.drawEllipse(lamp, 4.5, 4.5);
    if (light.state == LightRow::State::blocked) {
        painter_.drawLine(lamp + QPointF(-3, -3), lamp + QPointF(3, 3));
        painter_.drawLine(lamp + QPointF(-3, 3), lamp + QPointF(3, -3));
    }
    const Ink words = absent ? ink : letters(ink);
    const QRectF line(lamp.x() + 9, lamp.y() - 7, box.lights_width, Sizes::line);
    const std::string_view sign = text_of(look(box).light_marks[row]).sign;
    const QString before = sign.empty() ? QString() : qt(sign) + QLatin1Char(' ');
    write(line, before + qt(light.light), {words, true, false});
    write(line.translated(box.fate_x, box.fate_y), qt(light.fate), {words, false, true});
}

void DiagramDrawing::mark(DiagramSpot spot) {
    const QRectF place = rectangle(place_of(diagram_, spot));
    use({palette_.selection, 5, Qt::SolidLine}, 70);
    painter_.drawRoundedRect(place.adjusted(-2, -2, 2, 2), 6, 6);
    use({palette_.selection, 2.2, Qt::SolidLine});
    painter_.drawRoundedRect(place, 4, 4);
}

}  // namespace raytree::inspector
