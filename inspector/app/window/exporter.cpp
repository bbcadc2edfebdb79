#include "window/exporter.h"

#include <QApplication>
#include <QBuffer>
#include <QClipboard>
#include <QFileDialog>
#include <QProgressDialog>
#include <QThread>
#include <atomic>
#include <filesystem>
#include <future>

#include "formats/output_file.h"
#include "state/exports.h"
#include "window/ask_size.h"
#include "window/qt_text.h"
#include "window/scene_pane.h"

namespace raytree::inspector {
namespace {

/// Shows how far the work is until it is done; false where it was cancelled.
template <class Work>
bool wait_for(const std::future<Work>& work, const std::atomic<int>& percent, QWidget* parent) {
    using namespace std::chrono_literals;
    if (work.wait_for(80ms) == std::future_status::ready) {
        return true;
    }
    QProgressDialog dialog(QStringLiteral("Rendering the picture…"), QStringLiteral("Cancel"), 0,
                           100, parent);
    dialog.setWindowModality(Qt::WindowModal);
    dialog.setMinimumDuration(0);
    dialog.setAutoReset(false);
    while (work.wait_for(20ms) != std::future_status::ready) {
        dialog.setValue(percent);  // lets the window work as well
        QApplication::processEvents();
        if (dialog.wasCanceled()) {
            return false;
        }
    }
    return true;
}

}  // namespace

Exporter::Exporter(State& state, QWidget* window, ScenePane* view)
    : QObject(window), state_(state), window_(window), view_(view) {
    state_.observe([this](const Changes& changes) { obey(changes); });
}

void Exporter::obey(const Changes& changes) {
    if (changes.request == Request::export_picture) {
        write_picture(changes.text);
    } else if (changes.request == Request::export_window) {
        write_image(view_->grabbed(*window_).toImage(), changes.text);
    } else if (changes.request == Request::export_view) {
        write_view(changes.text);
    } else if (changes.request == Request::copy_text) {
        QApplication::clipboard()->setText(qt(changes.text));
    } else if (changes.request == Request::copy_window) {
        QApplication::clipboard()->setPixmap(view_->grabbed(*window_));
        state_.say("The window has been copied.");
    } else if (changes.request == Request::copy_view) {
        QApplication::clipboard()->setPixmap(view_->grabbed(*view_));
        state_.say("The 3D view has been copied.");
    }
}

/// Rendered anew, as the command line does: what the pane shows may be thinned out or not yet
/// complete.
void Exporter::write_picture(const std::string& file) {
    expect_picture(state_, file);
    std::atomic<int> percent = 0;
    std::atomic<bool> cancelled = false;
    const RenderOptions options{std::max(1, QThread::idealThreadCount() - 1), [&](double share) {
                                    percent = static_cast<int>(99 * share);
                                    return !cancelled;
                                }};
    const auto document = state_.document();
    auto work = std::async(std::launch::async, [&] { return render(document->world(), options); });
    cancelled = !wait_for(work, percent, window_);
    const Picture picture = work.get();
    if (cancelled) {
        state_.say("Cancelled: " + file + " has not been written.");
    } else {
        export_picture(state_, picture, file);
    }
}

void Exporter::write_view(const std::string& file_and_size) {
    const ViewExport wish = view_export_from(file_and_size);
    const QSize size = wish.size ? QSize(wish.size->first, wish.size->second) : view_->size();
    write_image(view_->image(size), wish.file);
}

void Exporter::write_image(const QImage& image, const std::string& file) {
    state_.do_beside("Writing " + std::filesystem::path(file).filename().string(),
                     [&] { write_output(file, png_of(image)); });
    state_.say("Written: " + file);
}

std::string png_of(QWidget& widget) { return png_of(widget.grab().toImage()); }

std::string png_of(const QImage& image) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.convertToFormat(QImage::Format_RGB888).save(&buffer, "PNG");
    return bytes.toStdString();
}

std::string ask_new_file(const State& state, const Command& command, QWidget* parent) {
    QStringList suffixes = qt(command.suffixes).split(QLatin1Char(' '));
    QFileDialog dialog(parent, qt(command.title),
                       qt(state.document()->file().parent_path().string()));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(suffixes.front());
    dialog.setNameFilter(QStringLiteral("*.") + suffixes.join(QStringLiteral(" *.")));
    dialog.selectFile(qt(suggested_name(state, command)));
    if (dialog.exec() != QDialog::Accepted) {
        return {};
    }
    const std::string file = dialog.selectedFiles().front().toStdString();
    if (command.id != "export.view") {
        return file;
    }
    const std::string size = ask_size(parent);
    return size.empty() ? size : file + " " + size;
}

}  // namespace raytree::inspector
