#include "window/rich_text.h"

#include <QTextEdit>

namespace raytree::inspector {

void show_html(QTextEdit& pane, const QString& html) {
    pane.setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    pane.setHtml(html);
    pane.setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
}

}  // namespace raytree::inspector
