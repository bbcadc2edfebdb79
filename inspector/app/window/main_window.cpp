#include "window/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTabBar>
#include <algorithm>
#include <initializer_list>
#include <utility>

#include "state/commands.h"
#include "state/details.h"
#include "window/actions.h"
#include "window/cheat_sheet.h"
#include "window/counts_pane.h"
#include "window/details_pane.h"
#include "window/diagram_pane.h"
#include "window/exporter.h"
#include "window/files.h"
#include "window/filter_pane.h"
#include "window/fitting_label.h"
#include "window/lesson_pane.h"
#include "window/outline_pane.h"
#include "window/panel_frame.h"
#include "window/picture_pane.h"
#include "window/qt_text.h"
#include "window/scene_pane.h"
#include "window/side_dock.h"
#include "window/theme.h"
#include "window/waiting.h"

namespace raytree::inspector {

MainWindow::MainWindow(State& state) : state_(state), feed_(state), theme_(state_.look().theme) {
    apply_theme(palette_of(theme_));
    setAcceptDrops(true);
    setDockOptions(QMainWindow::AnimatedDocks);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    setCentralWidget(make_centre());
    colour_message();
    picture_dock_ = add_dock(QStringLiteral("Picture"), make_picture_box(), Qt::LeftDockWidgetArea);
    details_ = new DetailsPane(state_);
    details_->setMinimumWidth(49 * fontMetrics().averageCharWidth());  // three columns of numbers
    details_dock_ = add_dock(QStringLiteral("Selected ray"), details_, Qt::LeftDockWidgetArea);
    add_tree_dock();
    add_lesson_dock();
    side_ = new SideDock(
        state_, [this](const std::string& command) { actions_->run(*find_command(command), {}); },
        [this](const InputError& error) { report(error); }, this);
    addDockWidget(Qt::RightDockWidgetArea, side_);

    pixel_ = new FittingLabel;
    counts_ = new FittingLabel;
    counts_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // has what is left
    counts_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    pixel_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    counts_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    statusBar()->addWidget(pixel_);
    statusBar()->addPermanentWidget(counts_, 1);
    statusBar()->setSizeGripEnabled(false);

    actions_ = new Actions(
        state_, this, [this](const QString& title) { return ask_file(title); },
        [this](const InputError& error) { report(error); });
    actions_->give_keys_to(picture_);
    actions_->give_keys_to(scene_);
    files_ = new Files(
        state_, this, [this](const QString& title) { return ask_file(title); },
        [this](const InputError& error) { report(error); });
    actions_->leave_to(*files_);
    new Exporter(state_, this, scene_);
    state_.set_beside([this](const std::string& doing, const std::function<void()>& work) {
        Waiting::finish(this, qt(doing) + QStringLiteral("…"), work);
    });
    working_.setInterval(10);
    connect(&working_, &QTimer::timeout, this, [this] { state_.poll(); });
    message_due_.setSingleShot(true);
    message_due_.setInterval(250);
    connect(&message_due_, &QTimer::timeout, this, &MainWindow::show_message);
    state_.observe([this](const Changes& changes) { obey(changes); });
}

void MainWindow::show_tab() {
    const int tab = static_cast<int>(state_.tree_pane().tab);
    if (tree_panes_->currentIndex() != tab) {
        tabs_->setCurrentIndex(tab);
        tree_panes_->setCurrentIndex(tab);
        if (!tabs_->hasFocus()) {  // arrow keys go on along the tabs
            tree_panes_->currentWidget()->setFocus();
        }
    }
}

void MainWindow::colour_message() {
    const Palette& palette = palette_of(theme_);
    message_->setStyleSheet(
        QStringLiteral("background: %1; border-bottom: 1px solid %2")
            .arg(qt(mixed(palette.panel, palette.light, 0.22)).name(), qt(palette.rule).name()));
}

void MainWindow::show_message() {
    message_due_.stop();
    message_->setText(qt(state_.message()));
    message_->setVisible(!state_.message().empty());
}

void MainWindow::obey(const Changes& changes) {
    if (changes.look && std::exchange(theme_, state_.look().theme) != state_.look().theme) {
        apply_theme(palette_of(theme_));  // has every widget polished anew
        colour_message();
    }
    if (changes.message) {
        // It takes its room from the 3D view: what is soon over is not worth saying.
        state_.working() ? message_due_.start() : show_message();
    }
    if (changes.playback && state_.document()) {
        show_status();
    }
    if (changes.tree) {
        show_status();
    }
    if (state_.working() != working_.isActive()) {
        state_.working() ? working_.start() : working_.stop();
    }
    if (changes.side_pane) {
        share_room();
    }
    if (changes.tree_pane) {
        show_tab();
        if (state_.tree_pane().tall != tall_tree_) {
            share_room();
        }
    }
    if (changes.lesson || changes.look) {
        show_lesson();
    }
    if (changes.selection) {
        const auto& thing = state_.thing();
        details_dock_->setWindowTitle(!thing ? QStringLiteral("Selected ray")
                                      : thing->kind == Thing::Kind::object
                                          ? QStringLiteral("Selected object")
                                          : QStringLiteral("Selected light"));
    }
    if (changes.values || changes.document) {
        setWindowModified(state_.edits().unsaved());
    }
    if (changes.request == Request::save_scene_as && !asks_) {
        throw InputError(state_.document()->file().string(), "",
                         "this is no .json file to save a scene into; file.save_as FILE names one");
    }
    if (changes.request == Request::save_scene_as) {
        actions_->run(*find_command("file.save_as"), {});
    } else if (changes.request == Request::cheat_sheet) {
        show_cheat_sheet(state_, this,
                         [this](const Command& command) { actions_->run(command, {}); });
    } else if (changes.request == Request::next_pane || changes.request == Request::previous_pane) {
        go_to_pane(changes.request == Request::next_pane ? 1 : -1);
    } else if (changes.request == Request::quit) {
        close();
    }
}

/// Gives the keys to the pane that is so many further, of those that are seen.
void MainWindow::go_to_pane(int by) {
    QList<QWidget*> panes;
    for (QWidget* const pane :
         std::initializer_list<QWidget*>{picture_, scene_, tree_panes_->currentWidget(), details_,
                                         lesson_pane_, side_->pane()}) {
        if (pane && pane->isVisible()) {
            panes << pane;
        }
    }
    const QWidget* const at = QApplication::focusWidget();
    const auto has_keys = [at](const QWidget* pane) {
        return at && (pane == at || pane->isAncestorOf(at) || pane->focusProxy() == at);
    };
    const auto count = static_cast<int>(panes.size());
    const auto found = std::find_if(panes.begin(), panes.end(), has_keys);
    const int from =
        found == panes.end() ? (by > 0 ? -1 : 0) : static_cast<int>(found - panes.begin());
    QWidget* const next = panes[(from + by + count) % count];
    next->setFocus(Qt::ShortcutFocusReason);
    if (!has_keys(next) && !next->hasFocus()) {  // a pane of fields: the first of them
        for (QWidget* inside = next->nextInFocusChain(); next->isAncestorOf(inside);
             inside = inside->nextInFocusChain()) {
            if (inside->isVisible() && inside->isEnabled() &&
                (inside->focusPolicy() & Qt::TabFocus) != 0) {
                inside->setFocus(Qt::ShortcutFocusReason);
                break;
            }
        }
    }
}

void MainWindow::show_status() {
    const Document& document = *state_.document();
    const std::string& name = document.scene().name;
    setWindowTitle(qt(name.empty() ? document.file().filename().string() : name) +
                   QStringLiteral("[*] — raytree inspector"));
    if (state_.tree()) {
        const bool pending = state_.playback() && state_.playback()->stage(0) != Stage::evaluated;
        const QString pixel = QStringLiteral("Pixel ") + qt(text_of(state_.pixel()));
        pixel_->set_texts({pending ? pixel + QStringLiteral("   … not known yet")
                           : !state_.tree()->gives_intensity(0)
                               ? pixel + QStringLiteral("   intensity not given")
                               : qt(pixel_text(state_.tree()->tree))});
        // The formula of the full tree first makes room, then the rays by kind.
        const QString all =
            qt(pending ? sent_text(*state_.playback()) : counts_text(state_.tree()->tree));
        counts_->set_texts(
            {all, all.section(QStringLiteral("   ·"), 0, 0), all.section(QLatin1Char(':'), 0, 0)});
    } else {
        pixel_->set_texts({QStringLiteral("Pixel ") + qt(text_of(state_.pixel()))});
        counts_->set_texts({});
    }
}

void MainWindow::show_hovered(std::optional<Pixel> pixel) {
    if (!pixel) {
        hovered_->set_texts({QStringLiteral("click chooses a pixel, the wheel zooms"),
                             QStringLiteral("click: pixel, wheel: zoom")});
        return;
    }
    QString text = qt(text_of(*pixel));
    if (feed_.overlay()) {
        text += QStringLiteral("   ") + qt(value_text(*feed_.overlay(), *pixel));
    } else if (const auto intensity = feed_.intensity(*pixel)) {
        text += QStringLiteral("   ") +
                qt(value_text(*intensity, state_.document()->scene().settings.quantize));
    }
    QString brief = text.simplified();
    const int channels = brief.indexOf(QLatin1Char('('));  // those that are clamped
    if (channels >= 0 && brief.endsWith(QStringLiteral("clamped)"))) {
        brief = brief.left(channels) + QStringLiteral("(clamped)");
    }
    hovered_->set_texts({text, text.simplified(), brief});
}

QString MainWindow::ask_file(const QString& title) {
    const QString folder =
        state_.document() ? QString::fromStdString(state_.document()->file().parent_path().string())
                          : QString();
    return QFileDialog::getOpenFileName(
        this, title, folder,
        QStringLiteral("Scenes and ray trees (*.json *.nff *.txt *.obj);;All files (*)"));
}

void MainWindow::report(const InputError& error) {
    QMessageBox box(QMessageBox::Warning, QStringLiteral("raytree inspector"),
                    QStringLiteral("This cannot be done; nothing has changed."), QMessageBox::Ok,
                    this);
    QString text = QString::fromUtf8(error.what());
    constexpr int longest = 1500;
    if (text.size() > longest) {
        text = text.left(longest) + QStringLiteral("\n…");
    }
    box.setInformativeText(text);
    box.setTextFormat(Qt::PlainText);
    box.setTextInteractionFlags(Qt::TextSelectableByMouse);
    box.exec();
}

void MainWindow::open(const QString& file) {
    actions_->run(*find_command("file.open"), file.toStdString());
}

void MainWindow::closeEvent(QCloseEvent* event) {
    event->setAccepted(!asks_ || files_->may_leave());
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    const auto urls = event->mimeData()->urls();
    if (!urls.isEmpty() && urls.front().isLocalFile()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    const auto urls = event->mimeData()->urls();
    if (urls.size() > 1) {
        report(InputError("", "",
                          std::to_string(urls.size()) +
                              " files were dropped; must be one: a scene or a ray tree"));
        return;
    }
    open(urls.front().toLocalFile());
}

}  // namespace raytree::inspector
