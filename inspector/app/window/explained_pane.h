#pragma once

#include <QTextBrowser>

#include "state/explained_text.h"

namespace raytree::inspector {

/// What the features shown say in words and numbers, and the light's depth picture.
class ExplainedPane : public QTextBrowser {
    Q_OBJECT

  public:
    explicit ExplainedPane(State& state, QWidget* parent = nullptr);

  protected:
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void renew();
    QString html_of(const std::vector<ExplainedSection>& sections, bool below);

    State& state_;
    int shown_width_ = 0;  ///< for which the text has been laid out
};

}  // namespace raytree::inspector
