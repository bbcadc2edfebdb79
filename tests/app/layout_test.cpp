// Nothing is cut in the real window, at sizes and with fonts that people have. Needs a display.

#include <QApplication>
#include <QDialog>
#include <QHeaderView>
#include <QLabel>
#include <QMenuBar>
#include <QScrollBar>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTextBlock>
#include <QTextLayout>
#include <QTextTable>
#include <QToolBar>
#include <QToolButton>
#include <QTreeWidget>
#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "app/cut_words.h"
#include "app/scenes.h"
#include "app/shown_window.h"
#include "formats/tree_json.h"
#include "lesson/lesson_folder.h"
#include "state/commands.h"
#include "state/start_pixel.h"
#include "window/details_pane.h"
#include "window/explained_pane.h"
#include "window/fitting_tabs.h"
#include "window/outline_pane.h"
#include "window/side_dock.h"
#include "window/steps_pane.h"

namespace raytree::inspector {

class LayoutTest : public test::ShownWindow {
    Q_OBJECT

    const OutlinePane& outline() const { return window_->outline_pane(); }

    /// Rows that are open, from the top.
    std::vector<QModelIndex> open_rows() const {
        std::vector<QModelIndex> rows;
        for (QModelIndex at = outline().model()->index(0, 0); at.isValid();
             at = outline().indexBelow(at)) {
            rows.push_back(at);
        }
        return rows;
    }

    /// Every text of a column has its room.
    void check_column(Column column) {
        for (const QModelIndex& row : open_rows()) {
            const QModelIndex cell = row.siblingAtColumn(static_cast<int>(column));
            const int wanted = outline().sizeHintForIndex(cell).width();
            const int indented = column == Column::ray ? outline().visualRect(cell).x() : 0;
            const int room = outline().columnWidth(static_cast<int>(column)) - indented;
            QVERIFY2(wanted <= room, qPrintable(QStringLiteral("%1: %2 in %3")
                                                    .arg(cell.data().toString())
                                                    .arg(wanted)
                                                    .arg(room)));
        }
    }

    bool has_usual_font() const { return outline().fontMetrics().averageCharWidth() < 9; }

    void check_outline() {
        if (has_usual_font()) {  // with a larger one it may have to scroll
            QCOMPARE(outline().horizontalScrollBar()->maximum(), 0);
        }
        for (const Column column : {Column::ray, Column::t, Column::intensity, Column::ended}) {
            check_column(column);
        }
    }

    void check_words(const char* where) {
        QStringList cut;  // what has come last may still be laid out
        QTest::qWait(50);
        const bool whole = QTest::qWaitFor(
            [&] {
                cut = test::cut_words(*window_);
                return cut.isEmpty();
            },
            3000);
        QVERIFY2(whole, qPrintable(QLatin1String(where) + QStringLiteral("\n") +
                                   cut.join(QLatin1Char('\n'))));
    }

    /// Of before and after a change that cuts rays away: each difference is written out.
    void check_comparison() {
        run_command(state_, "change.set", "/settings/max_depth 2");
        QTRY_VERIFY(state_.tree() && !state_.working());
        run_command(state_, "compare.before");
        QTRY_VERIFY(state_.tree() && state_.tree()->contrast);
        check_words("a comparison");
        run_command(state_, "compare.end");
        run_command(state_, "change.reset");
    }

    /// Each difference is as high as its words are, laid out line by line, in a narrow list too.
    void check_differences() {
        const auto lists = window_->findChildren<QTreeWidget*>();
        const auto list = std::find_if(lists.begin(), lists.end(), [](const QTreeWidget* one) {
            return one->accessibleName() == QStringLiteral("Differences");
        });
        QVERIFY(list != lists.end());
        QVERIFY((*list)->topLevelItemCount() > 3);
        (*list)->setMaximumWidth(150);
        QTest::qWait(50);
        for (int k = 0; k < (*list)->topLevelItemCount(); ++k) {
            const QTreeWidgetItem* const item = (*list)->topLevelItem(k);
            QFont font = (*list)->font();
            font.setBold(item->font(1).bold());
            QTextLayout words(item->text(1), font);
            words.beginLayout();
            qreal height = 0;
            for (QTextLine line = words.createLine(); line.isValid(); line = words.createLine()) {
                line.setLineWidth((*list)->columnWidth(1) - 6);  // less a cell's margins
                height += line.height();
            }
            words.endLayout();
            QVERIFY2((*list)->visualItemRect(item).height() >= height, qPrintable(item->text(1)));
        }
        (*list)->setMaximumWidth(QWIDGETSIZE_MAX);
    }

  private Q_SLOTS:
    void initTestCase() {
        show_window();
        state_.show(test::opened(test::glass_ball_scene()));
        state_.pick({40, 30});
        QTRY_VERIFY(state_.tree());
    }

