#pragma once

#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "state/state.h"
#include "window/work_progress.h"

class QWidget;

namespace raytree::inspector {

struct WindowOptions {
    std::optional<std::filesystem::path> screenshot;     ///< drawn once, written, and ended
    std::optional<std::filesystem::path> contact_sheet;  ///< folder for all steps of all lessons
    std::vector<std::string> script;  ///< commands that are run once the window is there
    std::string script_file;          ///< that they stand in, a line each
    int width = 1280;
    int height = 800;
};

/// To be called before there is a QApplication: VTK draws through X11 alone, with OpenGL of a
/// version of its own.
void prepare_qt();

/// Shows in a state what has been read.
using FirstView = std::function<void(State&)>;

/// What is shown first, being read in a thread of its own.
struct FirstReading {
    std::future<FirstView> view;
    std::shared_ptr<WorkProgress> progress;  ///< cancelled, the reading soon ends with Stopped
};
FirstReading begin_reading(std::function<FirstView()> read);

/// Lets a window answer until its first view has been read, saying how far that is, and shows it.
/// Where somebody opens something else or closes the window meanwhile, it is read no further. False
/// where the window has been closed. Throws what the reading throws.
bool wait_until_read(State& state, const QWidget& window, FirstReading& reading);

/// Shows the state in a window until it is closed, what is shown first as soon as it has been read.
/// There must be a display. Returns the exit code; throws InputError where reading, a line of the
/// script or the screenshot fails.
int run_window(int& argc, char** argv, State& state, FirstReading reading,
               const WindowOptions& options);

}  // namespace raytree::inspector
