#pragma once

#include <QApplication>
#include <QTest>
#include <memory>

#include "window/main_window.h"
#include "window/run.h"
#include "window/scene_pane.h"

namespace raytree::inspector::test {

/// What the tests of the window have in common: a state, and a window that shows it.
class ShownWindow : public QObject {
  protected:
    State state_;
    std::unique_ptr<MainWindow> window_;

    /// What receives the 3D view's clicks and keys.
    QWidget* canvas() const { return window_->scene_pane().focusProxy(); }
    /// The 3D view as it is now.
    QImage view_image() const {
        window_->scene_pane().catch_up();
        return window_->scene_pane().grab().toImage();
    }

    void show_window() {
        window_ = std::make_unique<MainWindow>(state_);
        window_->resize(1280, 800);
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    }
};

/// The main function of such tests.
template <class Tests> int run_tests(int argc, char** argv) {
    prepare_qt();
    QApplication application(argc, argv);
    Tests tests;
    return QTest::qExec(&tests, argc, argv);
}

}  // namespace raytree::inspector::test
