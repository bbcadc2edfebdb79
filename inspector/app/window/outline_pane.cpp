#include "window/outline_pane.h"

#include <QContextMenuEvent>
#include <QHeaderView>
#include <QMenu>
#include <QPainter>
#include <QStyledItemDelegate>
#include <algorithm>
#include <numeric>
#include <utility>

#include "state/commands.h"
#include "window/qt_text.h"

namespace raytree::inspector {
namespace {

constexpr std::size_t most_expanded = 1000;  // rays; larger trees open level by level
constexpr int levels_of_large_trees = 4;

/// In deep trees rows stand closer to those above them: what is in the deepest is to be read too.
constexpr int most_indented = 13, least_indented = 6, all_indented = 84;  // pixels

int indentation_for(const PixelTree* tree) {
    return tree ? std::clamp(all_indented / std::max(1, tree->tree.counts.levels), least_indented,
                             most_indented)
                : most_indented;
}

constexpr int around_text = 16;  // pixels: a cell's padding and margins

/// Long names of objects are shortened, the other texts are not: what is left for names at least
/// where everything is written out.
constexpr int wanted_letters = 20;

/// Leaves to `drawRow` what becomes of rays that were not sent.
class MetDelegate : public QStyledItemDelegate {
  public:
    MetDelegate(const OutlineModel& model, QObject* parent)
        : QStyledItemDelegate(parent), model_(model) {}

  protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        if (model_.row(index).skipped) {
            option->text.clear();
        }
    }

  private:
    const OutlineModel& model_;
};

}  // namespace

OutlinePane::OutlinePane(inspector::State& state, QWidget* parent)
    : QTreeView(parent), state_(state), model_(new OutlineModel(this)) {
    setModel(model_);
    setUniformRowHeights(true);
    setAllColumnsShowFocus(true);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    setIconSize({24, 16});
    header()->setStretchLastSection(true);
    header()->setMinimumSectionSize(30);
    header()->setSectionsClickable(true);
    header()->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(header(), &QHeaderView::sectionClicked, this, [this](int section) {
        const Column column = static_cast<Column>(section);
        run_command(state_, "table.sort", inspector::text_of(column).word);
    });
    connect(header(), &QWidget::customContextMenuRequested, this,
            [this](QPoint at) { choose_columns(header()->mapToGlobal(at)); });
    connect(this, &QTreeView::clicked, this, [this](const QModelIndex& index) {
        state_.select(model_->row(index).ray);  // the current row's, too: it may be an answer
    });
    setItemDelegateForColumn(static_cast<int>(Column::met), new MetDelegate(*model_, this));
    show_columns();
    state_.observe([this](const Changes& changes) { obey(changes); });
}

void OutlinePane::obey(const Changes& changes) {
    stale_columns_ |= changes.table;
    stale_tree_ |=
        changes.tree || changes.look || changes.document || changes.table || changes.playback;
    stale_selection_ |= changes.selection || stale_tree_;  // with the rows the selection goes
    if (isVisible()) {
        renew();
    }
    if (changes.request == Request::choose_columns) {
        choose_columns(header()->mapToGlobal(QPoint(8, header()->height())));
    } else if (changes.request == Request::copy_rows || changes.request == Request::copy_table) {
        copy(changes.request == Request::copy_table);
    }
}

void OutlinePane::renew() {
    if (std::exchange(stale_columns_, false)) {
        show_columns();
    }
    if (std::exchange(stale_tree_, false)) {
        show_tree();
    }
    if (std::exchange(stale_selection_, false)) {
        show_selection();
    }
}

void OutlinePane::showEvent(QShowEvent* event) {
    QTreeView::showEvent(event);
    renew();
}

void OutlinePane::show_tree() {
    following_ = true;
    model_->show(state_);
    size_columns();
    if (state_.tree() && state_.tree()->tree.rays.size() <= most_expanded) {
        expandAll();
    } else {
        expandToDepth(levels_of_large_trees);
    }
    following_ = false;
}

