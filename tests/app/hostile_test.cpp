// What no hand does on purpose: a window that is closed or told something else while it reads, and
// thousands of commands, clicks and keys in no order. Needs a display, such as Xvfb's.
//
// RAYTREE_HOSTILE="SEED COUNT" has the commands begin elsewhere and go on for longer.

#include <QApplication>
#include <QDialog>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>
#include <QSettings>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTimer>
#include <QtTest>
#include <atomic>
#include <fstream>
#include <new>
#include <random>
#include <sstream>

#include "app/sample_lessons.h"
#include "app/scenes.h"
#include "app/shown_window.h"
#include "formats/scene_json.h"
#include "scene/progress.h"
#include "state/commands.h"
#include "view3d/scene_drawing.h"
#include "window/details_pane.h"
#include "window/files.h"
#include "window/fitting_tabs.h"
#include "window/outline_pane.h"
#include "window/picture_pane.h"
#include "window/qt_text.h"
#include "window/side_dock.h"
#include "window/waiting.h"

namespace raytree::inspector {
namespace {

using namespace std::chrono_literals;

/// Work that tells how far it is until it may end, or is stopped.
struct SlowWork {
    std::atomic<bool> may_end{false}, stopped{false};

    void run() {
        try {
            while (!may_end) {
                tell_progress("counting", 0.25);
                std::this_thread::sleep_for(1ms);
            }
        } catch (const Stopped&) {
            stopped = true;
            throw;
        }
    }
};

/// A window that has nothing to show yet.
struct Beginning {
    State state;
    MainWindow window{state};
    SlowWork work;

    Beginning() { window.show(); }
    /// For what is read once the work is done; does something to the window meanwhile.
    bool wait(const FirstView& view, const std::function<void()>& meanwhile) {
        FirstReading reading = begin_reading([&] {
            work.run();
            return view;
        });
        QTimer::singleShot(150, &window, meanwhile);
        return wait_until_read(state, window, reading);
    }
};

}  // namespace

class HostileTest : public test::ShownWindow {
    Q_OBJECT

  private:
    QTemporaryDir folder_;
    test::Lessons lessons_{"raytree-hostile-lessons"};
    std::mt19937 dice_{1};
    std::vector<std::string> done_;  ///< since the start, to be told of what fails

    std::string path(const char* name) const { return (folder_.path() + "/" + name).toStdString(); }
    std::size_t below(std::size_t count) { return dice_() % count; }
    int between(int from, int to) {
        return from + static_cast<int>(below(static_cast<std::size_t>(to - from + 1)));
    }
    template <class Choices> auto one_of(const Choices& choices) {
        return choices[below(std::size(choices))];
    }

    /// A sensible argument, or a wrong one.
    std::string argument_for(const Command& command) {
        const std::string id(command.id);
        switch (command.argument) {
            case Argument::pixel:
                return std::to_string(between(-3, 90)) + "," + std::to_string(between(-3, 70));
            case Argument::ray:
                return std::to_string(between(-1, 40));
            case Argument::file:
                return path(one_of(std::array{"ball.json", "ball.json", "tree.json", "broken.json",
                                              "missing.json", "lesson.json"}));
            case Argument::new_file:
                return path(one_of(std::array{"out.json", "out.png", "no/such/folder/out.json"}));
            default:
                break;
        }
        if (id == "change.set" || id == "change.drag") {
            return one_of(std::array{"/settings/max_depth ", "/lights/0/intensity ",
                                     "/materials/glass/ior ", "/materials/red/kd ",
                                     "/no/such/place ", "/settings/min_weight "}) +
                   std::to_string(between(-1, 12) * 0.25);
        }
        if (id.starts_with("lesson.open")) {
            return one_of(std::array{"ball", "again", "none"});
        }
        return one_of(std::array{"1", "2", "3", "7", "99", "a", "b", "ball", "key",
                                 "kind shadow hidden", "level 2 dimmed", "t", "weight", "nonsense",
                                 ""});
    }

    void run_any_command() {
        const Command& command = commands()[below(commands().size())];
        const std::string id(command.id);
        if (id == "file.quit" || id == "explain.accuracy") {  // the latter takes seconds
            return;
        }
        const std::string argument = argument_for(command);
        done_.push_back(id + " " + argument);
        try {
            if (!window_->files().run(command, argument)) {
                run_command(state_, id, argument);
            }
        } catch (const InputError&) {  // a wrong argument
        }
    }

