#include "window/run.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QSettings>
#include <QTimer>
#include <cstdlib>

#include "formats/output_file.h"
#include "state/commands.h"
#include "window/contact_sheet.h"
#include "window/exporter.h"
#include "window/files.h"
#include "window/main_window.h"
#include "window/remembered_table.h"
#include "window/scene_pane.h"
#include "window/work_progress.h"

namespace raytree::inspector {
namespace {

constexpr qint64 longest_wait = 120'000;  // milliseconds for a picture

/// Lets the window work until its picture is complete and its 3D view has shown it.
void wait_until_drawn(const State& state, MainWindow& window) {
    QElapsedTimer time;
    time.start();
    const auto is_coming = [&] {
        return !window.feed().done() || state.working() || !window.scene_pane().has_shapes();
    };
    QTimer look_again;
    look_again.start(20);
    window.scene_pane().draw_again();
    while (is_coming() && time.elapsed() < longest_wait) {
        QApplication::processEvents(QEventLoop::WaitForMoreEvents);  // rests, unlike with a time
    }
    QApplication::processEvents();
}

/// What takes long to read is waited for by a window that answers. Where it has been closed by
/// then, nobody wants it any longer.
void wait_until_read(State& state, const MainWindow& window, std::future<FirstView>& reading) {
    using namespace std::chrono_literals;
    state.say("Reading what is to be shown…");
    while (reading.wait_for(10ms) != std::future_status::ready) {
        QApplication::processEvents();
        if (!window.isVisible()) {
            std::_Exit(0);
        }
    }
    state.say({});
    reading.get()(state);
}

/// What a script does next may be about the tree that it has just asked for.
void wait_for_tree(State& state) {
    QElapsedTimer time;
    time.start();
    while (state.working() && time.elapsed() < longest_wait) {
        state.poll(std::chrono::milliseconds(50));
    }
}

void take_screenshot(const State& state, MainWindow& window, const std::filesystem::path& file) {
    wait_until_drawn(state, window);
    write_output(file.string(), png_of(window));
}

}  // namespace

void prepare_qt() {
    qputenv("QT_QPA_PLATFORM", "xcb");  // the 3D view is drawn by X as well
}

int run_window(int& argc, char** argv, State& state, std::future<FirstView> reading,
               const WindowOptions& options) {
    prepare_qt();
    // A screenshot has the size asked for on every display.
    QApplication::setAttribute(options.screenshot || options.contact_sheet
                                   ? Qt::AA_DisableHighDpiScaling
                                   : Qt::AA_EnableHighDpiScaling);
    QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
    QApplication application(argc, argv);
    QApplication::setOrganizationName(QStringLiteral("raytree"));
    QApplication::setApplicationName(QStringLiteral("raytree-inspector"));

    const bool is_read = reading.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    if (is_read) {
        reading.get()(state);
    }
    MainWindow window(state);
    window.resize(options.width, options.height);
    window.show();
    if (!is_read) {
        wait_until_read(state, window, reading);
    }
    // The panes are told of what is open by its being shown once more.
    state.show_again();
    state.show_lesson_view();
    if (!options.screenshot && !options.contact_sheet) {
        window.files().remember();
    }
    QApplication::processEvents();  // the panes take their sizes
    for (const std::string& line : options.script) {
        run_line(state, line);
        wait_for_tree(state);
    }
    if (!window.isVisible()) {  // the script has closed it
        return 0;
    }
    if (!options.screenshot && options.script.empty()) {
        remember_table(state);
    }
    if (options.contact_sheet) {
        write_contact_sheet(state, *options.contact_sheet, [&] {
            wait_until_drawn(state, window);
            return png_of(window);
        });
        return 0;
    }
    if (options.screenshot) {
        take_screenshot(state, window, *options.screenshot);
        return 0;
    }
    const int code = QApplication::exec();
    // Nobody waits for what is still being worked out, which may take long.
    if (WorkProgress::running() > 0 || state.working() || !window.feed().done()) {
        QSettings().sync();
        std::_Exit(code);
    }
    return code;
}

}  // namespace raytree::inspector
