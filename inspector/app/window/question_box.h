#pragma once

#include <QFrame>
#include <QTimer>

#include "state/state.h"

class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace raytree::inspector {

/// A step's question, the means to answer it, and what is said to the answer.
class QuestionBox : public QFrame {
    Q_OBJECT

  public:
    using Run = std::function<void(const std::string& command, const std::string& argument)>;

    /// `run`: runs a command; what goes wrong is told by it.
    QuestionBox(State& state, Run run, QWidget* parent = nullptr);

    /// Builds the question of the open lesson's step.
    void renew();
    /// What the picked pixel or ray would be as an answer, and what has been answered.
    void refresh();

  private:
    void add_input();
    void add_number(QVBoxLayout* rows);
    void add_choices(QVBoxLayout* rows);
    void add_picker(QVBoxLayout* rows);
    void add_value(QVBoxLayout* rows);
    QLabel* add_text(QVBoxLayout* rows, const QString& html);
    QPushButton* add_button(QLayout* row, const QString& text, const std::string& command);
    void answer(const std::string& words) { run_("lesson.answer", words); }
    QString verdict(const LessonAnswer& answer) const;
    QString picked() const;

    State& state_;
    Run run_;
    QWidget* content_ = nullptr;
    QLabel *result_ = nullptr, *picked_ = nullptr;
    QPushButton *take_ = nullptr, *tell_ = nullptr, *again_ = nullptr;
    QTimer trying_;  ///< runs out when the slider rests for a moment
    double tried_ = 0;
};

}  // namespace raytree::inspector
