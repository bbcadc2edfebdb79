#pragma once

#include <QAction>
#include <QObject>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "state/commands.h"

class QMainWindow;
class QMenu;
class QWidget;

namespace raytree::inspector {

class Files;

/// What a button says of its command: what it does, and its first key.
QString hint_of(const Command& command);

/// The table of commands as Qt's actions: in menus, in the toolbar, on keys.
class Actions : public QObject {
    Q_OBJECT

  public:
    /// Asks for a file under the title given; empty to do nothing.
    using AskFile = std::function<QString(const QString& title)>;

    /// `fail` is told what went wrong.
    Actions(State& state, QMainWindow* window, AskFile ask_file,
            std::function<void(const InputError&)> fail);

    /// The keys that widgets also use for themselves (arrows, Home) act in this one.
    void give_keys_to(QWidget* widget);
    /// Commands that read files are left to it from now on.
    void leave_to(Files& files);
    /// Runs a command; asks for its file.
    void run(const Command& command, std::string argument);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void add_menus(QMainWindow* window);
    void add_toolbar(QMainWindow* window);
    QAction* make(const Command& command);
    void refresh();

    State& state_;
    AskFile ask_file_;
    Files* files_ = nullptr;
    QMenu* file_menu_ = nullptr;
    std::function<void(const InputError&)> fail_;
    std::map<std::string_view, QAction*> actions_;
    std::optional<Theme> icons_of_;  ///< none: not drawn yet
};

}  // namespace raytree::inspector
