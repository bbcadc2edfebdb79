#pragma once

#include <QIcon>
#include <QPainter>
#include <QWidget>

#include "state/palette.h"

/// Small drawings in the colours of the theme.
namespace raytree::inspector {

/// The sign of a kind of ray: what it does, drawn as a line in its colour. A ghost is hollow.
void draw_sign(QPainter& painter, const QRectF& box, RayLook look, const Palette& palette);
QIcon sign_of(RayLook look, const Palette& palette);
QIcon ghost_sign(RayKind kind, const Palette& palette);

/// A square of a colour, as its pixel would be.
QIcon swatch(QColor colour, const Palette& palette);

/// The icon of a command by its id; null where it has none.
QIcon command_icon(std::string_view id, const Palette& palette);

/// The frame of a pane that keys go to.
void draw_focus(QPainter& painter, const QWidget& pane, const Palette& palette);

}  // namespace raytree::inspector
