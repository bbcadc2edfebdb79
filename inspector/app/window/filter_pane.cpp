#include "window/filter_pane.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <algorithm>

#include "state/commands.h"
#include "tree/explain.h"
#include "window/fitting_label.h"
#include "window/icons.h"
#include "window/qt_text.h"

namespace raytree::inspector {
namespace {

constexpr const char* titles[] = {"Kind", "Level", "Light", "Object"};
constexpr double weights[] = {0, 0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1};

Qt::CheckState tick_of(Shown shown) {
    return shown == Shown::full     ? Qt::Checked
           : shown == Shown::dimmed ? Qt::PartiallyChecked
                                    : Qt::Unchecked;
}
Shown shown_of(Qt::CheckState tick) {
    return tick == Qt::Checked            ? Shown::full
           : tick == Qt::PartiallyChecked ? Shown::dimmed
                                          : Shown::hidden;
}

/// Read after "Rays of".
QString words_of(double least_weight) {
    return least_weight > 0
               ? QStringLiteral("less than %1 of the pixel").arg(qt(number_text(least_weight)))
               : QStringLiteral("any share of the pixel");
}

QString name_of(const QTreeWidgetItem* item) { return item->data(0, Qt::UserRole).toString(); }

}  // namespace

FilterPane::FilterPane(State& state, QWidget* parent) : QWidget(parent), state_(state) {
    auto* const layout = new QGridLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    for (int k = 0; k < 4; ++k) {
        auto* const list = new QTreeWidget;
        list->setRootIsDecorated(false);
        list->setUniformRowHeights(true);
        list->setAccessibleName(QString::fromUtf8(titles[k]));
        list->setHeaderLabels({QString::fromUtf8(titles[k]), QStringLiteral("rays")});
        list->setTextElideMode(Qt::ElideMiddle);  // "glass p…side 1": sides differ at their end
        list->header()->setStretchLastSection(false);
        list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
        list->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
        connect(list, &QTreeWidget::itemChanged, this, &FilterPane::take_click);
        layout->addWidget(list, 0, k);
        constexpr int stretches[] = {3, 2, 3, 8};
        layout->setColumnStretch(k, stretches[k]);
        lists_.push_back(list);
    }
    layout->addWidget(make_weights(), 1, 0, 1, 4);
    setToolTip(QStringLiteral("ticked: shown; half ticked: dimmed; not ticked: hidden"));
    state_.observe([this](const Changes& changes) {
        if (isVisible() && (changes.tree || changes.look)) {
            renew();
        }
    });
}

QWidget* FilterPane::make_weights() {
    auto* const box = new QWidget;
    auto* const row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    weight_ = new QComboBox;
    lighter_ = new QComboBox;
    for (const double weight : weights) {
        weight_->addItem(words_of(weight), weight);
    }
    lighter_->addItems({QStringLiteral("are dimmed"), QStringLiteral("are hidden")});
    weight_->setAccessibleName(QStringLiteral("Least share of the pixel"));
    weight_->setToolTip(QStringLiteral(
        "A shadow ray has the share of the pixel that the ray has from whose hit it is sent"));
    lighter_->setAccessibleName(QStringLiteral("Rays with a smaller share"));
    const auto send = [this] {
        if (!renewing_) {
            state_.change_look([this](Look& look) {
                look.filter.least_weight = weight_->currentData().toDouble();
                look.filter.lighter = lighter_->currentIndex() == 0 ? Shown::dimmed : Shown::hidden;
            });
        }
    };
    connect(weight_, qOverload<int>(&QComboBox::currentIndexChanged), this, send);
    connect(lighter_, qOverload<int>(&QComboBox::currentIndexChanged), this, send);
    all_ = new QPushButton(QStringLiteral("Show all"));
    connect(all_, &QPushButton::clicked, this, [this] { run_command(state_, "filter.clear"); });
    auto* const key = new FittingLabel;
    key->setObjectName(QStringLiteral("aside"));
    key->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    key->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    key->set_texts({QStringLiteral("ticked: shown   half ticked: dimmed   not ticked: hidden"),
                    QStringLiteral("half ticked: dimmed"), QString()});
    row->addWidget(new QLabel(QStringLiteral("Rays of")));
    row->addWidget(weight_);
    row->addWidget(lighter_);
    row->addWidget(key, 1);
    row->addWidget(all_);
    return box;
}

/// Where there is little room, names have it rather than counts.
void FilterPane::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    constexpr int columns_of_letters = 90;
    const bool narrow = width() < columns_of_letters * fontMetrics().averageCharWidth();
    const QString counts = narrow ? QString() : QStringLiteral("   rays");
    for (std::size_t k = 0; k < lists_.size(); ++k) {
        const QString longest = k == 0 ? QStringLiteral("reflected") : QStringLiteral("Light");
        lists_[k]->setColumnHidden(1, narrow);
        lists_[k]->setMinimumWidth(fontMetrics().horizontalAdvance(longest + counts) + 50);
    }
}

