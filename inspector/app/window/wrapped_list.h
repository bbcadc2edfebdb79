#pragma once

#include <QTreeWidget>

namespace raytree::inspector {

/// A list one of whose columns is written out, over as many lines as that takes.
class WrappedList : public QTreeWidget {
  public:
    explicit WrappedList(int column, QWidget* parent = nullptr);

    /// To be called once lines have been added.
    void fit_rows();

  protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    int column_;
};

}  // namespace raytree::inspector
