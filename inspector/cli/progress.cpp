#include "progress.h"

#include <unistd.h>

#include <cstdio>

namespace raytree::cli {
namespace {

constexpr auto patience = std::chrono::milliseconds(500);
constexpr auto between = std::chrono::milliseconds(100);
constexpr int columns = 40;

}  // namespace

Progress::Progress(std::string task)
    : task_(std::move(task)),
      terminal_(isatty(STDERR_FILENO) == 1),
      next_(Clock::now() + patience) {}

Progress::~Progress() {
    if (drawn_) {
        std::fputs("\r\x1b[K", stderr);
    }
}

std::function<bool(double)> Progress::callback() {
    if (!terminal_) {
        return {};
    }
    return [this](double share) {
        // A thread that finds another one drawing has better things to do than to wait for it.
        const std::unique_lock lock(mutex_, std::try_to_lock);
        if (lock && Clock::now() >= next_) {
            draw(share);
            next_ = Clock::now() + between;
        }
        return true;
    };
}

void Progress::draw(double share) {
    const int filled = static_cast<int>(share * columns);
    std::string bar(static_cast<std::size_t>(filled), '#');
    bar.resize(columns, '.');
    std::fprintf(stderr, "\r%s [%s] %3d %%", task_.c_str(), bar.c_str(),
                 static_cast<int>(share * 100));
    drawn_ = true;
}

}  // namespace raytree::cli
