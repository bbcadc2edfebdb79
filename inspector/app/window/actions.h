#pragma once

#include <QAction>
#include <QObject>
#include <functional>
#include <map>
#include <string_view>

#include "state/commands.h"

class QMainWindow;
class QWidget;

namespace raytree::inspector {

/// The table of commands as Qt's actions: in menus, in the toolbar, on keys.
class Actions : public QObject {
    Q_OBJECT

  public:
    /// `ask_file` gives the file for a command that wants one, empty to do nothing; `fail` is told
    /// what went wrong.
    Actions(State& state, QMainWindow* window, std::function<QString()> ask_file,
            std::function<void(const InputError&)> fail);

    /// The keys that widgets also use for themselves (arrows, Home) act in this one.
    void give_keys_to(QWidget* widget);
    void run(const Command& command, std::string_view argument);

  private:
    void add_menus(QMainWindow* window);
    void add_toolbar(QMainWindow* window);
    QAction* make(const Command& command);
    void refresh(bool theme);

    State& state_;
    std::function<QString()> ask_file_;
    std::function<void(const InputError&)> fail_;
    std::map<std::string_view, QAction*> actions_;
};

}  // namespace raytree::inspector
