// Lessons in the real window, by clicks and keys. Needs a display, such as Xvfb's.

#include <QApplication>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QSlider>
#include <QTemporaryDir>
#include <QTextBrowser>
#include <QtTest>

#include "app/sample_lessons.h"
#include "app/shown_window.h"
#include "state/commands.h"
#include "window/choice_button.h"
#include "window/lesson_pane.h"
#include "window/outline_pane.h"
#include "window/picture_pane.h"
#include "window/qt_text.h"
#include "window/scene_pane.h"

namespace raytree::inspector {

class LessonPaneTest : public test::ShownWindow {
    Q_OBJECT

  private:
    QTemporaryDir settings_;
    test::Lessons lessons_{"raytree-lesson-pane-test"};

    LessonPane& pane() const { return *window_->findChild<LessonPane*>(); }
    template <class Widget> Widget* shown(const QString& name = {}) const {
        for (Widget* const widget : pane().findChildren<Widget*>(name)) {
            if (widget->isVisible()) {
                return widget;
            }
        }
        return nullptr;
    }
    QPushButton* button(const QString& begin) const {
        for (QPushButton* const button : pane().findChildren<QPushButton*>()) {
            if (button->isVisible() && button->text().startsWith(begin)) {
                return button;
            }
        }
        return nullptr;
    }
    void click(const QString& begin) const {
        QPushButton* const found = button(begin);
        QVERIFY2(found, qPrintable(begin));
        QTest::mouseClick(found, Qt::LeftButton);
    }
    QString verdict() const {
        const auto* const label = shown<QLabel>(QStringLiteral("verdict"));
        return label ? label->text() : QString();
    }
    void go_to(const char* step) {
        run_command(state_, "lesson.open", "ball");
        run_command(state_, "lesson.step", step);
        QTest::qWait(30);
    }
    void click_pixel(Pixel pixel) const {
        PicturePane& picture = *window_->findChild<PicturePane*>();
        QTest::mouseClick(&picture, Qt::LeftButton, {}, picture.place_of(pixel).toPoint());
    }
    void check_wrong(const QString& hint) const {
        QVERIFY2(verdict().contains(QStringLiteral("Not quite")), qPrintable(verdict()));
        QVERIFY2(verdict().contains(hint), qPrintable(verdict()));
        QVERIFY2(verdict().contains(QStringLiteral("The answer:")), qPrintable(verdict()));
    }
    void check_right() const {
        QVERIFY2(verdict().contains(QStringLiteral("Right:")), qPrintable(verdict()));
        QVERIFY(state_.lesson()->is_solved(state_.lesson()->step()));
    }

  private Q_SLOTS:
    void initTestCase() {
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings_.path());
        QApplication::setOrganizationName(QStringLiteral("raytree-test"));
        show_window();
        state_.set_lesson_folder(lessons_.folder);
    }

    void init() { QApplication::setActiveWindow(window_.get()); }

    void the_list_opens_a_lesson() {
        run_command(state_, "lesson.list");
        auto* const list = shown<QTextBrowser>();
        QVERIFY(list);
        QVERIFY(list->toPlainText().contains(QStringLiteral("A ball")));
        Q_EMIT list->anchorClicked(QUrl(QStringLiteral("02-again")));
        QVERIFY(state_.lesson());
        QCOMPARE(state_.lesson()->lesson().name, std::string("02-again"));
        QVERIFY(shown<QLabel>(QStringLiteral("step")));
    }

    void a_step_is_seen_in_the_same_way_wherever_one_comes_from() {
        go_to("4");
        const double before = window_->scene_pane().view().fov_degrees;
        run_command(state_, "view.camera");
        QVERIFY(window_->scene_pane().view().fov_degrees != before);
        run_command(state_, "lesson.view");
        QCOMPARE(window_->scene_pane().view().fov_degrees, before);
    }

    void next_and_back_go_through_the_steps_and_on_to_the_next_lesson() {
        go_to("1");
        QVERIFY(shown<QLabel>(QStringLiteral("step"))->text().contains(QStringLiteral("How far")));
        click(QStringLiteral("Next"));
        QCOMPARE(state_.lesson()->step(), std::size_t{1});
        QVERIFY(shown<QLabel>(QStringLiteral("step"))->text().contains(QStringLiteral("Beside")));
        click(QStringLiteral("◂ Back"));
        QCOMPARE(state_.lesson()->step(), std::size_t{0});
        QTest::keyClick(window_.get(), Qt::Key_F8);
        QCOMPARE(state_.lesson()->step(), std::size_t{1});
        QTest::keyClick(window_.get(), Qt::Key_F7);
        QCOMPARE(state_.lesson()->step(), std::size_t{0});
        run_command(state_, "lesson.last");
        click(QStringLiteral("Next lesson"));
        QCOMPARE(state_.lesson()->lesson().name, std::string("02-again"));
        QCOMPARE(state_.lesson()->step(), std::size_t{0});
        click(QStringLiteral("◂ Back"));
        QCOMPARE(state_.lesson()->lesson().name, std::string("01-ball"));
        QCOMPARE(state_.lesson()->step(), std::size_t{6});
    }

