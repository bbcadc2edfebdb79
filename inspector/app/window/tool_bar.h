#pragma once

#include <QToolBar>
#include <functional>
#include <string_view>

namespace raytree::inspector {

/// The commands that are used most, as buttons: with as many of their words as there is room for,
/// so that none falls off the window.
class ToolBar : public QToolBar {
    Q_OBJECT

  public:
    using ActionOf = std::function<QAction*(std::string_view command)>;
    ToolBar(const ActionOf& action_of, QWidget* parent);

    void changeEvent(QEvent* event) override;

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    /// How many buttons have words, those first that say the least without.
    enum class Words { all, modes, none };
    void fit();
    void show(Words words);
    void size_icons();
};

}  // namespace raytree::inspector
