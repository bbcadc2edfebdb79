#pragma once

#include <QWidget>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "state/state.h"

class QLabel;
class QPushButton;
class QTreeWidget;

namespace raytree::inspector {

class WrappedList;

/// What is different in two trees, where it begins first.
class ComparePane : public QWidget {
  public:
    /// `run` runs a command, having asked for what it wants to be told.
    ComparePane(State& state, std::function<void(const std::string& command)> run,
                QWidget* parent = nullptr);

    QTreeWidget* lines() const;
    QString summary() const;

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    QWidget* make_ways();
    QWidget* make_buttons();
    QPushButton* make_button(const std::string& command, const QString& title);
    void obey(const Changes& changes);
    void show_lines();
    void show_nothing();
    void show_selection();

    State& state_;
    std::function<void(const std::string&)> run_;
    QLabel *names_ = nullptr, *summary_ = nullptr, *remarks_ = nullptr, *legend_ = nullptr;
    QWidget *ways_ = nullptr, *buttons_ = nullptr;
    std::vector<std::pair<QPushButton*, std::string>> commands_;  ///< of each button
    WrappedList* lines_ = nullptr;
    bool following_ = false;    ///< while the selection is taken over from the state
    bool other_lines_ = false;  ///< since the pane was last seen
};

}  // namespace raytree::inspector
