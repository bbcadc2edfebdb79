// The picture in the real window: what is told of the pixel under the cursor, zooming by keys, and
// what is written and drawn over the pixels.

#include <QApplication>
#include <cmath>

#include "app/scenes.h"
#include "app/shown_window.h"
#include "state/commands.h"
#include "tree/eight_bit.h"
#include "window/fitting_label.h"
#include "window/picture_pane.h"

namespace raytree::inspector {

class PicturePaneTest : public test::ShownWindow {
    Q_OBJECT

    PicturePane& picture() { return window_->picture_pane(); }

    void move_cursor_to(QPointF at) {
        QMouseEvent move(QEvent::MouseMove, at, Qt::NoButton, Qt::NoButton, {});
        QApplication::sendEvent(&picture(), &move);
    }
    /// What is told below the picture.
    QString told() {
        const QWidget* const box = picture().parentWidget();
        return box->findChild<FittingLabel*>(QStringLiteral("aside"))->text();
    }
    double scale() { return picture().place_of({41, 30}).x() - picture().place_of({40, 30}).x(); }
    QRectF square_of(Pixel pixel) {
        const QPointF middle = picture().place_of(pixel);
        return {middle - QPointF(scale(), scale()) / 2, QSizeF(scale(), scale())};
    }
    QImage image() { return picture().grab().toImage(); }
    /// How many of an image's pixels within a rectangle differ.
    static int different(const QImage& a, const QImage& b, QRectF within) {
        int count = 0;
        for (int y = 0; y < a.height(); ++y) {
            for (int x = 0; x < a.width(); ++x) {
                count += within.contains(x, y) && a.pixel(x, y) != b.pixel(x, y);
            }
        }
        return count;
    }

  private Q_SLOTS:
    void initTestCase() {
        show_window();
        state_.show(test::opened(test::glass_ball_scene()));
        QTRY_VERIFY(window_->feed().done());
    }

    void init() {
        QApplication::setActiveWindow(window_.get());  // where no window manager does
        state_.pick({40, 30});
        state_.request(Request::fit_picture);
        picture().setFocus();
    }

    void the_pixel_that_is_told_is_the_one_under_the_cursor_whatever_moves() {
        const QPointF at = picture().place_of({12, 30});
        move_cursor_to(at);
        QVERIFY2(told().startsWith(QStringLiteral("12,30 ")), qPrintable(told()));
        run_command(state_, "pixel.values");  // the picture moves, not the cursor
        const QPointF off = (at - picture().place_of({40, 30})) / scale();
        const Pixel there{static_cast<int>(std::floor(40.5 + off.x())),
                          static_cast<int>(std::floor(30.5 + off.y()))};
        QVERIFY2(told().startsWith(QString::fromStdString(text_of(there) + " ")),
                 qPrintable(told()));
        run_command(state_, "pixel.fit_picture");
        QVERIFY2(told().startsWith(QStringLiteral("12,30 ")), qPrintable(told()));
        const QSize size = window_->size();
        window_->resize(size + QSize(300, 200));
        QTRY_VERIFY((picture().place_of({12, 30}) - at).manhattanLength() > 4);
        QVERIFY2(!told().startsWith(QStringLiteral("12,30 ")), qPrintable(told()));
        window_->resize(size);
        QTRY_VERIFY((picture().place_of({12, 30}) - at).manhattanLength() < 1);
        QApplication::sendEvent(&picture(), std::make_unique<QEvent>(QEvent::Leave).get());
        QVERIFY2(!told().startsWith(QStringLiteral("12,30")), qPrintable(told()));
    }

    void the_value_that_is_told_is_the_one_that_is_shown() {
        move_cursor_to(picture().place_of({40, 30}));
        const QString before = told();
        run_command(state_, "change.set", "/settings/max_depth 1");
        QTRY_VERIFY(window_->feed().done());
        QVERIFY(told() != before);
        run_command(state_, "change.undo");
        QTRY_VERIFY(window_->feed().done());
        QCOMPARE(told(), before);
        run_command(state_, "overlay.levels");
        QTRY_VERIFY(window_->feed().overlay());
        QTRY_VERIFY(!told().contains(QStringLiteral("→")));
        run_command(state_, "overlay.none");
        QTRY_VERIFY(told().contains(QStringLiteral("→")));
    }

