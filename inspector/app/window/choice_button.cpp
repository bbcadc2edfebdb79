#include "window/choice_button.h"

#include <QHBoxLayout>
#include <QLabel>

namespace raytree::inspector {

ChoiceButton::ChoiceButton(const QString& letter, const QString& html, const QString& plain,
                           QWidget* parent)
    : QPushButton(parent) {
    setAccessibleName(letter + QStringLiteral(": ") + plain);
    setObjectName(QStringLiteral("choice"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Minimum);
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(9, 6, 9, 6);
    row->setSpacing(8);
    auto* const mark = new QLabel(QStringLiteral("<b>%1</b>").arg(letter));
    auto* const text = new QLabel(html);
    text->setWordWrap(true);
    for (QLabel* const label : {mark, text}) {
        label->setTextFormat(Qt::RichText);
        label->setAttribute(Qt::WA_TransparentForMouseEvents);
        row->addWidget(label, label == text ? 1 : 0, Qt::AlignVCenter);
    }
}

QSize ChoiceButton::sizeHint() const { return layout()->sizeHint(); }
QSize ChoiceButton::minimumSizeHint() const { return layout()->minimumSize(); }

}  // namespace raytree::inspector
