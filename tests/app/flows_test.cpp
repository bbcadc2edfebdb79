// Stepping, changing, comparing and files in the real window. Needs a display, such as Xvfb's.

#include <QApplication>
#include <QComboBox>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>
#include <QSettings>
#include <QSlider>
#include <QTemporaryDir>
#include <QTimer>
#include <QTreeWidget>
#include <QtTest>
#include <fstream>

#include "app/scenes.h"
#include "app/shown_window.h"
#include "formats/scene_json.h"
#include "formats/tree_json.h"
#include "state/commands.h"
#include "tree/record.h"
#include "window/change_pane.h"
#include "window/compare_pane.h"
#include "window/details_pane.h"
#include "window/files.h"
#include "window/outline_pane.h"
#include "window/picture_pane.h"
#include "window/side_dock.h"
#include "window/steps_pane.h"

namespace raytree::inspector {

class FlowsTest : public test::ShownWindow {
    Q_OBJECT

  private:
    QTemporaryDir folder_;
    QString details() const { return window_->details_pane().toPlainText(); }
    std::filesystem::path path(const char* name) const {
        return std::filesystem::path(folder_.path().toStdString()) / name;
    }
    static void write(const std::filesystem::path& file, const std::string& text) {
        std::ofstream(file, std::ios::binary) << text;
    }
    int rows(const QModelIndex& parent = {}) const {
        const QAbstractItemModel* const model = window_->outline_pane().model();
        int count = 0;
        for (int row = 0; row < model->rowCount(parent); ++row) {
            count += 1 + rows(model->index(row, 0, parent));
        }
        return count;
    }
    /// Answers the next question box by this button.
    static void answer(QMessageBox::StandardButton button, bool* asked) {
        *asked = false;
        QTimer::singleShot(150, [=] {
            auto* const box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (box) {
                *asked = true;
                box->button(button)->click();
            }
        });
    }

  private Q_SLOTS:
    void initTestCase() {
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder_.path());
        QApplication::setOrganizationName(QStringLiteral("raytree-test"));
        show_window();
        write(path("ball.json"), write_scene_json(test::glass_ball_scene()));
    }

    void init() {
        QApplication::setActiveWindow(window_.get());
        state_.show(test::opened(test::glass_ball_scene()));
        state_.show_side(SidePane::none);
        state_.pick({40, 30});
        QTest::qWait(30);
        canvas()->setFocus();
    }

    void keys_step_forward_and_back_in_every_view() {
        const std::size_t all = window_->scene_pane().paths().size();
        QTest::keyClick(canvas(), Qt::Key_Period);
        QVERIFY(window_->side_dock().isVisible());
        QCOMPARE(window_->scene_pane().paths().size(), std::size_t{1});
        QCOMPARE(rows(), 1);
        QVERIFY(details().contains(QStringLiteral("not known yet")));
        QVERIFY(!details().contains(QStringLiteral("Intensity")));
        QCOMPARE(window_->side_dock().steps().calls()->topLevelItemCount(), 1);
        for (int k = 0; k < 4; ++k) {
            QTest::keyClick(canvas(), Qt::Key_Period);
        }
        const std::size_t some = window_->scene_pane().paths().size();
        QVERIFY(some > 1 && some < all);
        QTest::keyClick(canvas(), Qt::Key_Comma);
        QCOMPARE(state_.playback()->stop(), std::size_t{3});
        QTest::keyClick(canvas(), Qt::Key_End, Qt::ControlModifier);
        QCOMPARE(window_->scene_pane().paths().size(), all);
        QVERIFY(details().contains(QStringLiteral("Intensity")));
        QCOMPARE(window_->side_dock().steps().calls()->topLevelItemCount(), 0);
    }

    void the_slider_of_steps_goes_to_a_step() {
        QTest::keyClick(canvas(), Qt::Key_Period);
        window_->side_dock().steps().position()->setValue(7);
        QCOMPARE(state_.playback()->stop(), std::size_t{7});
    }

