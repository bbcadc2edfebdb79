#include "window/compare_pane.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "state/commands.h"
#include "state/contrast_lines.h"
#include "window/actions.h"
#include "window/qt_text.h"
#include "window/wrapped_list.h"

namespace raytree::inspector {
namespace {

constexpr std::size_t most_lines = 2000;

QLabel* words() {
    auto* const label = new QLabel;
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

}  // namespace

ComparePane::ComparePane(State& state, std::function<void(const std::string&)> run, QWidget* parent)
    : QWidget(parent), state_(state), run_(std::move(run)) {
    names_ = words();
    summary_ = words();
    remarks_ = words();
    legend_ = words();
    legend_->setObjectName(QStringLiteral("aside"));
    lines_ = new WrappedList(1);
    lines_->setAccessibleName(QStringLiteral("Differences"));
    lines_->setHeaderLabels({QString(), QStringLiteral("Differences, causes first")});
    lines_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(names_);
    layout->addWidget(summary_);
    layout->addWidget(ways_ = make_ways());
    layout->addWidget(buttons_ = make_buttons());
    layout->addWidget(lines_, 1);
    layout->addWidget(remarks_);
    layout->addWidget(legend_);
    layout->addStretch(0);
    connect(lines_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        if (item && !following_) {
            state_.select(item->data(0, Qt::UserRole).toULongLong());
        }
    });
    state_.observe([this](const Changes& changes) { obey(changes); });
    show_lines();
}

QPushButton* ComparePane::make_button(const std::string& command, const QString& title) {
    const Command& one = *find_command(command);
    auto* const button = new QPushButton(title);
    button->setToolTip(hint_of(one));
    connect(button, &QPushButton::clicked, this, [this, command] { run_(command); });
    commands_.emplace_back(button, command);
    return button;
}

/// To begin with: what a tree can be compared with.
QWidget* ComparePane::make_ways() {
    auto* const box = new QWidget;
    auto* const layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 6, 0, 0);
    for (const char* const command : {"compare.this_pixel", "compare.before", "compare.file"}) {
        layout->addWidget(make_button(command, qt(find_command(command)->title)));
    }
    return box;
}

QWidget* ComparePane::make_buttons() {
    auto* const box = new QWidget;
    auto* const layout = new QHBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(make_button("compare.swap", QStringLiteral("Show the other")));
    layout->addWidget(make_button("compare.end", QStringLiteral("End")));
    layout->addStretch(1);
    return box;
}

QTreeWidget* ComparePane::lines() const { return lines_; }

QString ComparePane::summary() const { return summary_->text(); }

void ComparePane::obey(const Changes& changes) {
    other_lines_ |= changes.tree || changes.look || changes.side_pane;
    if (isVisible() && other_lines_) {
        show_lines();
    } else if (isVisible() && changes.selection) {
        show_selection();
    }
    for (const auto& [button, command] : commands_) {
        button->setEnabled(find_command(command)->possible(state_));
    }
}

void ComparePane::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (other_lines_) {
        show_lines();
    } else {
        show_selection();
    }
}

void ComparePane::show_nothing() {
    names_->setText(state_.comparing()
                        ? QStringLiteral("This pixel is not compared.")
                        : QStringLiteral("Nothing is compared. Choose what this tree is to be "
                                         "compared with:"));
    summary_->clear();
    remarks_->clear();
    legend_->clear();
}

void ComparePane::show_lines() {
    following_ = true;
    other_lines_ = false;
    lines_->clear();
    const auto& tree = state_.tree();
    const Contrast* const contrast = tree && state_.comparing() ? tree->contrast.get() : nullptr;
    ways_->setVisible(!state_.comparing());
    buttons_->setVisible(state_.comparing());
    for (QWidget* const widget :
         std::initializer_list<QWidget*>{lines_, summary_, remarks_, legend_}) {
        widget->setVisible(contrast);
    }
    if (!contrast) {
        show_nothing();
        following_ = false;
        return;
    }
    names_->setText(QStringLiteral("<b>Shown: %1</b><br>beside it: %2")
                        .arg(qt(contrast->shown_name).toHtmlEscaped(),
                             qt(contrast->other_name).toHtmlEscaped()));
    summary_->setText(qt(summary_of(*contrast)));
    for (std::size_t k = 0; k < std::min(most_lines, contrast->lines.size()); ++k) {
        const ContrastLine& line = contrast->lines[k];
        auto* const item =
            new QTreeWidgetItem(lines_, {qt(text_of(line.mark).sign), qt(line.text)});
        item->setData(0, Qt::UserRole, QVariant::fromValue<qulonglong>(line.ray));
        item->setToolTip(0, qt(text_of(line.mark).explained));
        item->setToolTip(1, qt(line.text));
        QFont font;  // the size is left to the list, whose theme may come later
        font.setBold(line.mark == RayMark::different);
        item->setFont(1, font);
        item->setTextAlignment(0, Qt::AlignTop | Qt::AlignHCenter);
    }
    QString remarks;
    if (contrast->lines.size() > most_lines) {
        remarks = QStringLiteral("Listed are the first %1 of %2 differences.")
                      .arg(most_lines)
                      .arg(contrast->lines.size());
    }
    for (const std::string& remark : contrast->remarks) {
        remarks += (remarks.isEmpty() ? QString() : QStringLiteral("\n")) + qt(remark);
    }
    remarks_->setText(remarks);
    remarks_->setVisible(!remarks.isEmpty());
    const std::string& reference =
        contrast->shown_is_reference ? contrast->shown_name : contrast->other_name;
    legend_->setText(
        QStringLiteral("≠\u00a0differs, and here is why   ~\u00a0follows from another   "
                       "−\u00a0missing: only in %1   +\u00a0extra: not in it")
            .arg(contrast->what == Contrast::What::file ? QStringLiteral("the reference")
                                                        : qt(reference)));
    following_ = false;
    lines_->fit_rows();
    show_selection();
    lines_->scrollToTop();  // the causes stand first
}

void ComparePane::show_selection() {
    following_ = true;
    lines_->setCurrentItem(nullptr);
    for (int k = 0; state_.selected() && k < lines_->topLevelItemCount(); ++k) {
        QTreeWidgetItem* const item = lines_->topLevelItem(k);
        if (item->data(0, Qt::UserRole).toULongLong() == state_.selected()->id) {
            lines_->setCurrentItem(item);
            break;
        }
    }
    following_ = false;
}

}  // namespace raytree::inspector
