// The real window, driven by clicks and keys. Needs a display, such as Xvfb's.

#include <QAbstractItemModel>
#include <QAction>
#include <QApplication>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTimer>
#include <QTreeWidget>
#include <QUrl>
#include <QtTest>
#include <set>

#include "app/scenes.h"
#include "app/shown_window.h"
#include "folders.h"
#include "state/commands.h"
#include "window/counts_pane.h"
#include "window/details_pane.h"
#include "window/diagram_pane.h"
#include "window/outline_pane.h"
#include "window/picture_pane.h"
#include "window/side_dock.h"

namespace raytree::inspector {

class WindowTest : public test::ShownWindow {
    Q_OBJECT

  private:
    std::size_t outline_ray() const {
        const auto* model = static_cast<const OutlineModel*>(window_->outline_pane().model());
        return model->row(window_->outline_pane().currentIndex()).ray;
    }
    /// The ray is selected everywhere, in the outline as soon as that is seen, too.
    void check_linked(std::size_t ray) {
        QCOMPARE(state_.selected()->id, ray);
        const TreePane pane = state_.tree_pane();
        run_command(state_, "tab.outline");
        QCOMPARE(outline_ray(), ray);
        state_.change_tree_pane(pane);
        QVERIFY(window_->details_pane().toPlainText().contains(QStringLiteral("#%1").arg(ray)));
    }

    /// What a dialog says that comes up meanwhile; it is closed then.
    template <class Act> static QString told_when(Act act) {
        QString told;
        QTimer looking;
        QObject::connect(&looking, &QTimer::timeout, [&] {
            if (auto* const box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                told = box->informativeText();
                box->close();
            }
        });
        looking.start(20);
        act();
        return told;
    }

