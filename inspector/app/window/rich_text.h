#pragma once

class QString;
class QTextEdit;

namespace raytree::inspector {

/// The text of a pane anew; a long one is laid out once. By itself the scroll bar goes with the old
/// text and comes with the new one, and each time all lines are broken anew.
void show_html(QTextEdit& pane, const QString& html);

}  // namespace raytree::inspector