void FilterPane::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    renew();
}

void FilterPane::renew() {
    renewing_ = true;
    const RayFilter& filter = state_.look().filter;
    std::vector<QString> current;
    for (QTreeWidget* const list : lists_) {
        current.push_back(list->currentItem() ? name_of(list->currentItem()) : QString());
        list->clear();
    }
    if (state_.tree()) {
        for (const CountedGroup& group : groups_of(*state_.tree(), filter)) {
            const auto k = static_cast<std::size_t>(group.group.by);
            add(lists_[k], group);
            if (qt(group.group.name) == current[k]) {
                lists_[k]->setCurrentItem(
                    lists_[k]->topLevelItem(lists_[k]->topLevelItemCount() - 1));
            }
        }
    }
    show_weight(filter.least_weight);
    lighter_->setCurrentIndex(filter.lighter == Shown::dimmed ? 0 : 1);
    lighter_->setVisible(filter.least_weight > 0);
    all_->setEnabled(!filter.empty());
    renewing_ = false;
}

/// A share that is none of the usual ones, such as a script's, is one more to choose.
void FilterPane::show_weight(double weight) {
    int place = weight_->findData(weight);
    if (place < 0) {
        for (place = 0; place < weight_->count() && weight_->itemData(place).toDouble() < weight;) {
            ++place;
        }
        weight_->insertItem(place, words_of(weight), weight);
    }
    weight_->setCurrentIndex(place);
}

void FilterPane::add(QTreeWidget* list, const CountedGroup& counted) {
    auto* const item =
        new QTreeWidgetItem(list, {qt(counted.group.name), QString::number(counted.rays)});
    item->setData(0, Qt::UserRole, qt(counted.group.name));
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable |
                   Qt::ItemIsUserTristate);
    item->setCheckState(0, tick_of(state_.look().filter.of(counted.group)));
    item->setTextAlignment(1, Qt::AlignRight);
    item->setToolTip(0, qt(counted.group.name));
    if (counted.rays == 0) {
        for (const int column : {0, 1}) {
            item->setForeground(column, palette().brush(QPalette::Disabled, QPalette::Text));
        }
        item->setToolTip(0, qt(counted.group.name) + QStringLiteral(": no such ray in this tree"));
    }
}

QTreeWidgetItem* FilterPane::item_of(const RayGroup& group) const {
    QTreeWidget* const list = lists_[static_cast<std::size_t>(group.by)];
    for (int k = 0; k < list->topLevelItemCount(); ++k) {
        if (name_of(list->topLevelItem(k)) == qt(group.name)) {
            return list->topLevelItem(k);
        }
    }
    return nullptr;
}

void FilterPane::take_click(QTreeWidgetItem* item) {
    if (renewing_) {
        return;
    }
    const auto by =
        static_cast<RayGroup::By>(std::ranges::find(lists_, item->treeWidget()) - lists_.begin());
    const RayGroup group{by, name_of(item).toStdString()};
    const Shown shown = shown_of(item->checkState(0));
    // The list is filled anew while this item is still being changed: only afterwards.
    QMetaObject::invokeMethod(
        this,
        [this, group, shown] {
            state_.change_look([&](Look& look) { look.filter.set(group, shown); });
        },
        Qt::QueuedConnection);
}

}  // namespace raytree::inspector
