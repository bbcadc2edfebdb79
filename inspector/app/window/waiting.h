#pragma once

#include <QApplication>
#include <QElapsedTimer>
#include <QProgressDialog>
#include <atomic>
#include <chrono>
#include <future>
#include <thread>

namespace raytree::inspector {

/// Does work in threads of its own while the window goes on; a dialog says so once it takes longer
/// than a glance, and cancels it. A cancelled thread ends by itself; its answer is dropped.
class Waiting {
  public:
    /// How many cancelled threads have not yet ended. They must not outlive `main`, and nobody
    /// waits for them: where there are any, the program is left at once.
    static std::atomic<int>& abandoned() {
        static std::atomic<int> count{0};
        return count;
    }

    /// None where it was cancelled. Throws what the work throws.
    template <class Work> auto wait(QWidget* parent, const QString& title, Work work)
        -> std::optional<decltype(work())> {
        using namespace std::chrono_literals;
        std::packaged_task<decltype(work())()> task(std::move(work));
        auto answer = task.get_future();
        std::thread thread(std::move(task));
        if (answer.wait_for(60ms) != std::future_status::ready && !show(answer, parent, title)) {
            ++abandoned();
            std::thread(
                [](std::thread cancelled) {
                    cancelled.join();
                    --abandoned();
                },
                std::move(thread))
                .detach();
            return std::nullopt;
        }
        thread.join();
        return answer.get();
    }

  private:
    template <class Answer>
    static bool show(const Answer& answer, QWidget* parent, const QString& title) {
        using namespace std::chrono_literals;
        QProgressDialog dialog(title, QStringLiteral("Cancel"), 0, 0, parent);
        dialog.setWindowModality(Qt::WindowModal);
        dialog.setMinimumDuration(0);
        dialog.show();
        QElapsedTimer time;
        time.start();
        while (answer.wait_for(15ms) != std::future_status::ready) {
            dialog.setLabelText(title + QStringLiteral("  %1 s").arg(time.elapsed() / 1000));
            QApplication::processEvents();
            if (dialog.wasCanceled()) {
                return false;
            }
        }
        return true;
    }
};

}  // namespace raytree::inspector
