#include "window/run.h"

#include <QVTKOpenGLNativeWidget.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QSurfaceFormat>

#include "formats/output_file.h"
#include "state/commands.h"
#include "window/exporter.h"
#include "window/main_window.h"
#include "window/scene_pane.h"

namespace raytree::inspector {
namespace {

constexpr qint64 longest_wait = 120'000;  // milliseconds for a picture

/// Lets the window work until its picture is complete and its 3D view has shown it.
void wait_until_drawn(const State& state, MainWindow& window) {
    QElapsedTimer time;
    time.start();
    while ((!window.feed().done() || state.tracing()) && time.elapsed() < longest_wait) {
        QApplication::processEvents(QEventLoop::WaitForMoreEvents, 50);
    }
    const int frames = window.scene_pane().frames();
    window.scene_pane().draw_again();
    for (int k = 0; k < 200 && window.scene_pane().frames() == frames; ++k) {
        QApplication::processEvents(QEventLoop::AllEvents, 10);
    }
    QApplication::processEvents();
}

void take_screenshot(const State& state, MainWindow& window, const std::filesystem::path& file) {
    wait_until_drawn(state, window);
    write_output(file.string(), png_of(window));
}

}  // namespace

void prepare_qt() {
    qputenv("QT_QPA_PLATFORM", "xcb");  // on other platforms of Qt the 3D view stays empty
    QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
    format.setSamples(0);
    QSurfaceFormat::setDefaultFormat(format);
}

int run_window(int& argc, char** argv, State& state, const WindowOptions& options) {
    prepare_qt();
    // A screenshot has the size asked for on every display.
    QApplication::setAttribute(options.screenshot ? Qt::AA_DisableHighDpiScaling
                                                  : Qt::AA_EnableHighDpiScaling);
    QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
    QApplication application(argc, argv);
    QApplication::setApplicationName(QStringLiteral("raytree-inspector"));

    // The panes are told of what is open by its being shown once more.
    const Opened opened{state.document(), state.pixel(), {state.message()}};
    MainWindow window(state);
    window.resize(options.width, options.height);
    window.show();
    if (opened.document) {
        state.show(opened);
        state.show_lesson_view();
    }
    QApplication::processEvents();  // the panes take their sizes
    for (const std::string& line : options.script) {
        run_line(state, line);
    }
    if (options.screenshot) {
        take_screenshot(state, window, *options.screenshot);
        return 0;
    }
    return QApplication::exec();
}

}  // namespace raytree::inspector
