#pragma once

#include <QWidget>
#include <vector>

#include "drawing/extent.h"
#include "state/state.h"

class QPainter;

namespace raytree::inspector {

/// A name in the 3D view.
struct SceneLabel {
    Point3 at;
    QString text;
    bool strong = false;
};

/// What Qt writes over the 3D view: names beside things and the legend. Names keep clear of each
/// other; one that finds no room is left out.
class SceneOverlay : public QWidget {
  public:
    SceneOverlay(const State& state, const View& view, QWidget* parent);

    void set_labels(std::vector<SceneLabel> labels);
    void set_note(const QString& note);

  protected:
    void paintEvent(QPaintEvent*) override;

  private:
    QRectF draw_legend(QPainter& painter) const;
    void draw_labels(QPainter& painter, QRectF legend) const;

    const State& state_;
    const View& view_;
    std::vector<SceneLabel> labels_;
    QString note_;
};

/// What the signs of a compared tree mean; empty where none is.
std::string contrast_note(const State& state);

/// The names of what stands in the 3D view just now.
std::vector<SceneLabel> scene_labels(const State& state, const Extent& extent, bool from_the_eye);

}  // namespace raytree::inspector