    void a_number_is_typed() {
        go_to("1");
        auto* const field = shown<QLineEdit>();
        QVERIFY(field);
        QVERIFY(!button(QStringLiteral("Answer"))->isEnabled());
        QTest::keyClicks(field, QStringLiteral("five"));
        QVERIFY(!button(QStringLiteral("Answer"))->isEnabled());
        field->clear();
        QTest::keyClicks(field, QStringLiteral("5"));
        click(QStringLiteral("Answer"));
        check_wrong(QStringLiteral("That is the middle."));
        QVERIFY(verdict().contains(QStringLiteral("Well.")));
        field->clear();
        QTest::keyClicks(field, QStringLiteral("4,005"));  // as half of Europe types it
        QTest::keyClick(field, Qt::Key_Return);
        check_right();
        click(QStringLiteral("Ask me again"));
        QVERIFY(verdict().isEmpty());
        click(QStringLiteral("Show me"));
        QVERIFY(verdict().contains(QStringLiteral("The answer: <b>4</b>")));
        QVERIFY(!state_.lesson()->is_solved(0));
    }

    void an_answered_number_stands_in_its_field_when_one_comes_back() {
        go_to("1");
        QTest::keyClicks(shown<QLineEdit>(), QStringLiteral("4,25"));
        QTest::keyClick(shown<QLineEdit>(), Qt::Key_Return);
        QVERIFY(state_.lesson()->answer());
        click(QStringLiteral("Next"));
        click(QStringLiteral("◂ Back"));
        QTRY_VERIFY(shown<QLineEdit>());
        QCOMPARE(shown<QLineEdit>()->text(), QStringLiteral("4.25"));
        QVERIFY(!verdict().isEmpty());
    }

    void a_question_takes_the_colours_of_the_theme_and_keeps_what_is_typed() {
        run_command(state_, "lesson.again");
        shown<QLineEdit>()->setText(QStringLiteral("12"));
        const auto heading = [this] {
            for (const QLabel* const label : pane().findChildren<QLabel*>()) {
                if (label->isVisible() && label->text().contains(QStringLiteral("Your turn"))) {
                    return label->text();
                }
            }
            return QString();
        };
        for (const Theme theme : {Theme::dark, Theme::light}) {
            run_command(state_, "look.dark");
            QTRY_VERIFY(shown<QLineEdit>());
            QVERIFY2(heading().contains(qt(palette_of(theme).accent).name()),
                     qPrintable(heading()));
            QCOMPARE(shown<QLineEdit>()->text(), QStringLiteral("12"));
        }
        shown<QLineEdit>()->clear();
    }

    void asked_again_a_number_is_typed_anew() {
        go_to("1");
        auto* const field = shown<QLineEdit>();
        QVERIFY(field);
        QTest::keyClicks(field, QStringLiteral("5"));
        QTest::keyClick(field, Qt::Key_Return);
        click(QStringLiteral("Ask me again"));
        QVERIFY(!state_.lesson()->answer());
        QCOMPARE(field->text(), QString());
        QTest::keyClicks(field, QStringLiteral("4"));
        QTest::keyClick(field, Qt::Key_Return);
        check_right();
    }

    void a_pixel_is_clicked_in_the_picture() {
        go_to("2");
        QVERIFY(!button(QStringLiteral("Answer")));  // what is shown is not offered as the answer
        click_pixel({4, 3});
        check_wrong(QStringLiteral("That is the ball."));
        click_pixel({0, 4});
        check_right();
        click(QStringLiteral("Lesson's view"));
        QCOMPARE(state_.pixel(), (Pixel{4, 4}));
        QVERIFY(state_.lesson()->answer()->right);  // to go back is no answer
        click_pixel({4, 4});                        // but to click the pixel that is shown is one
        check_wrong(QStringLiteral("That is the ball."));
        click(QStringLiteral("Ask me again"));
        click(QStringLiteral("Show me"));
        QCOMPARE(state_.pixel(), (Pixel{0, 4}));
        QVERIFY(verdict().contains(QStringLiteral("The answer:")));
    }

