#pragma once

#include <QStringList>
#include <QWidget>
#include <optional>
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
    std::optional<Point3> out = std::nullopt;  ///< towards which it may be moved
};

/// What Qt writes over the 3D view: names beside things and the legend. Names keep clear of each
/// other; one that finds no room is left out.
class SceneOverlay : public QWidget {
  public:
    SceneOverlay(const State& state, const View& view, QWidget* parent);

    /// To be called while the view beneath is painted: the overlay is painted next.
    void set_labels(std::vector<SceneLabel> labels);
    /// Sentences below the legend: what of the tree is not drawn.
    void set_notes(const QStringList& notes);

  protected:
    void paintEvent(QPaintEvent*) override;

  private:
    QRectF draw_legend(QPainter& painter) const;
    void draw_notes(QPainter& painter, QRectF lines) const;
    void draw_leader(QPainter& painter, QPointF from, const QRectF& box) const;
    void draw_label(QPainter& painter, const SceneLabel& label, const QRectF& place) const;
    void draw_labels(QPainter& painter, QRectF legend) const;

    const State& state_;
    const View& view_;
    std::vector<SceneLabel> labels_;
    QStringList notes_;
};

/// The names of what stands in the 3D view just now.
std::vector<SceneLabel> scene_labels(const State& state, const Extent& extent, const View& view,
                                     bool from_the_eye);

}  // namespace raytree::inspector