    void click_anywhere() {
        QList<QWidget*> shown;
        for (QWidget* const widget : window_->findChildren<QWidget*>()) {
            if (widget->isVisible() && widget->window() == window_.get() &&
                !widget->size().isEmpty()) {
                shown.push_back(widget);
            }
        }
        QWidget* const widget =
            shown[static_cast<int>(below(static_cast<std::size_t>(shown.size())))];
        const QPoint at(between(0, widget->width() - 1), between(0, widget->height() - 1));
        done_.push_back(std::string("click ") + widget->metaObject()->className());
        const auto button = below(8) == 0 ? Qt::RightButton : Qt::LeftButton;
        below(4) == 0 ? QTest::mouseDClick(widget, button, {}, at)
                      : QTest::mouseClick(widget, button, {}, at);
    }

    void press_any_key() {
        constexpr Qt::Key keys[] = {Qt::Key_Left,   Qt::Key_Down,  Qt::Key_Tab,   Qt::Key_Space,
                                    Qt::Key_Return, Qt::Key_Home,  Qt::Key_N,     Qt::Key_P,
                                    Qt::Key_Period, Qt::Key_Comma, Qt::Key_Z,     Qt::Key_T,
                                    Qt::Key_Escape, Qt::Key_1,     Qt::Key_E,     Qt::Key_D,
                                    Qt::Key_Up,     Qt::Key_Right, Qt::Key_Delete};
        constexpr Qt::KeyboardModifier modifiers[] = {Qt::NoModifier, Qt::NoModifier,
                                                      Qt::ShiftModifier, Qt::ControlModifier};
        QWidget* const widget = QApplication::focusWidget();
        const Qt::Key key = one_of(keys);
        const Qt::KeyboardModifier modifier = one_of(modifiers);
        done_.push_back("key " + std::to_string(key));
        QTest::keyClick(widget ? widget : window_.get(), key, modifier);
    }

    /// Whatever comes up is answered somehow, in the next round of events.
    void answer_dialogs() {
        if (auto* const menu = QApplication::activePopupWidget()) {
            menu->close();
        } else if (QWidget* const dialog = QApplication::activeModalWidget()) {
            const auto buttons = dialog->findChildren<QPushButton*>();
            qobject_cast<QMessageBox*>(dialog) && !buttons.isEmpty()
                ? buttons[static_cast<int>(below(static_cast<std::size_t>(buttons.size())))]
                      ->click()
                : static_cast<void>(dialog->close());
        }
    }

    QByteArray last_done() const {
        std::string all;
        for (std::size_t k = done_.size() - std::min<std::size_t>(done_.size(), 25);
             k < done_.size(); ++k) {
            all += "\n" + done_[k];
        }
        return QByteArray::fromStdString(all);
    }

