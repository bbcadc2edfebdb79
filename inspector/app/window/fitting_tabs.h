#pragma once

#include <QStringList>
#include <QTabBar>

namespace raytree::inspector {

/// Tabs that are all there in a narrow pane too: their titles become short ones there, and are cut
/// where even those have no room. What is left out stands in the tooltips.
class FittingTabs : public QTabBar {
  public:
    FittingTabs();
    void add(const QString& title, const QString& brief);

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void fit();
    void write(const QStringList& titles);

    QStringList titles_, brief_;
};

}  // namespace raytree::inspector