    void a_ray_is_picked_in_the_tree() {
        go_to("3");
        OutlinePane& outline = window_->outline_pane();
        const auto click_row = [&](const QModelIndex& index) {
            QTest::mouseClick(outline.viewport(), Qt::LeftButton, {},
                              outline.visualRect(index).center());
        };
        QVERIFY(!button(QStringLiteral("Answer")));
        click_row(outline.currentIndex());  // the shadow ray, which is selected already
        check_wrong(QStringLiteral("That one goes to the lamp."));
        click_row(outline.model()->index(0, 0));
        check_right();
        click(QStringLiteral("Ask me again"));
        run_command(state_, "lesson.view");
        QCOMPARE(state_.selected()->kind, RayKind::shadow);
        click(QStringLiteral("Show me"));
        QCOMPARE(state_.selected()->kind, RayKind::primary);
    }

    void a_value_is_set_by_slider_field_or_command_and_the_scene_follows() {
        go_to("4");
        auto* const slider = shown<QSlider>();
        auto* const field = shown<QDoubleSpinBox>();
        QVERIFY(slider && field);
        QCOMPARE(field->value(), 1.0);
        const auto distance = [&] { return state_.selected()->hit->t; };
        slider->setValue(slider->maximum());
        QCOMPARE(field->value(), 3.0);
        QTRY_COMPARE(distance(), 2.0);
        QCOMPARE(field->value(), 3.0);  // the scene followed, the slider stays
        slider->setValue(slider->maximum() / 2);
        QTRY_COMPARE(distance(), 3.25);
        QCOMPARE(field->value(), 1.75);
        QCOMPARE(slider->value(), slider->maximum() / 2);
        QVERIFY(!state_.lesson()->answer());  // to try is not to answer
        field->setValue(0.8);
        click(QStringLiteral("Answer"));
        check_wrong(QStringLiteral("That is smaller."));
        QCOMPARE(distance(), 4.2);
        run_command(state_, "lesson.answer", "2");
        check_right();
        QCOMPARE(distance(), 3.0);
        QTRY_COMPARE(field->value(), 2.0);
        QCOMPARE(slider->value(), qRound((2 - 0.5) / 2.5 * slider->maximum()));
        click(QStringLiteral("Lesson's view"));
        QCOMPARE(distance(), 4.0);
        QTRY_COMPARE(field->value(), 1.0);
        click(QStringLiteral("Ask me again"));
        click(QStringLiteral("Show me"));
        QCOMPARE(distance(), 3.0);
        QTRY_COMPARE(field->value(), 2.0);
    }

    void a_choice_is_clicked() {
        go_to("5");
        const auto options = pane().findChildren<ChoiceButton*>();
        QCOMPARE(options.size(), 2);
        QTest::mouseClick(options[0], Qt::LeftButton);
        check_wrong(QStringLiteral("The wall is gone."));
        QTest::mouseClick(options[1], Qt::LeftButton);
        check_right();
    }

    /// The question of the step before is not asked about the new step's scene.
    void after_a_value_comes_a_step_that_asks_nothing() {
        go_to("6");
        QVERIFY(shown<QSlider>());
        click(QStringLiteral("Next"));
        QCOMPARE(QString::fromStdString(state_.message()), QString());
        QCOMPARE(state_.lesson()->step(), std::size_t{6});
        QCOMPARE(state_.look().shapes, ShapeStyle::wire);
        QVERIFY(state_.pixel() == (Pixel{0, 4}));
        QVERIFY(!shown<QSlider>());
    }

    void the_verdict_is_scrolled_into_view() {
        window_->resize(1280, 480);  // where the question hardly has room
        go_to("5");
        QTest::mouseClick(pane().findChildren<ChoiceButton*>()[0], Qt::LeftButton);
        auto* const scroll = shown<QScrollArea>();
        const auto seen = [&] {
            const auto* const label = shown<QLabel>(QStringLiteral("verdict"));
            const QPoint end = label->mapTo(scroll->viewport(), label->rect().bottomLeft());
            return label->height() > 0 && end.y() < scroll->viewport()->height();
        };
        QTRY_VERIFY(seen());
        window_->resize(1280, 800);
    }

    void cleanupTestCase() { window_.reset(); }
};

}  // namespace raytree::inspector

int main(int argc, char** argv) {
    return raytree::inspector::test::run_tests<raytree::inspector::LessonPaneTest>(argc, argv);
}

#include "lesson_pane_test.moc"
