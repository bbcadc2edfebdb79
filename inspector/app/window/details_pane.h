#pragma once

#include <QTextBrowser>

#include "state/state.h"

namespace raytree::inspector {

/// Every number of the selected ray, to be read and copied.
class DetailsPane : public QTextBrowser {
  public:
    explicit DetailsPane(State& state, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {400, 360}; }

  private:
    void show_ray();

    State& state_;
};

}  // namespace raytree::inspector
