#pragma once

#include <QImage>
#include <QWidget>
#include <optional>

#include "window/picture_feed.h"

namespace raytree::inspector {

/// The picture: a click or a drag chooses a pixel, the wheel zooms, the other buttons move it.
class PicturePane : public QWidget {
    Q_OBJECT

  public:
    PicturePane(State& state, PictureFeed& feed, QWidget* parent = nullptr);

    /// Where the middle of a pixel is in the pane.
    QPointF place_of(Pixel pixel) const;
    QSize sizeHint() const override { return {400, 330}; }

  Q_SIGNALS:
    /// The pixel under the cursor; none when it has left the picture. Told again whenever it, or
    /// what is known of it, may have become another, whatever the cause.
    void hovered(std::optional<raytree::inspector::Pixel> pixel);

  protected:
    void paintEvent(QPaintEvent*) override;
    void resizeEvent(QResizeEvent*) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent*) override;
    void wheelEvent(QWheelEvent* event) override;

  private:
    void obey(Request request);
    void take_picture();
    void draw_again();
    void fit();
    void keep_in_place();
    void zoom(double factor, QPointF about);
    void zoom_onto_chosen(double factor);
    void show_values();
    void show_chosen();
    std::optional<Pixel> pixel_at(QPointF place) const;
    QRectF rect_of(Pixel pixel) const;
    QSizeF picture_size() const;
    void draw_image(QPainter& painter) const;
    QString value_in(Pixel pixel, bool* bright) const;
    void draw_grid(QPainter& painter) const;
    void draw_values(QPainter& painter) const;
    void draw_neighbours(QPainter& painter) const;
    void draw_cross(QPainter& painter) const;
    void draw_compared(QPainter& painter) const;

    State& state_;
    PictureFeed& feed_;
    QImage image_;
    double scale_ = 1;    ///< of the pane's pixels to one of the picture's
    QPointF origin_;      ///< of the picture in the pane
    bool fitted_ = true;  ///< as long as nobody has zoomed
    std::optional<QPointF> cursor_;
    QPointF grabbed_;
    bool moving_ = false;
};

}  // namespace raytree::inspector
