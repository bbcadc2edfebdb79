#include "window/waiting.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QProgressDialog>
#include <QTimer>

#include "window/qt_text.h"

namespace raytree::inspector {

ProgressListener WorkProgress::listener() {
    return ProgressListener([this](std::string_view doing, double share) {
        if (cancelled_) {
            throw Stopped();
        }
        const std::lock_guard lock(mutex_);
        stage_ = {std::string(doing), share};
    });
}

WorkProgress::Stage WorkProgress::stage() const {
    const std::lock_guard lock(mutex_);
    return stage_;
}

bool Waiting::comes_soon(const IsThere& is_there) {
    using namespace std::chrono_literals;
    constexpr qint64 glance = 60;  // milliseconds
    QElapsedTimer time;
    time.start();
    QTimer look_again;
    look_again.start(2);
    bool there = is_there(0ms);
    while (!there && time.elapsed() < glance) {
        QApplication::processEvents(QEventLoop::ExcludeUserInputEvents |
                                    QEventLoop::WaitForMoreEvents);
        there = is_there(0ms);
    }
    return there;
}

bool Waiting::show_until(const IsThere& is_there, const WorkProgress& progress, QWidget* parent,
                         const QString& title) {
    using namespace std::chrono_literals;
    QProgressDialog dialog(title, QStringLiteral("Cancel"), 0, 0, parent);
    dialog.setWindowModality(Qt::WindowModal);
    dialog.setMinimumDuration(0);
    dialog.setAutoReset(false);
    dialog.setMinimumWidth(dialog.fontMetrics().averageCharWidth() * 60);
    dialog.show();
    QElapsedTimer time;
    time.start();
    while (!is_there(15ms)) {
        const WorkProgress::Stage stage = progress.stage();
        QString text = title;
        if (!stage.doing.empty()) {
            dialog.setMaximum(100);
            dialog.setValue(static_cast<int>(100 * stage.share));
            if (!title.contains(qt(stage.doing), Qt::CaseInsensitive)) {  // the bar has the share
                text += QStringLiteral("  ") + qt(stage.doing);
            }
        }
        dialog.setLabelText(text + QStringLiteral("  (%1 s)").arg(time.elapsed() / 1000));
        QApplication::processEvents();
        if (dialog.wasCanceled()) {
            return false;
        }
    }
    return true;
}

void Waiting::finish(QWidget* parent, const QString& title, const std::function<void()>& work) {
    using namespace std::chrono_literals;
    auto done = std::async(std::launch::async, work);
    const IsThere is_there = [&](std::chrono::milliseconds patience) {
        return done.wait_for(patience) == std::future_status::ready;
    };
    if (!comes_soon(is_there)) {
        QProgressDialog dialog(title, {}, 0, 0, parent);
        dialog.setCancelButton(nullptr);
        dialog.setWindowModality(Qt::ApplicationModal);
        dialog.setMinimumDuration(0);
        dialog.setMinimumWidth(dialog.fontMetrics().averageCharWidth() * 50);
        while (!is_there(15ms)) {
            dialog.show();  // again, where Escape has closed it
            QApplication::processEvents();
        }
    }
    done.get();
}

}  // namespace raytree::inspector
