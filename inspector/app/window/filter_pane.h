#pragma once

#include <QWidget>
#include <vector>

#include "state/state.h"

class QComboBox;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace raytree::inspector {

/// The groups of rays that the tree has (kinds, levels, lights, objects), each with a box that is
/// ticked where its rays are shown, half ticked where they are dimmed, and empty where they are
/// hidden; and the least share of the pixel.
class FilterPane : public QWidget {
    Q_OBJECT

  public:
    explicit FilterPane(State& state, QWidget* parent = nullptr);

    /// Null where the tree has no such rays, and the filter does not name them.
    QTreeWidgetItem* item_of(const RayGroup& group) const;

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

  private:
    QWidget* make_weights();
    void renew();
    void show_weight(double weight);
    void add(QTreeWidget* list, const CountedGroup& group);
    void take_click(QTreeWidgetItem* item);

    State& state_;
    std::vector<QTreeWidget*> lists_;  ///< by RayGroup::By
    QComboBox *weight_ = nullptr, *lighter_ = nullptr;
    QPushButton* all_ = nullptr;
    bool renewing_ = false;
};

}  // namespace raytree::inspector