    void init() {
        run_command(state_, "tab.outline");
        state_.show_side(SidePane::none);
    }

    void the_outline_has_room_for_its_words_in_two_columns_and_in_three() {
        check_outline();
        QCOMPARE(outline().model()->index(0, 3).data().toString().contains(QStringLiteral("  ")),
                 has_usual_font());  // three decimals are written out where there is room
        for (const SidePane pane : {SidePane::change, SidePane::compare, SidePane::steps}) {
            state_.show_side(pane);
            QTest::qWait(50);
            check_outline();
        }
        run_command(state_, "light.next");
        check_outline();
        run_command(state_, "thing.none");
    }

    void marks_of_a_comparison_have_room() {
        run_command(state_, "compare.this_pixel");
        state_.pick({60, 20});
        QTRY_VERIFY(state_.tree() && state_.tree()->contrast);
        state_.show_side(SidePane::compare);
        QTest::qWait(50);
        check_outline();
        check_differences();
        run_command(state_, "compare.end");
        state_.pick({40, 30});
        QTRY_VERIFY(state_.tree());
    }

    void three_columns_fit_into_a_narrow_window() {
        state_.show_side(SidePane::change);
        QTest::qWait(50);
        if (has_usual_font()) {
            QVERIFY2(window_->minimumSizeHint().width() <= 1000,
                     qPrintable(QString::number(window_->minimumSizeHint().width())));
        }
        const QSize before = window_->size();
        window_->resize(window_->minimumSizeHint());
        QTest::qWait(50);
        for (const SidePane pane : {SidePane::change, SidePane::none}) {
            state_.show_side(pane);
            QTest::qWait(50);
            const DetailsPane& details = window_->details_pane();
            for (QTextBlock block = details.document()->begin(); block.isValid();
                 block = block.next()) {  // numbers stay in one piece
                if (block.text().startsWith(QStringLiteral("0."))) {
                    QCOMPARE(block.layout()->lineCount(), 1);
                }
            }
        }
        window_->resize(before);
    }

    void why_a_ray_was_not_sent_stands_beside_it() {
        bool found = false;
        for (const QModelIndex& row : open_rows()) {
            const QString met =
                row.siblingAtColumn(static_cast<int>(Column::met)).data().toString();
            found = found || met.startsWith(QStringLiteral("not sent: "));
        }
        QVERIFY(found);
    }

    void what_a_call_waits_for_is_not_cut() {
        run_command(state_, "step.mode");
        for (int k = 0; k < 8; ++k) {
            run_command(state_, "step.forward");
        }
        const QTreeWidget* const calls = window_->side_dock().steps().calls();
        QTest::qWait(50);
        QVERIFY(calls->topLevelItemCount() > 1);
        for (int k = 0; k < calls->topLevelItemCount(); ++k) {
            const QString text = calls->topLevelItem(k)->data(0, Qt::AccessibleTextRole).toString();
            const QString waits = text.mid(text.indexOf(QStringLiteral("waits for")));
            QVERIFY2(!waits.isEmpty(), qPrintable(text));
            QVERIFY2(
                calls->fontMetrics().horizontalAdvance(waits) + 10 <= calls->viewport()->width(),
                qPrintable(waits));
        }
        run_command(state_, "step.mode");
    }

    void a_swatch_stands_beside_its_word_and_a_word_before_its_number() {
        state_.show_side(SidePane::change);
        QTest::qWait(50);
        int swatches = 0, words = 0;
        const QTextDocument& document = *window_->details_pane().document();
        for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
            if (block.text().contains(QChar::ObjectReplacementCharacter)) {
                ++swatches;
                QCOMPARE(block.layout()->lineCount(), 1);
            }
            QTextCursor cursor(block);
            if (const QTextTable* const table = cursor.currentTable()) {
                const QTextTableCell cell = table->cellAt(cursor);
                if (cell.column() == 0 && !block.text().trimmed().isEmpty()) {
                    ++words;
                    QVERIFY(cell.format().toTableCellFormat().rightPadding() >= 4);
                }
            }
        }
        QVERIFY(swatches > 0);
        QVERIFY(words > 5);
    }

    void no_word_is_cut_in_any_pane_data() {
        QTest::addColumn<QString>("scene");
        QTest::addColumn<bool>("dark");
        QTest::addColumn<QSize>("size");
        for (const char* const scene : {"glass-ball", "hall-of-mirrors", "cut-open"}) {
            for (const bool dark : {false, true}) {
                for (const QSize size : {QSize(1280, 800), QSize(1920, 1040)}) {
                    QTest::addRow("%s, %s, %d", scene, dark ? "dark" : "light", size.width())
                        << QString::fromLatin1(scene) << dark << size;
                }
            }
        }
    }

