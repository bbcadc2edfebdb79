#pragma once

#include <QLabel>

namespace raytree::inspector {

/// One line that says as much as there is room for: the longest of its texts that fits; where none
/// does, the shortest, cut. What is left out stands in the tooltip.
class FittingLabel : public QLabel {
  public:
    /// The same from the longest to the shortest; none for an empty line.
    void set_texts(const QStringList& texts);

    /// As the longest text wants it.
    QSize sizeHint() const override { return wanted_; }
    QSize minimumSizeHint() const override { return {0, wanted_.height()}; }

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void fit();

    QStringList texts_;
    QSize wanted_;
};

}  // namespace raytree::inspector
