#include "window/side_dock.h"

#include <QHBoxLayout>
#include <QStackedWidget>
#include <QStyle>
#include <QTabBar>
#include <QToolButton>
#include <algorithm>

#include "window/change_pane.h"
#include "window/compare_pane.h"
#include "window/steps_pane.h"

namespace raytree::inspector {

SideDock::SideDock(State& state, std::function<void(const std::string&)> run,
                   std::function<void(const InputError&)> fail, QWidget* parent)
    : QDockWidget(parent), state_(state) {
    setObjectName(QStringLiteral("side"));
    setWindowTitle(QStringLiteral("Steps, changes, differences"));
    setFeatures(QDockWidget::NoDockWidgetFeatures);
    steps_ = new StepsPane(state_);
    change_ = new ChangePane(state_, run, std::move(fail));
    compare_ = new ComparePane(state_, std::move(run));
    panes_ = new QStackedWidget;
    panes_->addWidget(steps_);
    panes_->addWidget(change_);
    panes_->addWidget(compare_);
    panes_->setMinimumWidth(std::max(270, 40 * fontMetrics().averageCharWidth()));
    setWidget(panes_);
    setTitleBarWidget(make_title());
    state_.observe([this](const Changes& changes) {
        if (changes.side_pane) {
            show_pane();
        }
    });
    show_pane();
}

/// Its tabs are its title.
QWidget* SideDock::make_title() {
    auto* const box = new QWidget;
    auto* const layout = new QHBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    tabs_ = new QTabBar;
    tabs_->setExpanding(false);
    tabs_->setDrawBase(false);
    for (const char* const title : {"Steps", "Change", "Compare"}) {
        tabs_->addTab(QString::fromUtf8(title));
    }
    auto* const close = new QToolButton;
    close->setText(QStringLiteral("✕"));
    close->setToolTip(QStringLiteral("Hides this pane"));
    close->setAccessibleName(QStringLiteral("Hide this pane"));
    layout->addWidget(tabs_, 1);
    layout->addWidget(close);
    connect(tabs_, &QTabBar::currentChanged, this, [this](int tab) {
        if (state_.side_pane() != SidePane::none) {
            state_.show_side(static_cast<SidePane>(tab + 1));
        }
    });
    connect(close, &QToolButton::clicked, this, [this] { state_.show_side(SidePane::none); });
    return box;
}

void SideDock::show_pane() {
    const SidePane pane = state_.side_pane();
    if (pane != SidePane::none) {
        const int place = static_cast<int>(pane) - 1;
        tabs_->setCurrentIndex(place);
        panes_->setCurrentIndex(place);
    }
    setVisible(pane != SidePane::none);
}

QWidget* SideDock::pane() const { return panes_->currentWidget(); }

}  // namespace raytree::inspector
