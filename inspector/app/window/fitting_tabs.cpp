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

void FittingTabs::set_icons(const QList<QIcon>& icons) {
    icons_ = icons;
    fit();
}

void FittingTabs::write(const QStringList& titles, bool with_icons) {
    for (int k = 0; k < count(); ++k) {
        setTabText(k, with_icons ? QString() : titles[k]);
        setTabIcon(k, with_icons ? icons_.value(k) : QIcon());
        setTabToolTip(k, tabText(k) == titles_[k] ? QString() : titles_[k]);
    }
}

void FittingTabs::fit() {
    const int height = fontMetrics().height();
    setIconSize({height, height});
    write(titles_, false);
    if (sizeHint().width() > width()) {
        write(brief_, false);
    }
    if (sizeHint().width() > width() && !icons_.isEmpty()) {
        write(titles_, true);
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
