#include "window/run.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QSettings>
#include <QTimer>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <utility>

#include "formats/output_file.h"
#include "state/commands.h"
#include "window/contact_sheet.h"
#include "window/exporter.h"
#include "window/files.h"
#include "window/main_window.h"
#include "window/remembered_table.h"
#include "window/scene_pane.h"

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

/// What a script does next may be about the tree that it has just asked for.
void wait_for_tree(State& state) {
    QElapsedTimer time;
    time.start();
    while (state.working() && time.elapsed() < longest_wait) {
        state.poll(std::chrono::milliseconds(50));
    }
}

/// Throws InputError with the line's place. There is nobody to answer questions.
void run_script(State& state, MainWindow& window, const WindowOptions& options) {
    window.set_asking(false);
    for (std::size_t k = 0; k < options.script.size(); ++k) {
        const std::string& line = options.script[k];
        if (line.starts_with("export.")) {  // a picture of the window is one of all of it
            wait_until_drawn(state, window);
        }
        const std::string place = "line " + std::to_string(k + 1);
        try {
            if (!run_line(state, line)) {
                std::cerr << "raytree-inspector: " << options.script_file << ": " << place << ": "
                          << line << " cannot be done just then; it was left out\n";
            }
        } catch (const InputError& error) {
            throw InputError(options.script_file, place, error.what());
        }
        wait_for_tree(state);
    }
    window.set_asking(true);
}

void take_screenshot(const State& state, MainWindow& window, const std::filesystem::path& file) {
    wait_until_drawn(state, window);
    write_output(file.string(), png_of(window));
}

}  // namespace

FirstReading begin_reading(std::function<FirstView()> read) {
    auto progress = std::make_shared<WorkProgress>();
    auto view = std::async(std::launch::async, [progress, read = std::move(read)] {
        const std::shared_ptr<void> end(nullptr, [&](void*) { progress->end(); });
        const ProgressListener listener = progress->listener();
        return read();
    });
    return {std::move(view), std::move(progress)};
}

bool wait_until_read(State& state, const QWidget& window, FirstReading& reading) {
    using namespace std::chrono_literals;
    std::string said;
    while (reading.view.wait_for(10ms) != std::future_status::ready) {
        std::string text = "Reading what is to be shown…";
        if (const auto [doing, share] = reading.progress->stage(); !doing.empty()) {
            text += "  " + doing + ", " + std::to_string(std::lround(100 * share)) + " %";
        }
        if (said != text) {
            state.say(said = std::move(text));
        }
        QApplication::processEvents();
        if (!window.isVisible() || state.document()) {
            reading.progress->cancel();
            return window.isVisible();
        }
    }
    state.say({});
    reading.view.get()(state);
    return true;
}

void prepare_qt() {
    qputenv("QT_QPA_PLATFORM", "xcb");  // the 3D view is drawn by X as well
}

int run_window(int& argc, char** argv, State& state, FirstReading reading,
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

    const bool is_read =
        reading.view.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    if (is_read) {
        reading.view.get()(state);
    }
    MainWindow window(state);
    window.resize(options.width, options.height);
    window.show();
    if (!is_read && !wait_until_read(state, window, reading)) {
        return 0;
    }
    // The panes are told of what is open by its being shown once more.
    state.show_again();
    state.show_lesson_view();
    if (!options.screenshot && !options.contact_sheet) {
        window.files().remember();
    }
    QApplication::processEvents();  // the panes take their sizes
    run_script(state, window, options);
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
