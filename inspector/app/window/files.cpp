#include "window/files.h"

#include <QAbstractButton>
#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <new>

#include "formats/output_file.h"
#include "window/opening.h"
#include "window/qt_text.h"

namespace raytree::inspector {
namespace {

constexpr int settle_time = 200;  // milliseconds that an editor may take to replace a file

const QString& recent_key() {
    static const QString key = QStringLiteral("recent");
    return key;
}

QString name_of(const std::filesystem::path& file) { return qt(file.filename().string()); }

}  // namespace

Files::Files(State& state, QMainWindow* window, AskFile ask_file,
             std::function<void(const InputError&)> fail)
    : QObject(window),
      state_(state),
      window_(window),
      ask_file_(std::move(ask_file)),
      fail_(std::move(fail)),
      menu_(new QMenu(QStringLiteral("Open recent"), window)) {
    settled_.setSingleShot(true);
    settled_.setInterval(settle_time);
    connect(&settled_, &QTimer::timeout, this, &Files::look_at_disk);
    const auto settle = [this] { settled_.start(); };
    connect(&watcher_, &QFileSystemWatcher::fileChanged, this, settle);
    connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, settle);
    connect(menu_, &QMenu::aboutToShow, this, &Files::list_recent);
    state_.observe([this](const Changes& changes) { obey(changes); });
    list_recent();
}

bool Files::run(const Command& command, const std::string& file) {
    if (command.id == "file.open") {
        if (may_leave()) {
            open(file);
        }
    } else if (command.id == "file.reload") {
        if (may_leave()) {
            read_again();
        }
    } else if (command.id == "file.save" && has_changed_on_disk() && state_.own_file()) {
        save_over();
    } else if (command.id == "compare.file") {
        compare(file);
    } else {
        return false;
    }
    return true;
}

/// None where it was cancelled. Throws what the reading throws.
template <class Reading> auto Files::read(const Path& file, Reading reading) {
    try {
        return waiting_.wait(window_, QStringLiteral("Reading %1…").arg(name_of(file)), reading);
    } catch (const std::bad_alloc&) {
        throw InputError(file.string(), "", "there is too little memory for what it holds");
    }
}

std::optional<Opened> Files::load(const Path& file, const std::optional<Path>& scene) {
    return read(file, [=] { return open_for_window(file, scene); });
}

void Files::open(const Path& file, const std::optional<Path>& scene) {
    try {
        if (const auto opened = load(file, scene)) {
            state_.show(*opened);
        }
    } catch (const SceneWanted&) {
        const QString answer =
            ask_file_(QStringLiteral("This tree does not hold its scene: which one is it?"));
        if (!answer.isEmpty()) {
            open(file, answer.toStdString());
        }
    } catch (const InputError& error) {
        fail_(error);
    }
}

void Files::read_again() {
    try {
        if (const auto opened = load(file(), scene_of_tree())) {
            state_.renew(*opened);
            state_.say("Read again: " + file().filename().string());
        }
    } catch (const InputError& error) {
        fail_(error);
    }
}