    void a_call_of_the_stack_selects_its_ray() {
        run_command(state_, "step.to", "9");
        QTreeWidget* const calls = window_->side_dock().steps().calls();
        QVERIFY(calls->topLevelItemCount() > 1);
        calls->setCurrentItem(calls->topLevelItem(0));
        QCOMPARE(state_.selected()->id, std::size_t{0});
    }

    void playing_goes_on_by_itself() {
        run_command(state_, "step.faster");
        run_command(state_, "step.faster");
        run_command(state_, "step.play");
        QTRY_VERIFY(state_.playback()->stop() >= 2);
        run_command(state_, "step.play");
        const std::size_t stop = state_.playback()->stop();
        QTest::qWait(300);
        QCOMPARE(state_.playback()->stop(), stop);
    }

    void dragging_a_slider_changes_the_tree_and_is_one_undo() {
        QTest::keyClick(canvas(), Qt::Key_E);
        ChangePane& pane = window_->side_dock().change();
        pane.owners()->setCurrentIndex(0);
        QSlider* const depth = pane.slider("/settings/max_depth");
        QVERIFY(depth && depth->isVisible());
        const std::size_t before = state_.tree()->tree.rays.size();
        depth->setSliderDown(true);
        depth->setValue(3);
        depth->setValue(2);
        depth->setSliderDown(false);
        QCOMPARE(state_.document()->scene().settings.max_depth, 2);
        QCOMPARE(pane.field("/settings/max_depth")->text(), QStringLiteral("2"));
        QVERIFY(state_.tree()->own() < before);
        QCOMPARE(state_.tree()->tree.rays.size(), before);  // the rest are ghosts
        QVERIFY(window_->isWindowModified());
        QTest::keyClick(canvas(), Qt::Key_Escape);
        QCOMPARE(state_.tree()->grafted, std::size_t{0});
        QTest::keyClick(canvas(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(state_.document()->scene().settings.max_depth, 4);
        QCOMPARE(depth->value(), 4);
        QVERIFY(!window_->isWindowModified());
        QTRY_VERIFY(window_->feed().done());
    }

    void the_material_of_the_selected_hit_is_shown() {
        run_command(state_, "pane.change");
        ChangePane& pane = window_->side_dock().change();
        state_.select(1);
        for (const TreeRay<double>& ray : state_.tree()->tree.rays) {
            state_.select(ray.id);
            if (ray.shadow) {
                QCOMPARE(pane.owners()->currentText(),
                         QStringLiteral("Light ") + QString::fromStdString(ray.shadow->light));
            } else if (ray.hit) {
                QCOMPARE(pane.owners()->currentText(),
                         QStringLiteral("Material ") + QString::fromStdString(ray.hit->material));
            }
        }
    }

    void a_bad_value_in_a_field_is_told_and_changes_nothing() {
        run_command(state_, "pane.change");
        ChangePane& pane = window_->side_dock().change();
        pane.owners()->setCurrentIndex(0);
        const auto before = state_.document();
        QLineEdit* const depth = pane.field("/settings/max_depth");
        depth->setText(QStringLiteral("99"));
        QString told;
        QTimer::singleShot(100, [&] {
            auto* const box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            told = box ? box->informativeText() : QString();
            if (box) {
                box->close();
            }
        });
        Q_EMIT depth->editingFinished();
        QVERIFY2(told.contains(QStringLiteral("must be a whole number from 1 to 64")),
                 qPrintable(told));
        QVERIFY(state_.document() == before);
        QCOMPARE(depth->text(), QStringLiteral("4"));
    }

    void changes_follow_ten_times_a_second() {
        run_command(state_, "pane.change");
        window_->side_dock().change().owners()->setCurrentIndex(1);
        QSlider* const ior = window_->side_dock().change().slider("/materials/glass/ior");
        QVERIFY(ior);
        ior->setSliderDown(true);
        const int frames = window_->scene_pane().frames();
        for (int k = 0; k < 10; ++k) {
            ior->setValue(300 + 10 * k);
            const int before = window_->scene_pane().frames();
            QTRY_VERIFY(window_->scene_pane().frames() > before);  // each change is drawn
        }
        ior->setSliderDown(false);
        QVERIFY(window_->scene_pane().frames() >= frames + 10);
    }

    void two_pixels_are_compared_in_every_view() {
        QTest::keyClick(canvas(), Qt::Key_A);
        QVERIFY(window_->side_dock().compare().isVisible());
        state_.pick({2, 2});
        QTRY_VERIFY(state_.tree());
        QTreeWidget* const lines = window_->side_dock().compare().lines();
        QVERIFY(lines->topLevelItemCount() > 1);
        QVERIFY(details().contains(QStringLiteral("differs")));
        const QModelIndex root = window_->outline_pane().model()->index(0, 0, {});
        QVERIFY(root.data().toString().contains(QStringLiteral("≠")));
        lines->setCurrentItem(lines->topLevelItem(1));
        QVERIFY(!state_.tree()->is_own(state_.selected()->id));
        QVERIFY(details().contains(QStringLiteral("missing")));
        QTest::keyClick(canvas(), Qt::Key_A, Qt::ShiftModifier);
        QVERIFY(!state_.comparing());
        QCOMPARE(lines->topLevelItemCount(), 0);
    }

    void a_recorded_tree_is_compared_with_the_true_one() {
        const Scene scene = test::glass_ball_scene();
        RayTree<double> theirs = record_tree(World<double>(scene), 40, 30);
        theirs.rays[1].diffuse = Rgb<double>(0.9);
        write(path("tree.json"), write_tree_json(theirs, &scene));
        window_->open(QString::fromStdString(path("tree.json").string()));
        QTRY_VERIFY(state_.tree() && state_.tree()->recorded);
        QVERIFY(window_->side_dock().compare().isVisible());
        QTest::keyClick(canvas(), Qt::Key_D);
        QCOMPARE(state_.selected()->id, std::size_t{1});
        QVERIFY(details().contains(QStringLiteral("As recorded in the file")));
        QTest::keyClick(canvas(), Qt::Key_O);
        QTRY_VERIFY(state_.tree() && !state_.tree()->recorded);
    }

    void unsaved_changes_are_asked_about() {
        window_->open(QString::fromStdString(path("ball.json").string()));
        run_command(state_, "change.set", "/materials/glass/ior 1.7");
        bool asked = false;
        answer(QMessageBox::Cancel, &asked);
        window_->open(QString::fromStdString(path("ball.json").string()));
        QVERIFY(asked);
        QVERIFY(state_.edits().unsaved());
        answer(QMessageBox::Cancel, &asked);
        QVERIFY(!window_->close());
        QVERIFY(asked);
        answer(QMessageBox::Save, &asked);
        window_->open(QString::fromStdString(path("ball.json").string()));
        QVERIFY(asked);
        QVERIFY(!state_.edits().unsaved());
        QCOMPARE(state_.document()->scene().materials[0].ior, 1.7);
        run_command(state_, "change.set", "/materials/glass/ior 1.9");
        answer(QMessageBox::Discard, &asked);
        window_->open(QString::fromStdString(path("ball.json").string()));
        QVERIFY(asked);
        QCOMPARE(state_.document()->scene().materials[0].ior, 1.7);
    }

    void a_scene_that_changes_on_disk_is_read_again() {
        const auto file = path("watched.json");
        Scene scene = test::glass_ball_scene();
        write(file, write_scene_json(scene));
        window_->open(QString::fromStdString(file.string()));
        state_.pick({41, 31});
        for (const bool replaced : {false, true}) {
            scene.materials[0].ior += 0.1;
            const auto target = replaced ? path("new.tmp") : file;
            write(target, write_scene_json(scene));
            if (replaced) {  // as many editors do
                std::filesystem::rename(target, file);
            }
            QTRY_COMPARE(state_.document()->scene().materials[0].ior, scene.materials[0].ior);
            QVERIFY(state_.pixel() == (Pixel{41, 31}));
            QTest::qWait(300);
        }
        const auto before = state_.document();
        write(file, "{ broken");
        QTRY_VERIFY(state_.message().find("cannot be read") != std::string::npos);
        QVERIFY(state_.document() == before);
        QTest::qWait(20);  // the same bytes at another time
        write(file, write_scene_json(scene));
        QTRY_VERIFY(state_.message().find("again as it is shown") != std::string::npos);
        QVERIFY(state_.document() == before);
        state_.say({});
        QTest::qWait(20);
        write(file, write_scene_json(scene));
        QTest::qWait(500);
        QVERIFY2(state_.message().empty(), state_.message().c_str());
        scene.materials[0].ior = 1.3;
        write(file, write_scene_json(scene));
        QTRY_COMPARE(state_.document()->scene().materials[0].ior, 1.3);
    }

    void recent_files_are_listed_and_those_that_are_gone_greyed() {
        window_->files().remember();
        write(path("gone.json"), write_scene_json(test::glass_ball_scene()));
        window_->open(QString::fromStdString(path("gone.json").string()));
        window_->open(QString::fromStdString(path("ball.json").string()));
        std::filesystem::remove(path("gone.json"));
        QMenu* const menu = window_->files().recent_menu();
        Q_EMIT menu->aboutToShow();
        QVERIFY(menu->actions().at(0)->text().contains(QStringLiteral("ball.json")));
        QVERIFY(menu->actions().at(0)->isEnabled());
        QVERIFY(menu->actions().at(1)->text().contains(QStringLiteral("gone.json")));
        QVERIFY(!menu->actions().at(1)->isEnabled());
    }

    void a_long_number_is_shortened_until_it_is_edited() {
        Scene scene = test::glass_ball_scene();
        scene.background = {0.31242852301646, 0.2718281828459, 0.14142135623731};
        write(path("long.json"), write_scene_json(scene));
        window_->open(QString::fromStdString(path("long.json").string()));
        QTRY_VERIFY(state_.tree());
        state_.show_side(SidePane::change);
        ChangePane& change = window_->side_dock().change();
        change.owners()->setCurrentIndex(0);
        QTRY_VERIFY(change.field("/background"));
        QLineEdit& field = *change.field("/background");
        const QString whole = QStringLiteral("0.31242852301646, 0.2718281828459, 0.14142135623731");
        QCOMPARE(field.toolTip(), whole);
        QVERIFY(field.fontMetrics().horizontalAdvance(field.text()) < field.maximumWidth());
        QApplication::setActiveWindow(window_.get());
        field.setFocus();
        QCOMPARE(field.text(), whole);
        window_->picture_pane().setFocus();  // nothing was typed: nothing has changed
        QVERIFY(field.text() != whole);
        QVERIFY(!state_.edits().unsaved());
        state_.show_side(SidePane::none);
    }

    void saving_over_what_somebody_else_has_written_asks_first() {
        const auto file = path("shared.json");
        write(file, write_scene_json(test::glass_ball_scene()));
        window_->open(QString::fromStdString(file.string()));
        QTRY_VERIFY(state_.tree());
        run_command(state_, "change.set", "/settings/max_depth 2");
        Scene theirs = test::glass_ball_scene();
        theirs.settings.max_depth = 9;
        write(file, write_scene_json(theirs));
        const auto depth_on_disk = [&] {
            return open_file(file).document->scene().settings.max_depth;
        };
        for (const QString& answer : {QStringLiteral("Cancel"), QStringLiteral("Overwrite")}) {
            QTimer hand;
            QString told;
            connect(&hand, &QTimer::timeout, this, [&] {
                auto* const box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
                for (QAbstractButton* const button :
                     box ? box->buttons() : QList<QAbstractButton*>()) {
                    if (button->text().remove(QLatin1Char('&')) == answer) {
                        hand.stop();
                        told = box->text();
                        button->click();
                        break;
                    }
                }
            });
            hand.start(10);
            QApplication::setActiveWindow(window_.get());
            QTest::keyClick(window_.get(), Qt::Key_S, Qt::ControlModifier);
            QVERIFY2(told.contains(QStringLiteral("has changed on disk")), qPrintable(told));
            QCOMPARE(depth_on_disk(), answer == QStringLiteral("Cancel") ? 9 : 2);
        }
        // What was saved here is known: it is saved again without a word.
        run_command(state_, "change.set", "/settings/max_depth 3");
        QApplication::setActiveWindow(window_.get());
        QTest::keyClick(window_.get(), Qt::Key_S, Qt::ControlModifier);
        QCOMPARE(depth_on_disk(), 3);
    }

    void a_file_that_is_gone_is_told() {
        const auto file = path("leaving.json");
        const std::string text = write_scene_json(test::glass_ball_scene());
        write(file, text);
        window_->open(QString::fromStdString(file.string()));
        QTRY_VERIFY(state_.tree());
        std::filesystem::remove(file);
        QTRY_VERIFY(
            QString::fromStdString(state_.message()).contains(QStringLiteral("no longer on disk")));
        // Once it is there again, as it was, nothing is read again.
        const auto before = state_.document();
        write(file, text);
        QTRY_VERIFY(
            QString::fromStdString(state_.message()).contains(QStringLiteral("on disk again")));
        QVERIFY(state_.document() == before);
    }

    void the_table_keeps_the_selection_when_the_scene_is_saved() {
        const auto file = path("saved.json");
        write(file, write_scene_json(test::glass_ball_scene()));
        window_->open(QString::fromStdString(file.string()));
        state_.pick({40, 30});
        QTRY_VERIFY(state_.tree());
        state_.select(2);
        run_command(state_, "change.set", "/settings/max_depth 3");
        QTRY_VERIFY(state_.tree() && !state_.working());
        run_command(state_, "file.save");
        const auto& outline = window_->outline_pane();
        const auto* const model = static_cast<const OutlineModel*>(outline.model());
        QVERIFY(outline.currentIndex().isValid());
        QCOMPARE(model->row(outline.currentIndex()).ray, state_.selected()->id);
    }

    void a_long_load_leaves_the_window_working_and_can_be_cancelled() {
        Scene many = test::glass_ball_scene();
        for (int k = 0; k < 60'000; ++k) {
            Object ball;
            ball.name = "ball" + std::to_string(k);
            ball.material = 1;
            ball.shape = Sphere{{0.01 * k, 0.5, -5.0 - 0.01 * k}, 0.2};
            many.objects.push_back(std::move(ball));
        }
        write(path("many.json"), write_scene_json(many));
        const auto before = state_.document();
        qint64 longest = 0;
        QElapsedTimer since;
        QTimer beat;
        connect(&beat, &QTimer::timeout, this,
                [&] { longest = std::max(longest, since.restart()); });
        bool cancelled = false;
        QTimer hand;
        connect(&hand, &QTimer::timeout, this, [&] {
            for (auto* const dialog : window_->findChildren<QProgressDialog*>()) {
                hand.stop();
                dialog->cancel();
                cancelled = true;
            }
        });
        hand.start(10);
        since.start();
        beat.start(5);
        window_->open(QString::fromStdString(path("many.json").string()));
        QVERIFY(cancelled);
        QVERIFY(state_.document() == before);
        QVERIFY2(longest < 1000, qPrintable(QString::number(longest)));
        window_->open(QString::fromStdString(path("many.json").string()));
        QCOMPARE(state_.document()->scene().objects.size(), many.objects.size());
    }

    void cleanupTestCase() {
        state_.show(test::opened(test::glass_ball_scene()));
        window_.reset();
    }
};

}  // namespace raytree::inspector

int main(int argc, char** argv) {
    return raytree::inspector::test::run_tests<raytree::inspector::FlowsTest>(argc, argv);
}

#include "flows_test.moc"
