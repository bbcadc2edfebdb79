#include "window/outline_pane.h"

#include <QHeaderView>
#include <algorithm>

namespace raytree::inspector {
namespace {

constexpr std::size_t most_expanded = 1000;  // rays; larger trees open level by level
constexpr int levels_of_large_trees = 4;

}  // namespace

OutlinePane::OutlinePane(inspector::State& state, QWidget* parent)
    : QTreeView(parent), state_(state), model_(new OutlineModel(this)) {
    setModel(model_);
    setUniformRowHeights(true);
    setIndentation(13);
    setAllColumnsShowFocus(true);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    setIconSize({24, 16});
    header()->setStretchLastSection(true);
    header()->setMinimumSectionSize(30);
    state_.observe([this](const Changes& changes) {
        if (changes.tree || changes.look || changes.document || changes.playback) {
            show_tree();
        }
        if (changes.selection || changes.look || changes.playback) {
            show_selection();
        }
    });
}

void OutlinePane::show_tree() {
    following_ = true;
    const Quantize quantize =
        state_.document() ? state_.document()->scene().settings.quantize : Quantize::round;
    model_->follow(state_.playback());
    model_->show(state_.tree(), state_.look().ghosts, state_.look().theme, quantize);
    if (state_.tree() && state_.tree()->tree.rays.size() <= most_expanded) {
        expandAll();
    } else {
        expandToDepth(levels_of_large_trees);
    }
    following_ = false;
}

void OutlinePane::show_selection() {
    following_ = true;
    const QModelIndex index =
        state_.selected() ? model_->index_of_ray(state_.selected()->id) : QModelIndex();
    const bool on_its_ghost = currentIndex().isValid() && index.isValid() &&
                              model_->row(currentIndex()).ray == state_.selected()->id &&
                              model_->row(currentIndex()).skipped;
    if (!on_its_ghost) {
        setCurrentIndex(index);
        scrollTo(index);
    }
    following_ = false;
}

void OutlinePane::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
    QTreeView::currentChanged(current, previous);
    if (!following_ && current.isValid()) {
        state_.select(model_->row(current).ray);
    }
}

void OutlinePane::resizeEvent(QResizeEvent* event) {
    QTreeView::resizeEvent(event);
    size_columns();
}

/// Shares of the width, except that numbers get what they need.
void OutlinePane::size_columns() {
    const QFontMetrics metrics(font());
    const int t = metrics.horizontalAdvance(QStringLiteral("-1.234e-5")) + 12;
    const int intensity = metrics.horizontalAdvance(QStringLiteral("0.000  0.000  0.000")) + 42;
    const int rest = std::max(300, viewport()->width() - t - intensity);
    setColumnWidth(OutlineModel::ray_column, static_cast<int>(rest * 0.37));
    setColumnWidth(OutlineModel::met_column, static_cast<int>(rest * 0.25));
    setColumnWidth(OutlineModel::t_column, t);
    setColumnWidth(OutlineModel::intensity_column, intensity);
}

}  // namespace raytree::inspector
