#include "window/contact_sheet.h"

#include <QBuffer>
#include <QPainter>

#include "formats/output_file.h"
#include "lesson/lesson_folder.h"
#include "window/qt_text.h"

namespace raytree::inspector {
namespace {

constexpr int columns = 6, thumb_width = 400, caption = 24, gap = 10;

struct Thumb {
    QImage image;
    QString words;
};

std::string png_of(const QImage& image) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes.toStdString();
}

/// Rows of thumbnails; each lesson begins a row.
QImage sheet_of(const std::vector<std::vector<Thumb>>& lessons, const Palette& palette) {
    int rows = 0;
    for (const auto& thumbs : lessons) {
        rows += (static_cast<int>(thumbs.size()) + columns - 1) / columns;
    }
    const int height = lessons.front().front().image.height() + caption + gap;
    QImage sheet(columns * (thumb_width + gap) + gap, rows * height + gap, QImage::Format_RGB32);
    sheet.fill(qt(palette.window));
    QPainter painter(&sheet);
    painter.setPen(qt(palette.text));
    int row = 0;
    for (const auto& thumbs : lessons) {
        for (std::size_t k = 0; k < thumbs.size(); ++k) {
            const int column = static_cast<int>(k) % columns;
            const QPoint at(gap + column * (thumb_width + gap),
                            gap + (row + static_cast<int>(k) / columns) * height);
            painter.drawText(QRect(at, QSize(thumb_width, caption)), Qt::AlignVCenter,
                             thumbs[k].words);
            painter.drawImage(at + QPoint(0, caption), thumbs[k].image);
        }
        row += (static_cast<int>(thumbs.size()) + columns - 1) / columns;
    }
    return sheet;
}

}  // namespace

void write_contact_sheet(State& state, const std::filesystem::path& folder,
                         const std::function<std::string()>& draw) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    const auto& own = state.lesson_folder();
    const std::filesystem::path place = own.empty() ? lesson::own_lessons() : own;
    std::vector<std::vector<Thumb>> lessons;
    for (const std::string& name : lesson::lesson_names(place)) {
        state.open_lesson(lesson::load_lesson(place, name));
        lessons.emplace_back();
        for (std::size_t k = 0; k < state.lesson()->count(); ++k) {
            state.go_to_lesson_step(k);
            const std::string png = draw();
            const std::string file = name + "-" + (k < 9 ? "0" : "") + std::to_string(k + 1);
            write_output((folder / (file + ".png")).string(), png);
            const QImage image = QImage::fromData(QByteArray::fromStdString(png));
            lessons.back().push_back(
                {image.scaledToWidth(thumb_width, Qt::SmoothTransformation), qt(file)});
        }
    }
    write_output((folder / "index.png").string(),
                 png_of(sheet_of(lessons, palette_of(state.look().theme))));
}

}  // namespace raytree::inspector
