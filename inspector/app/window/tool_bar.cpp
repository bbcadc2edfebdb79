#include "window/tool_bar.h"

#include <QEvent>
#include <QToolButton>

namespace raytree::inspector {
namespace {

constexpr std::string_view rule = "|", gap = " ";

/// From left to right: what is open, its rays, the view of them; and what stands beside the view.
constexpr std::string_view places[] = {
    "file.open",          rule,          "ray.previous", "ray.next",    "ray.parent",
    "ray.child",          rule,          "view.camera",  "view.side",   "view.fit_tree",
    "view.fit_selection", rule,          "show.shadow",  "show.ghosts", gap,
    "step.mode",          "pane.change", "pane.compare", "lesson.list", rule,
    "look.dark",
};

constexpr const char* kind = "kind";
enum Kind { arrow, tool, mode };  // of an arrow, words are in the menu and the tooltip only

}  // namespace

ToolBar::ToolBar(const ActionOf& action_of, QWidget* parent)
    : QToolBar(QStringLiteral("Tools"), parent) {
    setMovable(false);
    bool at_right = false;
    for (const std::string_view place : places) {
        if (place == rule) {
            addSeparator();
        } else if (place == gap) {
            auto* const spacer = new QWidget;
            spacer->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
            addWidget(spacer);
            at_right = true;
        } else {
            QAction* const action = action_of(place);
            action->setProperty(kind, place.starts_with("ray.") ? arrow : at_right ? mode : tool);
            addAction(action);
        }
    }
    for (QToolButton* const button : findChildren<QToolButton*>()) {
        button->setFocusPolicy(Qt::NoFocus);  // keys go on acting in the panes
    }
    size_icons();
    show(Words::all);
}

void ToolBar::size_icons() {
    const int icon = fontMetrics().height() + 3;
    setIconSize({icon, icon});
}

void ToolBar::show(Words words) {
    for (QAction* const action : actions()) {
        if (auto* const button = qobject_cast<QToolButton*>(widgetForAction(action))) {
            const int kind_of = action->property(kind).toInt();
            const bool has = (kind_of == tool && words == Words::all) ||
                             (kind_of == mode && words != Words::none);
            button->setToolButtonStyle(has ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
        }
    }
}

void ToolBar::fit() {
    for (const Words words : {Words::all, Words::modes, Words::none}) {
        show(words);
        if (sizeHint().width() <= width()) {
            break;
        }
    }
}

void ToolBar::resizeEvent(QResizeEvent* event) {
    QToolBar::resizeEvent(event);
    fit();
}

void ToolBar::changeEvent(QEvent* event) {
    QToolBar::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) {
        size_icons();
    }
}

}  // namespace raytree::inspector
