#pragma once

#include <QIcon>
#include <QStringList>
#include <QTabBar>

namespace raytree::inspector {

/// Tabs that are all there in a narrow pane too: their titles become short ones there, and icons
/// where even those have no room. What is left out stands in the tooltips.
class FittingTabs : public QTabBar {
  public:
    FittingTabs();
    void add(const QString& title, const QString& brief);
    /// One for each tab.
    void set_icons(const QList<QIcon>& icons);

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void fit();
    void write(const QStringList& titles, bool with_icons);

    QStringList titles_, brief_;
    QList<QIcon> icons_;
};

}  // namespace raytree::inspector
