#pragma once

#include <QStackedWidget>

#include "window/question_box.h"

class QScrollArea;
class QTextBrowser;

namespace raytree::inspector {

class StepBar;

/// The list of lessons, or a step of the open one: its text, its question, and the way on.
class LessonPane : public QStackedWidget {
    Q_OBJECT

  public:
    LessonPane(State& state, QuestionBox::Run run, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {330, 600}; }

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    QWidget* make_page();
    QLayout* make_head();
    QWidget* make_foot();
    QPushButton* add_button(QLayout* row, const QString& text, const std::string& command);
    void obey(const Changes& changes);
    void show_list();
    void show_step();
    void fit_foot();
    void scroll_to_verdict();
    bool shows_step() const;

    State& state_;
    QuestionBox::Run run_;
    QTextBrowser* list_ = nullptr;
    QScrollArea* scroll_ = nullptr;
    QLabel *lesson_ = nullptr, *place_ = nullptr, *title_ = nullptr, *text_ = nullptr;
    StepBar* bar_ = nullptr;
    QuestionBox* question_ = nullptr;
    QWidget* foot_ = nullptr;
    QPushButton *back_ = nullptr, *view_ = nullptr, *next_ = nullptr;
    const LessonRun* shown_ = nullptr;  ///< of whose step the pane was built
    std::size_t step_ = 0;
    bool answered_ = false;  ///< whether its question has been
};

}  // namespace raytree::inspector
