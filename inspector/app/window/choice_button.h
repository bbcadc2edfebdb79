#pragma once

#include <QPushButton>

class QLabel;

namespace raytree::inspector {

/// A button whose text is rich and may take several lines.
class ChoiceButton : public QPushButton {
    Q_OBJECT

  public:
    ChoiceButton(const QString& letter, const QString& html, const QString& plain,
                 QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
};

}  // namespace raytree::inspector
