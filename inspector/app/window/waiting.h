#pragma once

#include <QApplication>
#include <QElapsedTimer>
#include <QProgressDialog>
#include <chrono>
#include <future>
#include <memory>
#include <thread>
#include <vector>

namespace raytree::inspector {

/// Does work in threads of its own while the window goes on; a dialog says so once it takes longer
/// than a glance, and cancels it. A cancelled thread ends by itself; its answer is dropped.
class Waiting {
  public:
    ~Waiting() {
        for (std::thread& thread : abandoned_) {
            thread.join();
        }
    }

    /// None where it was cancelled. Throws what the work throws.
    template <class Work> auto wait(QWidget* parent, const QString& title, Work work)
        -> std::optional<decltype(work())> {
        using namespace std::chrono_literals;
        std::packaged_task<decltype(work())()> task(std::move(work));
        auto answer = task.get_future();
        std::thread thread(std::move(task));
        if (answer.wait_for(60ms) != std::future_status::ready && !show(answer, parent, title)) {
            abandoned_.push_back(std::move(thread));
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

    std::vector<std::thread> abandoned_;
};

}  // namespace raytree::inspector
