#pragma once

#include <QWidget>

#include "state/palette.h"

namespace raytree::inspector {

/// A frame around the pane that a lesson talks about, laid over the window.
class PanelFrame : public QWidget {
    Q_OBJECT

  public:
    explicit PanelFrame(QWidget* window);

    /// Null: no frame.
    void put_around(QWidget* pane, Ink ink);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent*) override;

  private:
    void follow();

    QWidget* pane_ = nullptr;
    Ink ink_;
};

}  // namespace raytree::inspector
