#pragma once

#include <QColor>
#include <QString>
#include <string_view>

#include "state/palette.h"

namespace raytree::inspector {

inline QString qt(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<int>(text.size()));
}

inline QColor qt(Ink ink, int alpha = 255) { return {ink.r, ink.g, ink.b, alpha}; }

}  // namespace raytree::inspector
