#include "window/fitting_tabs.h"

#include <QEvent>

namespace raytree::inspector {

FittingTabs::FittingTabs() {
    setExpanding(false);
    setDrawBase(false);
    setUsesScrollButtons(false);
    setElideMode(Qt::ElideRight);
}

void FittingTabs::add(const QString& title, const QString& brief) {
    titles_ << title;
    brief_ << brief;
    addTab(title);
}

void FittingTabs::write(const QStringList& titles) {
    for (int k = 0; k < count(); ++k) {
        setTabText(k, titles[k]);
        setTabToolTip(k, titles[k] == titles_[k] ? QString() : titles_[k]);
    }
}

void FittingTabs::fit() {
    write(titles_);
    if (sizeHint().width() > width()) {
        write(brief_);
    }
}

void FittingTabs::resizeEvent(QResizeEvent* event) {
    QTabBar::resizeEvent(event);
    fit();
}

void FittingTabs::changeEvent(QEvent* event) {
    QTabBar::changeEvent(event);
    if (event->type() == QEvent::FontChange) {
        fit();
    }
}

}  // namespace raytree::inspector
