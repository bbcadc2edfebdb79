#pragma once

#include <QWidget>

#include "state/state.h"

namespace raytree::inspector {

/// How far one is in a lesson: a piece for each step. A click goes to the step.
class StepBar : public QWidget {
    Q_OBJECT

  public:
    explicit StepBar(State& state, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {200, 14}; }

  protected:
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;

  private:
    QRectF piece(std::size_t step) const;
    std::size_t step_at(double x) const;

    State& state_;
};

}  // namespace raytree::inspector
