#pragma once

#include <QTreeView>

#include "state/state.h"
#include "window/outline_model.h"

namespace raytree::inspector {

/// The tree as an outline with columns. Choosing a row selects its ray; of a ghost, the ray that it
/// would have been sent from. A click on a column's title sorts, the right button there chooses
/// columns.
class OutlinePane : public QTreeView {
    Q_OBJECT

  public:
    explicit OutlinePane(inspector::State& state, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {800, 260}; }

  protected:
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void drawRow(QPainter* painter, const QStyleOptionViewItem& option,
                 const QModelIndex& index) const override;

  private:
    void obey(const Changes& changes);
    void renew();
    void show_tree();
    void show_selection();
    void show_columns();
    void size_columns();
    int width_for(Column column) const;
    int width_for_rays() const;
    int left_for_names(bool brief);
    void choose_columns(QPoint place);
    void copy(bool all);

    inspector::State& state_;  // not QAbstractItemView::State
    OutlineModel* model_;
    /// What has changed since it was last seen.
    bool stale_columns_ = false, stale_tree_ = false, stale_selection_ = false;
    bool brief_ = false;      ///< as the model writes texts: in a narrow pane
    bool following_ = false;  ///< while the selection is taken over from the state
};

}  // namespace raytree::inspector
