#pragma once

#include <QWidget>
#include <optional>
#include <utility>

#include "state/state.h"

class QLabel;
class QSlider;
class QTimer;
class QToolButton;
class QTreeWidget;

namespace raytree::inspector {

/// Stepping through the tree: what has just happened, and the calls that are open.
class StepsPane : public QWidget {
  public:
    explicit StepsPane(State& state, QWidget* parent = nullptr);

    QTreeWidget* calls() const { return calls_; }
    QSlider* position() const { return position_; }
    QString event() const;

  protected:
    void showEvent(QShowEvent*) override { renew(); }

  private:
    QWidget* make_buttons();
    QToolButton* button(const char* command, int icon);
    void run(const char* command);
    void obey(const Changes& changes);
    void renew();
    void colour_signs();
    void show_step();
    void show_calls(const Playback& playback);

    State& state_;
    QTimer* timer_;
    QSlider* position_ = nullptr;
    QToolButton* play_ = nullptr;
    QLabel *place_ = nullptr, *event_ = nullptr, *calls_title_ = nullptr;
    QTreeWidget* calls_ = nullptr;
    bool following_ = false;  ///< the pane follows the state, not the hand
    bool stale_ = true;       ///< something has changed since the pane was seen
    std::optional<std::pair<Theme, bool>> signs_of_;  ///< and of a tree that plays, or does not
};

}  // namespace raytree::inspector
