#include "window/fitting_label.h"

namespace raytree::inspector {

void FittingLabel::set_texts(const QStringList& texts) {
    texts_ = texts;
    setText(texts.value(0));
    wanted_ = QLabel::sizeHint();
    updateGeometry();
    fit();
}

void FittingLabel::resizeEvent(QResizeEvent* event) {
    QLabel::resizeEvent(event);
    fit();
}

void FittingLabel::fit() {
    for (const QString& text : texts_) {
        setText(text);
        if (QLabel::sizeHint().width() <= width()) {
            break;
        }
    }
    const int over = QLabel::sizeHint().width() - width();
    if (over > 0 && !texts_.isEmpty()) {
        const int room = fontMetrics().horizontalAdvance(texts_.back()) - over;
        setText(fontMetrics().elidedText(texts_.back(), Qt::ElideRight, room));
    }
    setToolTip(text() == texts_.value(0) ? QString() : texts_.value(0));
}

}  // namespace raytree::inspector