    /// What the panes show is what the state says.
    void check_in_step() {
        QTRY_VERIFY_WITH_TIMEOUT(!state_.working() && !state_.busy(), 60'000);
        QTRY_VERIFY_WITH_TIMEOUT(window_->scene_pane().is_current(), 60'000);
        const QByteArray after = last_done();
        QCOMPARE(window_->side_dock().isVisible(), state_.side_pane() != SidePane::none);
        const auto* const model = static_cast<const OutlineModel*>(window_->outline_pane().model());
        const QModelIndex row = window_->outline_pane().currentIndex();
        if (!state_.tree()) {
            return;
        }
        QVERIFY2(state_.selected()->id < state_.tree()->tree.rays.size(), after);
        if (window_->outline_pane().isVisible()) {
            QVERIFY2(!row.isValid() || model->row(row).ray == state_.selected()->id, after);
            QVERIFY2(row.isValid() || state_.playback(), after);
        }
        if (!state_.thing() && state_.tree()->is_own(state_.selected()->id)) {
            const QString id = QStringLiteral("#%1").arg(state_.selected()->id);
            QVERIFY2(window_->details_pane().toPlainText().contains(id), after);
        }
        QVERIFY2(window_->findChild<FittingTabs*>()->currentIndex() ==
                     static_cast<int>(state_.tree_pane().tab),
                 after);
        const QColor ground = qt(palette_of(state_.look().theme).window);
        QVERIFY2(QApplication::palette().color(QPalette::Window) == ground, after);
    }

  private Q_SLOTS:
    void initTestCase() {
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder_.path());
        QApplication::setOrganizationName(QStringLiteral("raytree-test"));
        std::ofstream(path("ball.json")) << write_scene_json(test::glass_ball_scene());
        std::ofstream(path("broken.json")) << "{\"format\": \"raytree-scene/1.0\", ";
        state_.set_lesson_folder(lessons_.folder);
        show_window();
        state_.show(open_file(path("ball.json")));
        run_command(state_, "export.tree_json", path("tree.json"));
    }

    void a_window_answers_while_its_first_scene_is_read() {
        Beginning first;
        QVERIFY(QTest::qWaitForWindowExposed(&first.window));
        std::string said;
        const auto look = [&] {
            said = first.state.message();
            first.window.resize(1000, 700);
            run_command(first.state, "look.dark");
            first.work.may_end = true;
        };
        const auto show = [](State& state) { state.show(test::opened(test::glass_ball_scene())); };
        QVERIFY(first.wait(show, look));
        QVERIFY2(said.find("counting, 25 %") != std::string::npos, said.c_str());
        QVERIFY(first.state.document());
        QVERIFY(first.state.message().empty());
        QCOMPARE(first.state.look().theme, Theme::dark);
        run_command(first.state, "look.dark");
    }

    void a_window_that_is_closed_reads_no_further() {
        Beginning first;
        QVERIFY(!first.wait([](State&) {}, [&] { first.window.close(); }));
        QVERIFY(first.work.stopped);
        QVERIFY(!first.state.document());
        QCOMPARE(WorkProgress::running(), 0);
    }

    void what_is_opened_meanwhile_stays() {
        Beginning first;
        const auto open = [&] { first.window.open(qt(path("ball.json"))); };
        QVERIFY(first.wait([](State&) { QFAIL("nobody wants it any longer"); }, open));
        QVERIFY(first.work.stopped);
        QCOMPARE(first.state.document()->file(), std::filesystem::path(path("ball.json")));
    }

    void a_first_scene_that_cannot_be_read_is_told() {
        State state;
        const MainWindow window(state);
        FirstReading reading = begin_reading([&]() -> FirstView {
            open_file(path("broken.json"));
            return [](State&) {};
        });
        QVERIFY_EXCEPTION_THROWN(wait_until_read(state, *window_, reading), InputError);
    }

    void long_work_says_how_far_it_is_and_can_be_cancelled() {
        for (const bool cancels : {false, true}) {
            SlowWork work;
            QString said;
            int beats = 0, share = 0;
            QTimer beat;
            connect(&beat, &QTimer::timeout, this, [&] {
                ++beats;
                const auto dialogs = window_->findChildren<QProgressDialog*>();
                if (beats < 60 || dialogs.isEmpty()) {
                    return;
                }
                said = dialogs.front()->labelText();
                share = dialogs.front()->value();
                cancels ? dialogs.front()->cancel() : static_cast<void>(work.may_end = true);
            });
            beat.start(5);
            const auto answer = Waiting().wait(window_.get(), QStringLiteral("Working…"), [&] {
                work.run();
                return 7;
            });
            QCOMPARE(answer, cancels ? std::nullopt : std::optional(7));
            QVERIFY2(said.contains(QStringLiteral("counting")), qPrintable(said));
            QCOMPARE(share, 25);
            QTRY_COMPARE(work.stopped.load(), cancels);
        }
    }

    void a_frame_for_which_memory_is_too_little_is_told_and_the_next_is_drawn() {
        std::atomic<bool> fails{true};
        SceneDrawing drawing(std::make_shared<RightOfWay>(), [&] {
            if (fails.exchange(false)) {
                throw std::bad_alloc();
            }
        });
        SceneFrame frame;
        frame.shapes = std::make_shared<SceneMesh>();
        frame.things = std::make_shared<SceneThings>();
        frame.view.width = frame.view.height = 64;
        const int first = drawing.draw(frame);
        QCOMPARE(drawing.wait().number, first);
        QVERIFY(drawing.wait().failed);  // that it was there could not be told
        const int next = drawing.draw(frame);
        const DrawnFrame drawn = drawing.wait();
        QVERIFY(!drawn.failed);
        QCOMPARE(drawn.number, next);
        QCOMPARE(drawn.image.width, 64);
    }

    void commands_clicks_and_keys_in_no_order() {
        std::istringstream asked(qgetenv("RAYTREE_HOSTILE").toStdString());
        unsigned seed = 7, count = 500;
        asked >> seed >> count;
        dice_.seed(seed);
        window_->resize(900, 600);
        QTimer answering;
        connect(&answering, &QTimer::timeout, this, [this] { answer_dialogs(); });
        answering.start(3);
        for (unsigned k = 1; k <= count; ++k) {
            if (!window_->isVisible()) {  // a key in a menu can be Quit
                window_->show();
            }
            const std::size_t what = below(10);
            what < 6 ? run_any_command() : what < 8 ? press_any_key() : click_anywhere();
            if (below(3) == 0) {
                QApplication::processEvents();
            }
            if (k % 50 == 0) {
                while (QApplication::activePopupWidget() || QApplication::activeModalWidget()) {
                    QTest::qWait(5);
                }
                check_in_step();
                if (QTest::currentTestFailed()) {
                    return;
                }
            }
        }
        answering.stop();
    }

    void cleanupTestCase() {
        state_.show(test::opened(test::glass_ball_scene()));
        window_.reset();
    }
};

}  // namespace raytree::inspector

int main(int argc, char** argv) {
    return raytree::inspector::test::run_tests<raytree::inspector::HostileTest>(argc, argv);
}

#include "hostile_test.moc"