    /// Whether the window takes the file.
    bool drop(const QStringList& files) {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString& file : files) {
            urls << QUrl::fromLocalFile(file);
        }
        data.setUrls(urls);
        QDragEnterEvent enter({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window_.get(), &enter);
        QDropEvent drop({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window_.get(), &drop);
        return enter.isAccepted();
    }

  private Q_SLOTS:
    void initTestCase() {
        show_window();
        state_.show(test::opened(test::glass_ball_scene()));
        QTRY_VERIFY(window_->feed().done());
        QTRY_VERIFY(window_->scene_pane().frames() > 0);
    }

    void init() {
        QApplication::setActiveWindow(window_.get());  // where no window manager does
        state_.pick({0, 0});
        state_.pick({40, 30});
        state_.request(Request::from_side);
        QTest::qWait(50);
    }

    void a_click_in_the_picture_chooses_the_pixel() {
        PicturePane& picture = window_->picture_pane();
        QTest::mouseClick(&picture, Qt::LeftButton, {}, picture.place_of({12, 34}).toPoint());
        QCOMPARE(state_.pixel().i, 12);
        QCOMPARE(state_.pixel().j, 34);
        check_linked(0);
    }

    void a_drag_in_the_picture_chooses_where_it_ends() {
        PicturePane& picture = window_->picture_pane();
        QTest::mousePress(&picture, Qt::LeftButton, {}, picture.place_of({10, 10}).toPoint());
        const QPointF end = picture.place_of({50, 20});
        QMouseEvent move(QEvent::MouseMove, end, Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(&picture, &move);
        QTest::mouseRelease(&picture, Qt::LeftButton, {}, end.toPoint());
        QCOMPARE(state_.pixel().i, 50);
        QCOMPARE(state_.pixel().j, 20);
    }

    void details_that_stay_the_same_stay_where_they_are() {
        QScrollBar& bar = *window_->details_pane().verticalScrollBar();
        QVERIFY(bar.maximum() > 0);
        bar.setValue(bar.maximum());
        run_command(state_, "show.shadow");
        run_command(state_, "show.shadow");
        QCOMPARE(bar.value(), bar.maximum());
        state_.select(1);
        QCOMPARE(bar.value(), 0);
    }

    void panes_follow_what_has_changed_while_they_were_hidden() {
        run_command(state_, "tab.counts");
        state_.select(2);
        run_command(state_, "change.set", "/settings/max_depth 2");
        QTRY_VERIFY(!state_.working());
        run_command(state_, "tab.outline");
        check_linked(state_.selected()->id);
        run_command(state_, "change.undo");
        QTRY_VERIFY(!state_.working());
    }

    void arrows_move_the_pixel() {
        window_->picture_pane().setFocus();
        QTest::keyClick(&window_->picture_pane(), Qt::Key_Right);
        QTest::keyClick(&window_->picture_pane(), Qt::Key_Down, Qt::ShiftModifier);
        QCOMPARE(state_.pixel().i, 41);
        QCOMPARE(state_.pixel().j, 40);
    }

    void arrows_go_through_an_open_menu_and_leave_the_pixel() {
        PicturePane& picture = window_->picture_pane();
        picture.setFocus();
        state_.pick({20, 20});
        QMenu& menu = *window_->menuBar()->actions().front()->menu();
        menu.popup(window_->mapToGlobal({10, 30}));
        QTRY_VERIFY(QApplication::activePopupWidget());
        QTest::keyClick(&picture, Qt::Key_Right);
        QTest::keyClick(&picture, Qt::Key_Down);
        menu.close();
        QCOMPARE(state_.pixel(), (Pixel{20, 20}));
        QTest::keyClick(&picture, Qt::Key_Right);
        QCOMPARE(state_.pixel(), (Pixel{21, 20}));
    }

    void each_menu_has_a_key_of_its_own() {
        QString keys;
        for (const QAction* const menu : window_->menuBar()->actions()) {
            const int at = menu->text().indexOf(QLatin1Char('&'));
            QVERIFY2(at >= 0, qPrintable(menu->text()));
            const QChar key = menu->text()[at + 1].toLower();
            QVERIFY2(!keys.contains(key), qPrintable(menu->text()));
            keys += key;
        }
    }

    void the_wheel_zooms_about_the_cursor() {
        PicturePane& picture = window_->picture_pane();
        const QPointF at = picture.place_of({40, 30});
        const double before = picture.place_of({41, 30}).x() - at.x();
        QWheelEvent wheel(at, picture.mapToGlobal(at.toPoint()), {}, {0, 120}, Qt::NoButton, {},
                          Qt::NoScrollPhase, false);
        for (int k = 0; k < 8; ++k) {
            QApplication::sendEvent(&picture, &wheel);
        }
        QVERIFY(picture.place_of({41, 30}).x() - picture.place_of({40, 30}).x() > 3 * before);
        QVERIFY((picture.place_of({40, 30}) - at).manhattanLength() < 8);
        state_.request(Request::fit_picture);
        QVERIFY(std::abs(picture.place_of({40, 30}).x() - at.x()) < 0.01);
    }

    void keys_step_through_the_tree() {
        canvas()->setFocus();
        QTest::keyClick(canvas(), Qt::Key_N);
        check_linked(1);
        QTest::keyClick(canvas(), Qt::Key_N);
        check_linked(2);
        QTest::keyClick(canvas(), Qt::Key_B);
        check_linked(1);
        QTest::keyClick(canvas(), Qt::Key_P);
        check_linked(0);
    }

    void a_row_of_the_outline_selects_its_ray() {
        const auto* model = static_cast<const OutlineModel*>(window_->outline_pane().model());
        const QModelIndex index = model->index_of_ray(3);
        window_->outline_pane().setCurrentIndex(index);
        check_linked(3);
    }

    void a_click_in_3d_selects_the_ray_under_it() {
        ScenePane& pane = window_->scene_pane();
        for (const RayPath& path : pane.paths()) {
            const QPoint at = pane.place_of(path.from + (path.to - path.from) * 0.45)->toPoint();
            const auto nearest = path_at(pane.paths(), pane.view(), at.x(), at.y(), 9);
            if (!pane.rect().contains(at) || pane.paths()[nearest.value()].ray != path.ray) {
                continue;  // another ray is nearer on the screen
            }
            QTest::mouseClick(canvas(), Qt::LeftButton, {}, at);
            check_linked(path.ray);
        }
    }

    void a_drag_in_3d_turns_the_view_and_selects_nothing() {
        const Point3 before = window_->scene_pane().view().eye;
        QTest::mousePress(canvas(), Qt::LeftButton, {}, {200, 200});
        for (int x = 200; x <= 260; x += 20) {
            QMouseEvent move(QEvent::MouseMove, QPointF(x, 200), Qt::NoButton, Qt::LeftButton, {});
            QApplication::sendEvent(canvas(), &move);
        }
        QTest::mouseRelease(canvas(), Qt::LeftButton, {}, {260, 200});
        QVERIFY(window_->scene_pane().view().eye != before);
        QCOMPARE(state_.selected()->id, std::size_t{0});
    }

    void switches_and_theme_follow_the_state() {
        QTest::keyClick(canvas(), Qt::Key_T);
        QVERIFY(state_.look().theme == Theme::dark);
        QTest::keyClick(canvas(), Qt::Key_S);
        QVERIFY(state_.look().filter.of(group_of(RayKind::shadow)) == Shown::hidden);
        QTest::keyClick(canvas(), Qt::Key_S);
        QTest::keyClick(canvas(), Qt::Key_T);
        QVERIFY(state_.look().filter.empty());
        QVERIFY(state_.look().theme == Theme::light);
    }

    void keys_act_in_the_outline_too() {
        window_->outline_pane().setFocus();
        QTest::keyClick(&window_->outline_pane(), Qt::Key_N);
        check_linked(1);
        const QModelIndex before = window_->outline_pane().currentIndex();
        QTest::keyClick(&window_->outline_pane(), Qt::Key_Down);  // goes to the next row
        QVERIFY(window_->outline_pane().currentIndex() != before);
        check_linked(state_.selected()->id);
    }

    void a_click_in_the_diagram_selects_its_ray() {
        run_command(state_, "tab.diagram");
        DiagramPane& diagram = window_->diagram_pane();
        QTRY_VERIFY(diagram.isVisible());
        QVERIFY(diagram.hasFocus());
        state_.request(Request::fit_diagram);
        for (std::size_t ray = state_.tree()->tree.rays.size(); ray-- > 0;) {
            const int frames = window_->scene_pane().frames();
            QTest::mouseClick(&diagram, Qt::LeftButton, {}, diagram.place_of_ray(ray).toPoint());
            check_linked(ray);
            QTRY_VERIFY(ray == 0 || window_->scene_pane().frames() > frames);
        }
        run_command(state_, "tab.outline");
    }

    void the_diagram_follows_the_selection_and_keys() {
        run_command(state_, "tab.diagram");
        DiagramPane& diagram = window_->diagram_pane();
        for (std::size_t ray = 0; ray < state_.tree()->tree.rays.size(); ++ray) {
            state_.select(ray);
            QVERIFY(diagram.rect().contains(diagram.place_of_ray(ray).toPoint()));
        }
        state_.select(0);
        QTest::keyClick(&diagram, Qt::Key_Down);
        check_linked(1);
        QTest::keyClick(&diagram, Qt::Key_Right);
        check_linked(*sibling_of(*state_.tree(), 1, 1));
        QTest::keyClick(&diagram, Qt::Key_Up);
        check_linked(0);
        const double before = diagram.zoom();
        QTest::keyClick(&diagram, Qt::Key_Plus);
        QVERIFY(diagram.zoom() > before);
        run_command(state_, "tab.outline");
    }

    void the_outline_does_nothing_until_it_is_seen() {
        run_command(state_, "tab.counts");
        const auto* model = static_cast<const OutlineModel*>(window_->outline_pane().model());
        const QSignalSpy renewed(model, &QAbstractItemModel::modelReset);
        state_.pick({41, 31});
        QTRY_VERIFY(state_.tree());
        state_.select(1);
        QCOMPARE(renewed.count(), 0);
        run_command(state_, "copy.table");  // what is copied is of now
        QVERIFY(renewed.count() > 0);
        run_command(state_, "tab.outline");
        QCOMPARE(outline_ray(), std::size_t{1});
    }

    void a_key_goes_from_pane_to_pane_and_back() {
        QApplication::setActiveWindow(window_.get());
        window_->picture_pane().setFocus();
        std::vector<const QWidget*> way;
        for (int k = 0; k < 4; ++k) {
            way.push_back(QApplication::focusWidget());
            run_command(state_, "pane.next");
        }
        QCOMPARE(QApplication::focusWidget(), way.front());  // picture, 3D, tree, details
        QVERIFY(way[1] == canvas());
        QVERIFY(way[2] == &window_->outline_pane());
        QVERIFY(way[3] == &window_->details_pane());
        run_command(state_, "pane.previous");
        QCOMPARE(QApplication::focusWidget(), way[3]);
        state_.show_side(SidePane::change);  // of which a field gets the keys
        QTest::qWait(20);
        run_command(state_, "pane.next");
        QVERIFY(window_->side_dock().isAncestorOf(QApplication::focusWidget()));
        state_.show_side(SidePane::none);
    }

    void tabs_take_no_room_and_follow_the_state() {
        auto* const tabs = window_->findChild<QTabBar*>();
        QVERIFY(tabs);
        const QSize outline = window_->outline_pane().size();
        tabs->setCurrentIndex(2);
        QVERIFY(state_.tree_pane().tab == TreePane::Tab::counts);
        QTRY_VERIFY(window_->counts_pane().isVisible());
        QCOMPARE(window_->counts_pane().size(), outline);
        const QString text = window_->counts_pane().toPlainText();
        QVERIFY(
            text.contains(QString::number(static_cast<int>(state_.tree()->tree.counts.full_tree))));
        run_command(state_, "tab.outline");
        QCOMPARE(tabs->currentIndex(), 0);
        QVERIFY(window_->outline_pane().isVisible());
    }

    void a_broken_file_is_told_in_a_dialog_and_changes_nothing() {
        const auto before = state_.document();
        const QString missing = QStringLiteral("/no/such/scene.json");
        const QString told = told_when([&] { window_->open(missing); });
        QVERIFY2(told.contains(missing), qPrintable(told));
        QVERIFY(state_.document() == before);
    }

    void a_file_that_is_dropped_is_opened_or_told_to_be_broken() {
        const QTemporaryDir folder;
        QFile broken(folder.filePath(QStringLiteral("broken.json")));
        QVERIFY(broken.open(QIODevice::WriteOnly));
        broken.write("{\"format\": \"raytree-scene/1.0\", \"camera\"");
        broken.close();
        const auto before = state_.document();
        const QString told = told_when([&] { QVERIFY(drop({broken.fileName()})); });
        QVERIFY2(told.contains(broken.fileName()), qPrintable(told));
        QVERIFY(state_.document() == before);
        const QString several = told_when([&] {
            QVERIFY(drop({broken.fileName(), broken.fileName()}));
        });
        QVERIFY2(several.contains(QStringLiteral("2 files")), qPrintable(several));
        QVERIFY(state_.document() == before);
        QVERIFY(drop({QStringLiteral(RAYTREE_DATA_DIR "/scenes/prism.json")}));
        QTRY_VERIFY(state_.tree() && state_.document() != before);
        state_.show(test::opened(test::glass_ball_scene()));
        QTRY_VERIFY(state_.tree() && window_->feed().done());
    }

    void tab_reaches_every_pane_forwards_and_backwards() {
        QWidget* const panes[] = {&window_->picture_pane(), canvas(), &window_->details_pane(),
                                  &window_->outline_pane(), window_->findChild<QTabBar*>()};
        for (const Qt::Key key : {Qt::Key_Tab, Qt::Key_Backtab}) {
            window_->outline_pane().setFocus();
            std::set<QWidget*> reached;
            for (int k = 0; k < 300; ++k) {  // the details have a stop for each number
                QTest::keyClick(QApplication::focusWidget(), key);
                reached.insert(QApplication::focusWidget());
            }
            for (QWidget* const pane : panes) {
                QVERIFY2(reached.contains(pane), pane->metaObject()->className());
            }
        }
    }

    void the_cheat_sheet_lists_the_commands() {
        QTest::keyClick(canvas(), Qt::Key_F1);
        QTreeWidget* list = nullptr;
        for (auto* const one : window_->findChildren<QTreeWidget*>()) {
            list = one->window() != window_.get() ? one : list;
        }
        QVERIFY(list);
        QCOMPARE(static_cast<std::size_t>(list->topLevelItemCount()) > commands().size(), true);
        for (int k = 0; k < list->topLevelItemCount(); ++k) {
            QVERIFY(!list->topLevelItem(k)->text(3).isEmpty());  // each has its help
        }
        auto* const search = list->window()->findChild<QLineEdit*>();
        run_command(state_, "tab.outline");
        QTest::keyClicks(search, QStringLiteral("tab.counts"));
        QTest::keyClick(search, Qt::Key_Return);
        QCOMPARE(static_cast<int>(state_.tree_pane().tab), static_cast<int>(TreePane::Tab::counts));
        QVERIFY(!list->window()->isVisible());
        run_command(state_, "tab.outline");
    }

    void the_3d_view_shows_the_colours_of_its_rays() {
        QTest::qWait(100);
        const QImage image = view_image();
        const auto near = [&](QColor colour) {
            int count = 0;
            for (int y = 0; y < image.height(); ++y) {
                for (int x = 0; x < image.width(); ++x) {
                    const QColor at = image.pixelColor(x, y);
                    count += std::abs(at.red() - colour.red()) < 40 &&
                             std::abs(at.green() - colour.green()) < 40 &&
                             std::abs(at.blue() - colour.blue()) < 40;
                }
            }
            return count;
        };
        const Palette& palette = palette_of(Theme::light);
        for (const RayLook look : {RayLook::reflected, RayLook::refracted, RayLook::lit}) {
            const Ink ink = palette[look];
            QVERIFY2(near(QColor(ink.r, ink.g, ink.b)) > 150, text_of(look).name.data());
        }
    }
};

}  // namespace raytree::inspector

int main(int argc, char** argv) {
    return raytree::inspector::test::run_tests<raytree::inspector::WindowTest>(argc, argv);
}

#include "window_test.moc"
