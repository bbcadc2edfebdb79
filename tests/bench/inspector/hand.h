#pragma once

#include <QApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string>
#include <utility>
#include <vector>

#include "scene/input_error.h"
#include "window/main_window.h"
#include "window/run.h"
#include "window/scene_pane.h"

/// What the benchmarks of the inspector measure by. Times are of the clock and, in brackets, of the
/// processor: on a machine with other work to do, only the latter say something about the program.
namespace raytree::inspector::bench {

/// An application of one window, of the size that the tables are about unless it is told another.
class ShownWindow {
    bool prepared_ = (prepare_qt(), true);
    QApplication application_;

  public:
    ShownWindow(int& argc, char** argv, int width = 1280, int height = 800)
        : application_(argc, argv) {
        window.resize(width, height);
        window.show();
    }

    State state;
    MainWindow window{state};
};

struct Time {
    double clock = 0, process = 0;  ///< milliseconds; of the process on all of its threads
};

class Stopwatch {
  public:
    Stopwatch() : process_(std::clock()) { timer_.start(); }
    Time read() const {
        return {static_cast<double>(timer_.nsecsElapsed()) / 1e6,
                1e3 * static_cast<double>(std::clock() - process_) / CLOCKS_PER_SEC};
    }

  private:
    QElapsedTimer timer_;
    std::clock_t process_;
};

/// Until the change that `act` makes has been drawn.
template <class Act> Time time_of(const State& state, ScenePane& pane, Act act) {
    QEventLoop loop;
    const int frames = pane.frames();
    QObject::connect(&pane, &ScenePane::drawn, &loop, [&] {
        if (pane.frames() > frames && pane.is_current() && !state.working()) {
            loop.quit();
        }
    });
    const Stopwatch watch;
    act();
    loop.exec();
    return watch.read();
}

inline std::pair<double, double> median_and_worst(std::vector<Time> times, double Time::*which) {
    std::ranges::sort(times, {}, which);
    return {times[times.size() / 2].*which, times.back().*which};
}

inline void print_heading(const char* what) {
    std::printf("%-34s %19s %19s\n", what, "median", "worst");
}

inline void print(const std::string& what, const std::vector<Time>& times) {
    const auto [median, worst] = median_and_worst(times, &Time::clock);
    const auto [median_process, worst_process] = median_and_worst(times, &Time::process);
    std::printf("%-34s %8.2f (%8.2f) %8.2f (%8.2f)\n", what.c_str(), median, median_process, worst,
                worst_process);
    std::fflush(stdout);
}

/// How long the window answers nothing: the longest time between two beats of a timer in its
/// thread. The processor's time is that of the window's thread alone.
class Heartbeat {
  public:
    Heartbeat() {
        timer_.setInterval(2);
        QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { beat(); });
        timer_.start();
        begin();
    }
    void begin() {
        last_.start();
        thread_ = thread_time();
        longest_ = {};
    }
    /// Since `begin`.
    Time longest() {
        beat();
        return longest_;
    }

  private:
    static double thread_time() {
        timespec now{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
        return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
    }
    void beat() {
        const double now = thread_time();
        longest_.clock = std::max(longest_.clock, static_cast<double>(last_.nsecsElapsed()) / 1e6);
        longest_.process = std::max(longest_.process, now - thread_);
        last_.start();
        thread_ = now;
    }

    QTimer timer_;
    QElapsedTimer last_;
    double thread_ = 0;
    Time longest_;
};

/// Lets the window answer, and rest where there is nothing to answer, as its users see it.
template <class Condition> void process_while(Condition condition) {
    QTimer look_again;
    look_again.start(5);
    while (condition()) {
        QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
}

inline void process_for(int milliseconds) {
    QElapsedTimer time;
    time.start();
    process_while([&] { return time.elapsed() < milliseconds; });
}

inline void wait_for_picture(const State& state, const MainWindow& window) {
    process_while([&] { return state.working() || !window.feed().done(); });
    QApplication::processEvents();
}

/// What a program returns: 2 after an argument that it can do nothing with, of which it says why.
template <class Run> int exit_code_of(Run run) {
    try {
        run();
        return 0;
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}

}  // namespace raytree::inspector::bench
