#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>
#include <filesystem>
#include <functional>
#include <optional>

#include "state/commands.h"
#include "state/recent.h"
#include "window/waiting.h"

class QMainWindow;
class QMenu;

namespace raytree::inspector {

/// Files of the window: they are read while it goes on, read again when they change on disk,
/// remembered, and not left with changes that nobody has saved.
class Files : public QObject {
    Q_OBJECT

  public:
    using AskFile = std::function<QString(const QString& title)>;
    Files(State& state, QMainWindow* window, AskFile ask_file,
          std::function<void(const InputError&)> fail);

    /// Does what a command that reads a file does; false where it is not such a command.
    bool run(const Command& command, const std::string& file);
    /// Whether what is open may be left: asks where changes of it are not saved.
    bool may_leave();
    /// From now on files that are opened are kept in the settings.
    void remember();
    /// The files that were open, those that are gone greyed.
    QMenu* recent_menu() const { return menu_; }

  private:
    using Path = std::filesystem::path;
    void open(const Path& file, const std::optional<Path>& scene = {});
    void read_again();
    void save_over();
    void compare(const Path& file);
    template <class Reading> auto read(const Path& file, Reading reading);
    std::optional<Opened> load(const Path& file, const std::optional<Path>& scene);
    void obey(const Changes& changes);
    void watch();
    void look_at_disk();
    void list_recent();

    struct Stamp {
        QDateTime modified;
        qint64 size = -1;
        bool operator==(const Stamp&) const = default;
    };
    Path file() const;
    /// Of a tree that was opened with it.
    std::optional<Path> scene_of_tree() const;
    static RecentFiles kept();
    Stamp stamp() const;
    QByteArray digest() const;
    bool has_changed_on_disk() const;

    State& state_;
    QMainWindow* window_;
    AskFile ask_file_;
    std::function<void(const InputError&)> fail_;
    Waiting waiting_;
    QMenu* menu_;
    RecentFiles recent_;
    bool remembers_ = false;
    QFileSystemWatcher watcher_;
    QTimer settled_;     ///< runs out when nothing has happened on disk for a while
    Stamp read_;         ///< of the file as it was read, or told to have changed
    Stamp shown_;        ///< as what is shown was read or saved
    QByteArray digest_;  ///< of the file's bytes then; empty where they are too many
    int missed_ = 0;     ///< how often it was not there, one time after the other
};

}  // namespace raytree::inspector