    void no_word_is_cut_in_any_pane() {
        if (!has_usual_font()) {
            QSKIP("with a larger font panes may scroll");
        }
        QFETCH(QString, scene);
        QFETCH(bool, dark);
        QFETCH(QSize, size);
        const std::string file = RAYTREE_SCENES + scene.toStdString() + ".json";
        Opened opened = open_file(file);
        opened.pixel = start_pixel(*opened.document);
        state_.show(opened);
        QTRY_VERIFY(state_.tree());
        state_.change_look([&](Look& look) { look.theme = dark ? Theme::dark : Theme::light; });
        window_->resize(size);
        for (const char* const tab :
             {"tab.diagram", "tab.counts", "tab.filter", "tab.explained", "tab.outline"}) {
            run_command(state_, tab);
            check_words(tab);
        }
        for (const SidePane pane : {SidePane::change, SidePane::compare, SidePane::steps}) {
            state_.show_side(pane);
            check_words("a pane at the side");
        }
        check_comparison();
    }

    void the_status_and_the_tabs_fit_into_a_narrow_window_data() {
        QTest::addColumn<int>("width");
        QTest::addRow("1280") << 1280;
        QTest::addRow("900") << 900;
    }

    /// With large fonts, too, and a pane at the side.
    void the_status_and_the_tabs_fit_into_a_narrow_window() {
        QFETCH(int, width);
        if (!has_usual_font() && width < 1280) {
            QSKIP("a window of this font is wider");
        }
        window_->resize(width, 800);
        state_.show_side(SidePane::change);
        state_.pick({40, 30});
        QTRY_VERIFY(state_.tree());
        QTest::qWait(50);
        for (const QLabel* const label : window_->statusBar()->findChildren<QLabel*>()) {
            QVERIFY2(label->sizeHint().isValid() && !label->text().contains(QStringLiteral("…")),
                     qPrintable(label->text()));
            QVERIFY(label->fontMetrics().horizontalAdvance(label->text()) <=
                    label->contentsRect().width());
        }
        const auto* const tabs = window_->findChild<FittingTabs*>();
        QVERIFY(tabs);
        QCOMPARE(tabs->count(), 5);
        for (int k = 0; k < tabs->count(); ++k) {
            QVERIFY2(tabs->tabRect(k).right() <= tabs->width(), qPrintable(tabs->tabText(k)));
            QVERIFY2(
                tabs->fontMetrics().horizontalAdvance(tabs->tabText(k)) <= tabs->tabRect(k).width(),
                qPrintable(tabs->tabText(k)));
        }
        const QString words = tabs->tabText(0) + tabs->tabToolTip(0);
        QVERIFY2(words.endsWith(QStringLiteral("Ray tree")), qPrintable(words));
        window_->resize(1280, 800);
    }

    /// All numbers of a recorded tree beside the true one, in three columns.
    void no_number_of_a_comparison_needs_scrolling() {
        if (!has_usual_font()) {
            QSKIP("with a larger font panes may scroll");
        }
        state_.show(open_file(RAYTREE_SCENES "glass-ball.json"));
        state_.pick({208, 296});
        QTRY_VERIFY(state_.tree());
        RayTree<double> theirs = state_.tree()->tree;
        for (TreeRay<double>& ray : theirs.rays) {
            ray.intensity = (1 + 4e-5) * ray.intensity;
            if (ray.hit) {
                ray.hit->point.x += 1e-4;
                ray.hit->t *= 100;
            }
        }
        const QTemporaryDir folder;
        const std::string file = folder.filePath(QStringLiteral("tree.json")).toStdString();
        std::ofstream(file, std::ios::binary)
            << write_tree_json(theirs, &state_.document()->scene());
        run_command(state_, "file.open", file);
        QTRY_VERIFY(state_.tree() && state_.tree()->recorded);
        state_.show_side(SidePane::compare);
        const DetailsPane& details = window_->details_pane();
        for (const char* const whose : {"as recorded", "raytree's own"}) {
            for (std::size_t ray = 0; ray < state_.tree()->tree.rays.size(); ++ray) {
                state_.select(ray);
                QTest::qWait(1);
                QVERIFY2(details.horizontalScrollBar()->maximum() == 0,
                         qPrintable(details.toPlainText()));
            }
            run_command(state_, "compare.swap");
            QTRY_VERIFY2(state_.tree(), whose);
        }
        run_command(state_, "compare.end");
    }

    /// What each command does is written out.
    void no_line_of_the_cheat_sheet_is_cut() {
        window_->resize(1280, 800);
        run_command(state_, "help.keys");
        const auto* const dialog = window_->findChild<QDialog*>();
        QVERIFY(dialog);
        QTest::qWait(100);
        const QStringList cut = test::cut_words(*dialog);
        QVERIFY2(cut.isEmpty(), qPrintable(cut.join(QLatin1Char('\n'))));
        delete dialog;
    }

