#include "window/wrapped_list.h"

#include <QAbstractItemDelegate>
#include <QEvent>
#include <QHeaderView>
#include <algorithm>

namespace raytree::inspector {

WrappedList::WrappedList(int column, QWidget* parent) : QTreeWidget(parent), column_(column) {
    setWordWrap(true);
    setTextElideMode(Qt::ElideNone);
    setRootIsDecorated(false);
    header()->setStretchLastSection(true);
}

/// Each line is as high as its words need, which the delegate knows: it lays them out as it draws
/// them.
void WrappedList::fit_rows() {
    QStyleOptionViewItem cell;
    cell.initFrom(this);
    cell.features |= QStyleOptionViewItem::WrapText;
    int width = viewport()->width();
    for (int column = 0; column < column_; ++column) {
        width -= columnWidth(column);
    }
    cell.rect = QRect(0, 0, std::max(width, 60), 10'000);
    for (int k = 0; k < topLevelItemCount(); ++k) {
        QTreeWidgetItem* const item = topLevelItem(k);
        item->setSizeHint(column_, QSize());  // else the delegate says what it was told before
        const QModelIndex index = model()->index(k, column_);
        item->setSizeHint(column_, {0, itemDelegate()->sizeHint(cell, index).height() + 6});
    }
}

bool WrappedList::event(QEvent* event) {
    const bool done = QTreeWidget::event(event);
    // The theme's font comes with the polish, when the lines may be there already.
    if (event->type() == QEvent::Polish || event->type() == QEvent::FontChange) {
        fit_rows();
    }
    return done;
}

void WrappedList::resizeEvent(QResizeEvent* event) {
    QTreeWidget::resizeEvent(event);
    fit_rows();
}

}  // namespace raytree::inspector
