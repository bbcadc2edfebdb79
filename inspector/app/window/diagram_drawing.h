#pragma once

#include <QPainter>

#include "state/diagram_looks.h"
#include "state/emphasis.h"
#include "state/palette.h"

namespace raytree::inspector {

/// The look of a diagram: the lecture's tree in the colours of the theme.
class DiagramDrawing {
  public:
    /// `looks`: one for each box.
    DiagramDrawing(QPainter& painter, const Diagram& diagram, const std::vector<BoxLook>& looks,
                   const Palette& palette, Quantize quantize);

    /// What lies in `visible`, in the diagram's units, with one spot marked and the way to it.
    void draw(const QRectF& visible, DiagramSpot chosen, const Emphasis& emphasis);

  private:
    struct Stroke {
        Ink ink;
        double width = 1;
        Qt::PenStyle style = Qt::SolidLine;
    };
    struct Lettering {
        Ink ink;
        bool bold = false;
        bool italic = false;
    };

    Stroke stroke_of(const DiagramBox& box) const;
    Ink letters_of(const DiagramBox& box) const;
    Ink letters(Ink line) const { return letters_in(line, palette_); }
    void use(const Stroke& stroke, int alpha = 255);
    void write(const QRectF& line, const QString& text, const Lettering& lettering,
               Qt::Alignment alignment = Qt::AlignLeft);

    const BoxLook& look(const DiagramBox& box) const {
        return looks_[static_cast<std::size_t>(&box - diagram_.boxes.data())];
    }
    void draw_way(std::size_t box);
    void draw_edge(const DiagramBox& box, const Stroke& stroke, int alpha = 255);
    void draw_label(const DiagramBox& box);
    void draw_box(const DiagramBox& box);
    void draw_ray(const DiagramBox& box, const QRectF& frame);
    void draw_words(const DiagramBox& box, const QRectF& frame);
    void draw_light(const DiagramBox& box, std::size_t row);
    void mark_rays(std::size_t box, const std::vector<bool>& marked);
    void mark(DiagramSpot spot);

    QPainter& painter_;
    const Diagram& diagram_;
    const std::vector<BoxLook>& looks_;
    const Palette& palette_;
    Quantize quantize_;
    QFont font_;
};

}  // namespace raytree::inspector