/// Somebody else has written the file: their work is not overwritten without a word.
void Files::save_over() {
    QMessageBox box(
        QMessageBox::Warning, QStringLiteral("raytree inspector"),
        QStringLiteral("%1 has changed on disk since it was read.").arg(name_of(file())),
        QMessageBox::Cancel, window_);
    box.setInformativeText(QStringLiteral(
        "Overwriting loses what is there; reading it again loses the changes made here."));
    const QAbstractButton* const over =
        box.addButton(QStringLiteral("Overwrite"), QMessageBox::DestructiveRole);
    const QAbstractButton* const again =
        box.addButton(QStringLiteral("Read again"), QMessageBox::ActionRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    if (box.clickedButton() == over) {
        run_command(state_, "file.save");
    } else if (box.clickedButton() == again) {
        read_again();
    }
}

void Files::compare(const Path& file) {
    try {
        if (const auto recorded = read(file, [=] { return read_recorded(file); })) {
            state_.compare_with(*recorded);
        }
    } catch (const InputError& error) {
        fail_(error);
    }
}

bool Files::may_leave() {
    if (!state_.document() || !state_.edits().unsaved()) {
        return true;
    }
    QMessageBox box(QMessageBox::Question, QStringLiteral("raytree inspector"),
                    QStringLiteral("The changes of %1 are not saved.").arg(name_of(file())),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
    box.setInformativeText(QStringLiteral("Save them?"));
    box.setDefaultButton(QMessageBox::Save);
    const int answer = box.exec();
    if (answer == QMessageBox::Save) {
        try {
            run_command(state_, "file.save");
        } catch (const InputError& error) {
            fail_(error);
        }
        return !state_.edits().unsaved();
    }
    return answer == QMessageBox::Discard;
}

void Files::obey(const Changes& changes) {
    if (changes.document || (changes.values && !state_.edits().unsaved())) {
        watch();
        read_ = shown_ = stamp();
        digest_ = digest();
    }
    if (changes.document && remembers_) {
        std::error_code error;
        const Path whole = std::filesystem::absolute(file(), error);
        recent_ = kept();
        if (is_there(whole.string())) {
            recent_.add(whole.string());
        }
        QStringList files;
        for (const std::string& one : recent_.files()) {
            files.push_back(qt(one));
        }
        QSettings().setValue(recent_key(), files);
    }
}

RecentFiles Files::kept() {
    std::vector<std::string> files;
    for (const QString& one : QSettings().value(recent_key()).toStringList()) {
        files.push_back(one.toStdString());
    }
    return RecentFiles(std::move(files));
}

void Files::remember() {
    remembers_ = true;
    obey({.document = state_.document() != nullptr});
}

std::filesystem::path Files::file() const { return state_.opened_file(); }

Files::Stamp Files::stamp() const {
    const QFileInfo info(qt(file().string()));
    return info.exists() ? Stamp{info.lastModified(), info.size()} : Stamp{};
}

QByteArray Files::digest() const {
    constexpr qint64 most = 4'000'000;  // bytes that are read in a glance
    QFile bytes(qt(file().string()));
    return bytes.size() <= most && bytes.open(QIODevice::ReadOnly)
               ? QCryptographicHash::hash(bytes.readAll(), QCryptographicHash::Sha1)
               : QByteArray();
}

bool Files::has_changed_on_disk() const {
    const Stamp now = stamp();
    return now.size >= 0 && !(now == shown_);
}

/// The folder too: editors write a new file and put it in the old one's place.
void Files::watch() {
    const QString there = qt(file().string());
    const QStringList wanted = {there, QFileInfo(there).absolutePath()};
    const QStringList had = watcher_.files() + watcher_.directories();
    for (const QString& path : had) {
        if (!wanted.contains(path)) {
            watcher_.removePath(path);
        }
    }
    for (const QString& path : wanted) {
        if (!had.contains(path) && QFileInfo::exists(path)) {
            watcher_.addPath(path);
        }
    }
}

void Files::look_at_disk() {
    if (state_.busy()) {
        settled_.start();
        return;
    }
    watch();
    const Stamp now = stamp();
    if (now == read_) {
        return;  // another file of the folder
    }
    const std::string name = file().filename().string();
    if (now.size < 0) {  // it may just be being replaced
        constexpr int patience = 10;
        if (++missed_ < patience) {
            settled_.start();
        } else {
            read_ = now;
            state_.say(name + " is no longer on disk; shown is what it was.");
        }
        return;
    }
    missed_ = 0;
    if (!digest_.isEmpty() && digest() == digest_) {
        if (!(read_ == shown_)) {  // what has been said holds no more
            state_.say(name + " is on disk again as it is shown.");
        }
        read_ = shown_ = now;  // written again as it was
        return;
    }
    read_ = now;
    if (state_.edits().unsaved()) {
        state_.say(name + " has changed on disk; F5 reads it again, without your changes.");
        return;
    }
    try {
        if (const auto opened = load(file(), scene_of_tree())) {
            state_.renew(*opened);
            state_.say(name + " has changed on disk and was read again.");
        }
    } catch (const InputError& error) {
        state_.say(name + " has changed on disk and cannot be read; shown is what it was.\n" +
                   error.what());
    }
}

std::optional<std::filesystem::path> Files::scene_of_tree() const {
    return file() == state_.document()->file() ? std::nullopt
                                               : std::optional(state_.document()->file());
}

void Files::list_recent() {
    menu_->clear();
    if (remembers_) {
        recent_ = kept();
    }
    for (const std::string& one : recent_.files()) {
        const QFileInfo info(qt(one));
        const bool there = is_there(one);
        QAction* const action =
            menu_->addAction(QStringLiteral("%1 — %2%3")
                                 .arg(info.fileName(), info.absolutePath(),
                                      there ? QString() : QStringLiteral("  (missing)")));
        action->setEnabled(there);
        connect(action, &QAction::triggered, this,
                [this, one] { run(*find_command("file.open"), one); });
    }
    if (recent_.files().empty()) {
        menu_->addAction(QStringLiteral("none yet"))->setEnabled(false);
        return;
    }
    menu_->addSeparator();
    connect(menu_->addAction(QStringLiteral("Forget these")), &QAction::triggered, this, [this] {
        recent_.clear();
        QSettings().remove(recent_key());
    });
}

}  // namespace raytree::inspector
