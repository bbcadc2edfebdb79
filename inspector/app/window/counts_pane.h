#pragma once

#include <QTextBrowser>

#include "state/state.h"

namespace raytree::inspector {

/// How many rays there are, which were not sent and why, what that lost, and what the hierarchy
/// spared.
class CountsPane : public QTextBrowser {
  public:
    explicit CountsPane(State& state, QWidget* parent = nullptr);

  protected:
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void show_counts();

    State& state_;
    int shown_width_ = 0;  ///< for which the text has been laid out
};

}  // namespace raytree::inspector