void OutlinePane::show_selection() {
    following_ = true;
    size_columns();  // other rows may be marked now
    const QModelIndex index =
        state_.selected() ? model_->index_of_ray(state_.selected()->id) : QModelIndex();
    const bool on_its_ghost = currentIndex().isValid() && index.isValid() &&
                              model_->row(currentIndex()).ray == state_.selected()->id &&
                              model_->row(currentIndex()).skipped;
    const bool among_others = index.isValid() && currentIndex() == index;
    if (!on_its_ghost && !among_others) {
        setCurrentIndex(index);
    }
    if (!on_its_ghost) {
        scrollTo(index);
    }
    following_ = false;
}

/// Which columns there are, and by which of them the rays are sorted.
void OutlinePane::show_columns() {
    const Table& table = state_.table();
    for (int k = 0; k < static_cast<int>(column_count); ++k) {
        setColumnHidden(k, !table.has(static_cast<Column>(k)));
    }
    const bool sorted = table.sorted_by.has_value();
    header()->setSortIndicatorShown(sorted);
    if (sorted) {
        header()->setSortIndicator(static_cast<int>(*table.sorted_by),
                                   table.descending ? Qt::DescendingOrder : Qt::AscendingOrder);
    }
    setRootIsDecorated(!sorted);
}

void OutlinePane::choose_columns(QPoint place) {
    auto* const menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (std::size_t k = 1; k < column_count; ++k) {
        const ColumnText& text = inspector::text_of(static_cast<Column>(k));
        QAction* const action = menu->addAction(qt(text.title));
        action->setCheckable(true);
        action->setChecked(state_.table().has(static_cast<Column>(k)));
        connect(action, &QAction::triggered, this,
                [this, word = text.word] { run_command(state_, "table.column", word); });
    }
    menu->addSeparator();
    QMenu* const order = menu->addMenu(QStringLiteral("Sort by"));
    for (const Column column : state_.table().columns) {
        const ColumnText& text = inspector::text_of(column);
        order->addAction(qt(text.title),
                         [this, word = text.word] { run_command(state_, "table.sort", word); });
    }
    for (const char* const id : {"table.as_tree", "table.first_columns"}) {
        const Command& command = *find_command(id);
        menu->addAction(qt(command.title), [this, id] { run_command(state_, id); })
            ->setEnabled(!command.possible || command.possible(state_));
    }
    menu->popup(place);  // whoever asks, such as a script, goes on
}

