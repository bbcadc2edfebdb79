#pragma once

#include <QString>
#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <thread>

#include "window/work_progress.h"

class QWidget;

namespace raytree::inspector {

/// Does work in threads of its own while the window goes on; a dialog says so once it takes longer
/// than a glance, with how far it is, and cancels it. A cancelled thread ends by itself, soon where
/// its work tells its progress; its answer is dropped.
class Waiting {
  public:
    /// None where it was cancelled. Throws what the work throws.
    template <class Work> auto wait(QWidget* parent, const QString& title, Work work)
        -> std::optional<decltype(work())> {
        const auto progress = std::make_shared<WorkProgress>();
        std::packaged_task<decltype(work())()> task([progress, work = std::move(work)] {
            const ProgressListener listener = progress->listener();
            return work();
        });
        auto answer = task.get_future();
        std::thread([progress, task = std::move(task)]() mutable {
            task();
            progress->end();
        }).detach();
        const IsThere is_there = [&](std::chrono::milliseconds patience) {
            return answer.wait_for(patience) == std::future_status::ready;
        };
        if (!comes_soon(is_there) && !show_until(is_there, *progress, parent, title)) {
            progress->cancel();
            return std::nullopt;
        }
        return answer.get();
    }

    /// The same of what cannot be cancelled, and returns when it is done. Throws what it throws.
    static void finish(QWidget* parent, const QString& title, const std::function<void()>& work);

  private:
    /// Whether the answer is there, waiting for it no longer than that.
    using IsThere = std::function<bool(std::chrono::milliseconds)>;
    /// Whether it comes within a glance. Meanwhile all is drawn as before; clicks and keys come
    /// later, in their order.
    static bool comes_soon(const IsThere& is_there);
    /// Whether it came and was not cancelled.
    static bool show_until(const IsThere& is_there, const WorkProgress& progress, QWidget* parent,
                           const QString& title);
};

}  // namespace raytree::inspector
