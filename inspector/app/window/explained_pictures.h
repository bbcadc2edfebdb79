#pragma once

#include <QImage>

#include "state/explanation.h"
#include "state/palette.h"

/// The pictures that explain a feature, in the pane of its numbers.
namespace raytree::inspector {

/// What a light sees: near is light, far is dark; where it sees nothing there is the colour of
/// space. `side` pixels wide and high; the pixel that was looked up is marked.
QImage depth_picture(const DepthPicture& picture, const std::optional<DepthComparison>& chosen,
                     int side, const Palette& palette);

/// The time without and with the hierarchy as bars, and in them what finding hits takes, beside
/// what the lecture says.
QImage time_picture(const TimeShare& share, int width, const Palette& palette);

/// Error over time, both by powers of ten.
QImage accuracy_picture(const WorkPrecision& measured, QSize size, const Palette& palette);

}  // namespace raytree::inspector