/// The rays of the rows that are chosen, or all of them, in the order in which they stand.
void OutlinePane::copy(bool all) {
    if (!state_.tree()) {
        return;
    }
    renew();
    const PixelTree& tree = *state_.tree();
    const Table& table = state_.table();
    std::vector<std::size_t> rays(tree.tree.rays.size());
    std::iota(rays.begin(), rays.end(), std::size_t{0});
    if (table.sorted_by) {
        rays = sorted_rays(tree, *table.sorted_by, table.descending);
    }
    if (!all) {
        std::vector<bool> chosen(rays.size());
        for (const QModelIndex& index : selectionModel()->selectedRows()) {
            chosen[model_->row(index).ray] = true;
        }
        std::erase_if(rays, [&](std::size_t ray) { return !chosen[ray]; });
    }
    state_.request(Request::copy_text, copied(tree, rays, table.columns));
    state_.say("Copied: " + std::to_string(rays.size()) + (rays.size() == 1 ? " ray." : " rays."));
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

void OutlinePane::contextMenuEvent(QContextMenuEvent* event) {
    QMenu menu(this);
    for (const char* const id :
         {"copy.rows", "copy.table", "copy.ray_text", "copy.ray_json", "table.columns"}) {
        const Command& command = *find_command(id);
        menu.addAction(qt(command.title), [this, id] { run_command(state_, id); });
    }
    menu.exec(event->globalPos());
}

int OutlinePane::width_for(Column column) const {
    const QFontMetrics metrics(font());
    const auto of = [&](const char* text) {
        return metrics.horizontalAdvance(QString::fromUtf8(text)) + 13 +
               metrics.horizontalAdvance(model_->room_for_arrow(static_cast<int>(column)));
    };
    switch (column) {
        case Column::intensity:
            return of(brief_ ? "0.00 0.00 0.00" : "0.000  0.000  0.000") + 24;
        case Column::t:
        case Column::attenuation:
            return std::max(of(brief_ ? "0.001234" : "0.0001234"), of("1.234e-5"));
        case Column::met:
            return of(state_.tree() && state_.tree()->recorded ? "not given" : "the light");
        case Column::ended:
            return of("no intersection");
        case Column::level:
        case Column::side:
            return std::max(of("Level   "), of("front"));  // a title is bold
        case Column::angle:
            return of("Angle to n    ");
        case Column::weight:
            return of("0.000  0.000  0.000 ");
        case Column::eta:
            return of("1.333 → 1.333");
        case Column::material:
            return of("a material of");
        default:
            return of("-0.1234  -0.1234  -0.1234");
    }
}

/// Of the deepest row.
int OutlinePane::width_for_rays() const {
    QFont widest = font();
    widest.setBold(state_.thing() || (state_.tree() && state_.tree()->contrast));
    int levels = 1;
    if (const auto& tree = state_.tree()) {
        levels += std::max(tree->tree.counts.levels,
                           tree->contrast ? tree->contrast->other.counts.levels : 0);
    }
    const int indented = std::min(levels * (brief_ ? least_indented : most_indented), all_indented);
    return indented + iconSize().width() + 4 + around_text +
           QFontMetrics(widest).horizontalAdvance(model_->widest_ray());
}

/// What is left for the names of objects, once everything else has its room.
int OutlinePane::left_for_names(bool brief) {
    brief_ = brief;
    model_->set_brief(brief);
    setIconSize({brief ? 19 : 24, 16});
    int rest = viewport()->width() - width_for_rays();
    for (const Column column : state_.table().columns) {
        if (column != Column::ray && column != Column::met) {
            setColumnWidth(static_cast<int>(column), width_for(column));
            rest -= width_for(column);
        }
    }
    return rest;
}

/// Beyond the pane's edge is nothing, as long as there is room for a few letters of each name; from
/// there on the pane scrolls, and has names as well as the rest written out.
void OutlinePane::size_columns() {
    const int wanted =
        std::min(wanted_letters * fontMetrics().averageCharWidth(),
                 fontMetrics().horizontalAdvance(model_->widest_met()) + around_text);
    int rest = left_for_names(false);
    if (rest < wanted) {
        rest = left_for_names(true);
    }
    if (rest < width_for(Column::met)) {
        rest = wanted;
    }
    const int spare = std::max(0, rest - wanted) / 3;
    setColumnWidth(static_cast<int>(Column::ray), width_for_rays() + spare);
    setColumnWidth(static_cast<int>(Column::met), rest - spare);
    setIndentation(brief_ ? least_indented : indentation_for(state_.tree().get()));
    viewport()->update();
}

/// Why a ray was not sent stands across the columns, which have nothing else to say of it.
void OutlinePane::drawRow(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const {
    QTreeView::drawRow(painter, option, index);
    if (!model_->row(index).skipped) {
        return;
    }
    const QModelIndex met = index.siblingAtColumn(static_cast<int>(Column::met));
    const int ray = static_cast<int>(Column::ray);
    const int left = columnViewportPosition(ray) + columnWidth(ray) + 3;
    const int right = std::max(viewport()->width(), header()->length() - header()->offset());
    const QRect place(left, option.rect.y(), right - left, option.rect.height());
    const QFont font = met.data(Qt::FontRole).value<QFont>();
    painter->save();
    painter->setFont(font);
    painter->setPen(met.data(Qt::ForegroundRole).value<QColor>());
    painter->drawText(
        place, Qt::AlignLeft | Qt::AlignVCenter,
        QFontMetrics(font).elidedText(met.data().toString(), Qt::ElideRight, place.width()));
    painter->restore();
}

}  // namespace raytree::inspector
