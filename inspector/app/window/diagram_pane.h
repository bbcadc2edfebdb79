#pragma once

#include <QWidget>

#include "state/diagram_looks.h"
#include "state/state.h"

namespace raytree::inspector {

/// The tree as the lecture draws it: a click selects a ray, the wheel zooms, dragging moves, arrow
/// keys go along the branches.
class DiagramPane : public QWidget {
    Q_OBJECT

  public:
    explicit DiagramPane(State& state, QWidget* parent = nullptr);

    /// Where the middle of a ray's box, or of its row beside one, is in the pane.
    QPointF place_of_ray(std::size_t ray);
    double zoom() const { return scale_; }

  protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent*) override;
    void resizeEvent(QResizeEvent*) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void obey(const Changes& changes);
    void prepare();
    void begin_view();
    void fit();
    void zoom_by(double factor, QPointF about);
    void keep_in_place();
    void reveal_selection();
    void go(std::optional<std::size_t> ray);
    QPointF to_diagram(QPointF place) const { return (place - origin_) / scale_; }
    std::optional<DiagramSpot> spot_under(QPointF place);
    QString tooltip_at(QPointF place);
    void draw_note(QPainter& painter) const;
    void draw_bars(QPainter& painter) const;
    double room_height() const;

    State& state_;
    Diagram diagram_;
    std::shared_ptr<const PixelTree> tree_;  ///< of the diagram, which points into it
    double folded_below_ = 0;
    std::vector<BoxLook> looks_;  ///< of its boxes
    bool stale_looks_ = true;
    bool stale_ = true;     ///< whether the diagram is another one by now
    bool reveal_ = true;    ///< whether the selection is still to be scrolled to
    bool own_view_ = true;  ///< as long as nobody has zoomed or moved
    bool fitted_ = false;   ///< likewise since all of it was asked for
    double scale_ = 1;
    QPointF origin_;  ///< of the diagram in the pane
    QPointF pressed_, last_;
    bool dragged_ = false;
};

}  // namespace raytree::inspector
