#pragma once

#include <QTextBrowser>

#include "state/state.h"

namespace raytree::inspector {

/// What the features shown say in words and numbers, and the light's depth picture.
class ExplainedPane : public QTextBrowser {
    Q_OBJECT

  public:
    explicit ExplainedPane(State& state, QWidget* parent = nullptr);

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    void renew();

    State& state_;
};

}  // namespace raytree::inspector
