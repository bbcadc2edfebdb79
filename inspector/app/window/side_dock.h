#pragma once

#include <QDockWidget>
#include <functional>

#include "state/state.h"

class QStackedWidget;
class QTabBar;

namespace raytree::inspector {

class ChangePane;
class ComparePane;
class StepsPane;

/// What stands beside the 3D view when it is asked for: steps, changes, differences.
class SideDock : public QDockWidget {
  public:
    SideDock(State& state, std::function<void(const std::string& command)> run,
             std::function<void(const InputError&)> fail, QWidget* parent);

    StepsPane& steps() const { return *steps_; }
    ChangePane& change() const { return *change_; }
    ComparePane& compare() const { return *compare_; }

    /// The one that is shown.
    QWidget* pane() const;

    QSize sizeHint() const override { return {330, 400}; }

  private:
    QWidget* make_title();
    void show_pane();

    State& state_;
    StepsPane* steps_ = nullptr;
    ChangePane* change_ = nullptr;
    ComparePane* compare_ = nullptr;
    QTabBar* tabs_ = nullptr;
    QStackedWidget* panes_ = nullptr;  ///< in the order of SidePane, without none
};

}  // namespace raytree::inspector
