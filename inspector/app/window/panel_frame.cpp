#include "window/panel_frame.h"

#include <QEvent>
#include <QPainter>
#include <QPen>

#include "window/qt_text.h"

namespace raytree::inspector {
namespace {

constexpr int line = 2;

}  // namespace

PanelFrame::PanelFrame(QWidget* window) : QWidget(window) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    hide();
}

void PanelFrame::put_around(QWidget* pane, Ink ink) {
    if (pane_ != pane) {
        if (pane_) {
            pane_->removeEventFilter(this);
        }
        pane_ = pane;
        if (pane_) {
            pane_->installEventFilter(this);
        }
    }
    ink_ = ink;
    follow();
    update();
}

void PanelFrame::follow() {
    setVisible(pane_ && pane_->isVisible());
    if (pane_) {
        const QPoint corner = pane_->mapTo(parentWidget(), QPoint(0, 0));
        setGeometry(QRect(corner, pane_->size()).adjusted(-line, -line, line, line));
        // Only the frame itself lies over the window: what it encloses is not drawn anew with it.
        setMask(QRegion(rect()) - QRegion(rect().adjusted(line, line, -line, -line)));
        raise();
    }
}

bool PanelFrame::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::Resize:
        case QEvent::Move:
        case QEvent::Show:
        case QEvent::Hide:
            follow();
            break;
        default:
            break;
    }
    return QWidget::eventFilter(watched, event);
}

void PanelFrame::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), qt(ink_));
}

}  // namespace raytree::inspector
