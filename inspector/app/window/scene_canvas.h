#pragma once

#include <QImage>
#include <QWidget>

#include "view3d/scene3d.h"

namespace raytree::inspector {

/// With so many pixels to one of the screen's units.
QImage image_of(const FrameImage& frame, double ratio);

/// Shows the frames of the 3D view.
class SceneCanvas : public QWidget {
    Q_OBJECT

  public:
    explicit SceneCanvas(QWidget* parent);

    void show_frame(const QImage& frame);
    void set_palette_of(Theme theme);

  Q_SIGNALS:
    /// A frame is on the screen.
    void drawn();

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QImage frame_;  ///< null until there is one
    Theme theme_ = Theme::light;
    bool is_new_ = false;
};

}  // namespace raytree::inspector
