#pragma once

#include <QStringList>

class QWidget;

namespace raytree::inspector::test {

/// What of a window's words has not its room, one line each: labels, buttons, tabs, fields, the
/// headers and rows of lists, menus that are off their bar, texts that scroll sideways. Names of
/// objects in the ray table may be shortened and are not looked at.
QStringList cut_words(const QWidget& window);

}  // namespace raytree::inspector::test
