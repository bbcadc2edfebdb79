#pragma once

#include <QWidget>

#include "window/picture_feed.h"

namespace raytree::inspector {

/// What the overlay's colours mean: a scale or the kinds, with the chosen pixel's value marked.
/// Hidden where the picture itself is shown.
class OverlayLegend : public QWidget {
    Q_OBJECT

  public:
    OverlayLegend(State& state, PictureFeed& feed, QWidget* parent = nullptr);

    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent*) override;
    void resizeEvent(QResizeEvent*) override;

  private:
    void renew();
    int line() const;
    /// As many as their words leave room for.
    int kind_columns(const Overlay& overlay) const;
    void draw_scale(QPainter& painter, const Overlay& overlay) const;
    void draw_kinds(QPainter& painter, const Overlay& overlay) const;

    State& state_;
    PictureFeed& feed_;
};

}  // namespace raytree::inspector