    void keys_zoom_and_show_the_values() {
        const double whole = scale();
        QTest::keyClick(&picture(), Qt::Key_Equal, Qt::ControlModifier);
        QCOMPARE(scale(), 2 * whole);
        QTest::keyClick(&picture(), Qt::Key_Minus, Qt::ControlModifier);
        QCOMPARE(scale(), whole);
        const QImage before = image();
        QTest::keyClick(&picture(), Qt::Key_9);
        const QRectF square = square_of({40, 30});
        QVERIFY(picture().rect().contains(square.toAlignedRect()));
        QVERIFY(square.width() >= 100);
        const EightBit value = eight_bit(*window_->feed().intensity({40, 30}), Quantize::round);
        const QRgb colour = qRgb(value.value[0], value.value[1], value.value[2]);
        const QImage large = image();
        int written = 0;
        for (int y = static_cast<int>(square.top()) + 4; y < square.bottom() - 4; ++y) {
            for (int x = static_cast<int>(square.left()) + 4; x < square.right() - 4; ++x) {
                written += (large.pixel(x, y) & 0xFFFFFFU) != (colour & 0xFFFFFFU);
            }
        }
        QVERIFY2(written > 200, qPrintable(QString::number(written)));  // its raw and 8-bit values
        QTest::keyClick(&picture(), Qt::Key_0);
        QCOMPARE(scale(), whole);
        QCOMPARE(different(image(), before, picture().rect()), 0);
    }

    void the_chosen_square_is_whole_in_the_pane() {
        run_command(state_, "pixel.values");
        for (const auto& [command, times] : {std::pair{"pixel.right", 9},
                                             {"pixel.down", 9},
                                             {"pixel.left", 18},
                                             {"pixel.up", 18}}) {
            for (int k = 0; k < times; ++k) {
                run_command(state_, command);
                const QRectF square = square_of(state_.pixel());
                QVERIFY(QRectF(picture().rect()).adjusted(-0.1, -0.1, 0.1, 0.1).contains(square));
            }
        }
    }

    void clamped_values_are_marked() {
        // A channel of one pixel is over 1 with the light twice as bright.
        run_command(state_, "pixel.values");
        const QImage plain = image();
        const QRectF square = square_of({40, 30});
        const auto raw = window_->feed().intensity({40, 30});
        QVERIFY(raw && raw->r < 1 && raw->g < 1 && raw->b < 1);
        run_command(state_, "change.set", "/lights/0/intensity [40, 40, 40]");
        QTRY_VERIFY(window_->feed().done());
        const auto bright = window_->feed().intensity({40, 30});
        QVERIFY(bright->r > 1 || bright->g > 1 || bright->b > 1);
        QVERIFY(different(image(), plain, square) > 0);
        move_cursor_to(square.center());
        QVERIFY2(told().contains(QStringLiteral("clamped)")), qPrintable(told()));
        run_command(state_, "change.undo");
        QTRY_VERIFY(window_->feed().done());
    }

    void pixels_whose_trees_are_shown_are_framed() {
        run_command(state_, "pixel.values");
        run_command(state_, "pixel.further");
        run_command(state_, "pixel.further");
        const QImage plain = image();
        const auto changed = [&](const char* command, QRectF within) {
            run_command(state_, command);
            const int count = different(image(), plain, within);
            run_command(state_, command);
            return count;
        };
        const QRectF left = square_of({39, 30}), above = square_of({40, 29});
        const auto edge = [](QRectF square, double dx, double dy) {  // a strip beyond its far side
            return square.translated(square.width() * dx, square.height() * dy);
        };
        // A square's frame runs beyond the pixels around; a row's beyond the fourth to the left.
        QVERIFY(changed("neighbours.square", edge(left, -1, 0)) > 10);
        QVERIFY(changed("neighbours.square", edge(above, 0, -1)) > 10);
        QCOMPARE(changed("neighbours.row", edge(above, 0, -1)), 0);
        QCOMPARE(changed("neighbours.column", edge(left, -1, 0)), 0);
        QVERIFY(changed("neighbours.row", above) > 10);
        QVERIFY(changed("neighbours.column", left) > 10);
        QCOMPARE(different(image(), plain, picture().rect()), 0);
    }
};

}  // namespace raytree::inspector

int main(int argc, char** argv) {
    return raytree::inspector::test::run_tests<raytree::inspector::PicturePaneTest>(argc, argv);
}

#include "picture_pane_test.moc"
