#pragma once

#include <QString>

#include "state/lesson_run.h"
#include "state/palette.h"

namespace raytree::inspector {

/// The lessons as rich text; each one's title is a link to its name.
QString list_html(const std::vector<LessonEntry>& entries, const std::string& open,
                  const Palette& palette);

}  // namespace raytree::inspector
