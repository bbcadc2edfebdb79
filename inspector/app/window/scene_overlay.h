#pragma once

#include <QStringList>
#include <QWidget>
#include <vector>

#include "drawing/words.h"
#include "window/scene_labels.h"

class QPainter;

namespace raytree::inspector {

/// What Qt writes over the 3D view: names beside things and the legend. Names keep clear of each
/// other; one that finds no room is left out.
class SceneOverlay : public QWidget {
  public:
    SceneOverlay(const State& state, QWidget* parent);

    /// Over a frame that shows this view.
    void set_labels(const View& view, std::vector<SceneLabel> labels, std::vector<WordLine> lines);
    void set_legend(const SceneLegend& legend);
    /// Sentences below the legend: what of the tree is not drawn.
    void set_notes(const QStringList& notes);
    /// The legend and notes of another overlay, in its letters.
    void take_words_of(const SceneOverlay& other);
    /// How much of the lower edge the legend takes in a view of this width, its margins included.
    int foot(int width) const;

  protected:
    void paintEvent(QPaintEvent*) override;

  private:
    struct Entry {
        std::optional<RayLook> look;  ///< none: a ring, or dots for what was not sent
        QString text;
        bool dotted = false, dimmed = false;
    };
    struct Layout {
        std::vector<QPointF> places;  ///< of the entries, from the box's top left corner
        std::vector<QPointF> notes;   ///< the first beside the last entry where it has room
        QSizeF size;
        double line = 0;  ///< the height of one
    };
    std::vector<Entry> entries() const;
    Layout layout(const QFontMetricsF& metrics, int width) const;
    QRectF draw_legend(QPainter& painter) const;
    void draw_entry(QPainter& painter, const Entry& entry, const QRectF& place) const;
    void draw_leader(QPainter& painter, QPointF from, const QRectF& box) const;
    void draw_label(QPainter& painter, const SceneLabel& label, const QRectF& place) const;
    void draw_through(QPainter& painter, const SceneLabel& label, QPointF at) const;
    void draw_away(QPainter& painter, const SceneLabel& label, std::vector<WordBox>& taken) const;
    void draw_labels(QPainter& painter, QRectF legend) const;

    const State& state_;
    View view_;
    std::vector<SceneLabel> labels_;
    std::vector<WordLine> lines_;  ///< rays, which labels keep clear of
    SceneLegend legend_;
    QStringList notes_;
};

}  // namespace raytree::inspector
