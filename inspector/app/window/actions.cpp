#include "window/actions.h"

#include <QApplication>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <utility>

#include "window/exporter.h"
#include "window/files.h"
#include "window/icons.h"
#include "window/qt_text.h"
#include "window/tool_bar.h"

namespace raytree::inspector {
namespace {

/// Keys with which lists and text are gone through as well.
bool is_shared_key(const QKeySequence& keys) {
    switch (keys[0] & ~static_cast<int>(Qt::KeyboardModifierMask)) {
        case Qt::Key_Left:
        case Qt::Key_Right:
        case Qt::Key_Up:
        case Qt::Key_Down:
        case Qt::Key_Home:
            return true;
        default:
            return false;
    }
}

QList<QKeySequence> keys_of(const Command& command) {
    QList<QKeySequence> keys;
    for (const QString& key : qt(command.keys).split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
        keys.push_back(QKeySequence(key));
    }
    return keys;
}

/// The title with a key of its own: its first letter that no menu before has, which joins `taken`.
QString with_own_key(QString title, QString& taken) {
    for (int k = 0; k < title.size(); ++k) {
        if (!taken.contains(title[k], Qt::CaseInsensitive)) {
            taken += title[k];
            return title.insert(k, QLatin1Char('&'));
        }
    }
    return title;
}

}  // namespace

QString hint_of(const Command& command) {
    const QList<QKeySequence> keys = keys_of(command);
    return keys.isEmpty()
               ? qt(command.help)
               : qt(command.help) +
                     QStringLiteral("  (%1)").arg(keys.front().toString(QKeySequence::NativeText));
}

Actions::Actions(State& state, QMainWindow* window, AskFile ask_file,
                 std::function<void(const InputError&)> fail)
    : QObject(window), state_(state), ask_file_(std::move(ask_file)), fail_(std::move(fail)) {
    for (const Command& command : commands()) {
        if (!command.menu.empty()) {
            actions_[command.id] = make(command);
        }
    }
    add_menus(window);
    add_toolbar(window);
    refresh();
    QApplication::instance()->installEventFilter(this);
    state_.observe([this](const Changes&) { refresh(); });
}

QAction* Actions::make(const Command& command) {
    auto* const action = new QAction(qt(command.title), this);
    const QList<QKeySequence> keys = keys_of(command);
    action->setShortcuts(keys);
    if (!keys.isEmpty() && is_shared_key(keys.front())) {
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    }
    action->setToolTip(hint_of(command));
    action->setCheckable(command.on != nullptr);
    if (!command.toolbar.empty()) {
        action->setIconText(qt(command.toolbar));
    }
    connect(action, &QAction::triggered, this, [this, &command] { run(command, {}); });
    return action;
}

void Actions::run(const Command& command, std::string argument) {
    try {
        if (command.argument == Argument::file && argument.empty()) {
            argument = ask_file_(qt(command.title)).toStdString();
            if (argument.empty()) {
                return;
            }
        }
        if (command.argument == Argument::new_file && argument.empty()) {
            argument = ask_new_file(state_, command, qobject_cast<QWidget*>(parent()));
            if (argument.empty()) {
                return;
            }
        }
        if (!files_ || !files_->run(command, argument)) {
            run_command(state_, command.id, argument);
        }
    } catch (const InputError& error) {
        fail_(error);
    }
    refresh();  // a switch that Qt has turned stands as the state says
}

/// While a menu is open its keys are its own: arrows go through it and change no pixel.
bool Actions::eventFilter(QObject*, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride || !QApplication::activePopupWidget()) {
        return false;
    }
    event->accept();
    return true;
}

void Actions::leave_to(Files& files) {
    files_ = &files;
    file_menu_->insertMenu(actions_["file.reload"], files.recent_menu());
}

void Actions::add_menus(QMainWindow* window) {
    std::map<std::string_view, QMenu*> menus;
    QString taken;
    for (const Command& command : commands()) {
        if (command.menu.empty()) {
            continue;
        }
        QMenu*& menu = menus[command.menu];
        if (!menu) {
            menu = window->menuBar()->addMenu(with_own_key(qt(command.menu), taken));
            file_menu_ = file_menu_ ? file_menu_ : menu;
        }
        if (command.rule_before) {
            menu->addSeparator();
        }
        menu->addAction(actions_[command.id]);
    }
}

void Actions::add_toolbar(QMainWindow* window) {
    window->setContextMenuPolicy(Qt::NoContextMenu);
    window->addToolBar(
        new ToolBar([this](std::string_view command) { return actions_.at(command); }, window));
}

void Actions::give_keys_to(QWidget* widget) {
    for (const auto& [id, action] : actions_) {
        if (action->shortcutContext() == Qt::WidgetWithChildrenShortcut) {
            widget->addAction(action);
        }
    }
}

/// Icons are drawn, and drawn anew with another theme alone.
void Actions::refresh() {
    const bool theme = std::exchange(icons_of_, state_.look().theme) != state_.look().theme;
    for (const Command& command : commands()) {
        const auto found = actions_.find(command.id);
        if (found == actions_.end()) {
            continue;
        }
        QAction* const action = found->second;
        action->setEnabled(!command.possible || command.possible(state_));
        if (command.on) {
            action->setChecked(command.on(state_));
        }
        if (theme && !command.toolbar.empty()) {
            action->setIcon(command_icon(command.id, palette_of(state_.look().theme)));
            action->setIconVisibleInMenu(false);
        }
    }
}

}  // namespace raytree::inspector
