#include "window/scene_canvas.h"

#include <QPainter>
#include <utility>

#include "window/qt_text.h"

namespace raytree::inspector {

QImage image_of(const FrameImage& frame, double ratio) {
    // The image holds the pixels.
    auto* const held = new std::shared_ptr<std::uint32_t[]>(frame.pixels);
    QImage image(
        reinterpret_cast<uchar*>(frame.pixels.get()), frame.width, frame.height,
        QImage::Format_RGB32,
        [](void* pixels) { delete static_cast<std::shared_ptr<std::uint32_t[]>*>(pixels); }, held);
    image.setDevicePixelRatio(ratio);
    return image;
}

SceneCanvas::SceneCanvas(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_OpaquePaintEvent);
}

void SceneCanvas::show_frame(const QImage& frame) {
    frame_ = frame;
    is_new_ = true;
    update();
}

void SceneCanvas::set_palette_of(Theme theme) {
    theme_ = theme;
    update();
}

void SceneCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (frame_.isNull()) {
        const Palette& palette = palette_of(theme_);
        QLinearGradient space(rect().topLeft(), rect().bottomLeft());
        space.setColorAt(0, qt(palette.space_top));
        space.setColorAt(1, qt(palette.space_bottom));
        painter.fillRect(rect(), space);
    } else if (frame_.size() == size() * frame_.devicePixelRatio()) {
        painter.drawImage(0, 0, frame_);
    } else {
        painter.drawImage(rect(), frame_);  // of another size, until the next one comes
    }
    if (std::exchange(is_new_, false)) {
        // Once it has been painted, all goes to the screen.
        QMetaObject::invokeMethod(this, &SceneCanvas::drawn, Qt::QueuedConnection);
    }
}

}  // namespace raytree::inspector
