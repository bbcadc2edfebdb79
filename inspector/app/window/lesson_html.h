#pragma once

#include <QString>

#include "lesson/text.h"
#include "state/palette.h"

namespace raytree::inspector {

/// A lesson's text for Qt's subset of HTML: paragraphs, lists, emphasis, and formulas in a font of
/// their own.
QString html_of(const lesson::FilledText& text, const Palette& palette);

}  // namespace raytree::inspector
