#pragma once

#include <QImage>
#include <QTextBrowser>

#include "state/explained_text.h"

namespace raytree::inspector {

/// What the features shown say in words and numbers, with the pictures that belong to them.
class ExplainedPane : public QTextBrowser {
    Q_OBJECT

  public:
    explicit ExplainedPane(State& state, QWidget* parent = nullptr);

  protected:
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void renew();
    void bring_along(int scrolled);
    QString html_of(const std::vector<ExplainedSection>& sections, bool below);
    QImage picture_of(ExplainedSection::Picture picture) const;

    State& state_;
    int picture_room_ = 0;  ///< for a picture and its numbers
    QSize shown_size_;      ///< for which the text has been laid out
};

}  // namespace raytree::inspector
