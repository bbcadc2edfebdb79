#pragma once

#include <QWidget>

#include "state/state.h"

class QLabel;
class QPushButton;
class QTreeWidget;

namespace raytree::inspector {

/// What is different in two trees, where it begins first.
class ComparePane : public QWidget {
  public:
    explicit ComparePane(State& state, QWidget* parent = nullptr);

    QTreeWidget* lines() const { return lines_; }
    QString summary() const;

  protected:
    void resizeEvent(QResizeEvent*) override { fit_rows(); }

  private:
    QWidget* make_buttons();
    void obey(const Changes& changes);
    void show_lines();
    void show_selection();
    void fit_rows();

    State& state_;
    QLabel *names_ = nullptr, *summary_ = nullptr, *remarks_ = nullptr, *legend_ = nullptr;
    QPushButton *swap_ = nullptr, *end_ = nullptr;
    QTreeWidget* lines_ = nullptr;
    bool following_ = false;
};

}  // namespace raytree::inspector