    /// What stands beside the steps stays beside the one that is looked at.
    void what_a_step_refers_to_stays_beside_it() {
        if (!has_usual_font()) {
            QSKIP("with a larger font it stands above the steps");
        }
        state_.show(open_file(RAYTREE_SCENES "mesh.json"));
        QTRY_VERIFY(state_.tree());
        window_->resize(1280, 800);
        run_command(state_, "explain.boxes");
        QTRY_VERIFY(!state_.working());
        for (int k = 0; k < 30; ++k) {
            run_command(state_, "explain.step_forward");
        }
        auto* const pane = window_->findChild<ExplainedPane*>();
        QVERIFY(pane && pane->isVisible());
        QTest::qWait(50);
        QTRY_VERIFY(pane->verticalScrollBar()->value() > 0);
        const auto seen = [&](const char* words) {
            const QTextCursor found = pane->document()->find(QString::fromUtf8(words));
            return !found.isNull() && pane->viewport()->rect().contains(pane->cursorRect(found));
        };
        QVERIFY(seen("Tests for the selected ray"));
        pane->verticalScrollBar()->setValue(0);
        QVERIFY(seen("Tests for the selected ray"));
        QVERIFY(seen("Through the"));
        pane->verticalScrollBar()->setValue(pane->verticalScrollBar()->maximum());
        QVERIFY(seen("production"));
        run_command(state_, "explain.nothing");
    }

    void no_word_of_a_lesson_is_cut() {
        if (!has_usual_font()) {
            QSKIP("with a larger font panes may scroll");
        }
        window_->resize(1280, 800);
        state_.set_lesson_folder(RAYTREE_LESSONS);
        for (const std::string& name : lesson::lesson_names(RAYTREE_LESSONS)) {
            run_command(state_, "lesson.open", name);
            run_command(state_, "lesson.last");
            check_words(name.c_str());
        }
        run_command(state_, "lesson.close");
    }

    /// With any font: beside a lesson and a pane there is little room.
    void no_tab_is_cut_between_three_columns() {
        window_->resize(1280, 800);
        state_.set_lesson_folder(RAYTREE_LESSONS);
        run_command(state_, "lesson.open", lesson::lesson_names(RAYTREE_LESSONS).front());
        state_.show_side(SidePane::change);
        QTRY_VERIFY(state_.tree());
        QTest::qWait(50);
        const auto* const tabs = window_->findChild<FittingTabs*>();
        QVERIFY(tabs->sizeHint().width() <= tabs->width());
        for (int k = 0; k < tabs->count(); ++k) {
            QVERIFY(!tabs->tabText(k).isEmpty() || !tabs->tabIcon(k).isNull());
            QVERIFY(!tabs->tabText(k).isEmpty() || !tabs->tabToolTip(k).isEmpty());
        }
        state_.show_side(SidePane::none);
        run_command(state_, "lesson.close");
    }

    /// The button at the end of a menu bar that has no room for all of its menus.
    void the_arrows_to_further_menus_are_seen_in_both_themes() {
        const auto* button =
            window_->menuBar()->findChild<QToolButton*>(QStringLiteral("qt_menubar_ext_button"));
        QVERIFY(button);
        for (int theme = 0; theme < 2; ++theme) {
            run_command(state_, "look.dark");
            const QImage arrows = button->icon().pixmap(32).toImage();
            const int behind = window_->palette().color(QPalette::Window).lightness();
            int contrast = 0;
            for (int y = 0; y < arrows.height(); ++y) {
                for (int x = 0; x < arrows.width(); ++x) {
                    const QColor ink = arrows.pixelColor(x, y);
                    if (ink.alpha() == 255) {
                        contrast = std::max(contrast, std::abs(ink.lightness() - behind));
                    }
                }
            }
            QVERIFY2(contrast > 100, qPrintable(QString::number(contrast)));
        }
    }

    void panes_stay_where_they_are_when_the_theme_changes() {
        State state;
        MainWindow window(state);
        window.resize(1280, 800);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        state.show(test::opened(test::glass_ball_scene()));
        QTRY_VERIFY(state.tree());
        const int before = window.findChild<QToolBar*>()->height();
        run_command(state, "look.dark");
        QTest::qWait(50);
        QCOMPARE(window.findChild<QToolBar*>()->height(), before);
        run_command(state, "look.dark");
    }

    void cleanupTestCase() { window_.reset(); }
};

}  // namespace raytree::inspector

int main(int argc, char** argv) {
    return raytree::inspector::test::run_tests<raytree::inspector::LayoutTest>(argc, argv);
}

#include "layout_test.moc"
