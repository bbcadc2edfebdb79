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

/// What is different in two trees, where it begins first.
class ComparePane : public QWidget {
  public:
    /// `run` runs a command, having asked for what it wants to be told.
    ComparePane(State& state, std::function<void(const std::string& command)> run,
                QWidget* parent = nullptr);

    QTreeWidget* lines() const { return lines_; }
    QString summary() const;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    QWidget* make_ways();
    QWidget* make_buttons();
    QPushButton* make_button(const std::string& command, const QString& title);
    void obey(const Changes& changes);
    void show_lines();
    void show_nothing();
    void show_selection();
    void fit_rows();

    State& state_;
    std::function<void(const std::string&)> run_;
    QLabel *names_ = nullptr, *summary_ = nullptr, *remarks_ = nullptr, *legend_ = nullptr;
    QWidget *ways_ = nullptr, *buttons_ = nullptr;
    std::vector<std::pair<QPushButton*, std::string>> commands_;  ///< of each button
    QTreeWidget* lines_ = nullptr;
    bool following_ = false;
};

}  // namespace raytree::inspector
