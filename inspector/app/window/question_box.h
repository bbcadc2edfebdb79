#pragma once

#include <QFrame>
#include <QTimer>

#include "state/state.h"

class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSlider;
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
    /// What has been answered, and the value as the scene has it.
    void refresh();
    /// What is said to the answer; null where nothing is asked.
    QWidget* verdict() const;

  private:
    void add_input();
    void add_number(QVBoxLayout* rows);
    void add_choices(QVBoxLayout* rows);
    void add_picker(QVBoxLayout* rows);
    void add_value(QVBoxLayout* rows);
    QLabel* add_text(QVBoxLayout* rows, const QString& html);
    QPushButton* add_button(QLayout* row, const QString& text, const std::string& command);
    void answer(const std::string& words) { run_("lesson.answer", words); }
    void move_slider(double value);
    void show_value();
    QString verdict_of(const LessonAnswer& answer) const;

    State& state_;
    Run run_;
    QWidget* content_ = nullptr;
    QLabel* result_ = nullptr;
    QPushButton *tell_ = nullptr, *again_ = nullptr;
    QLineEdit* number_ = nullptr;
    QSlider* slider_ = nullptr;  ///< of a value, as is the field
    QDoubleSpinBox* field_ = nullptr;
    QTimer trying_;  ///< runs out when the slider rests for a moment
    double tried_ = 0;
    Theme theme_ = Theme::light;  ///< in whose colours the texts are
};

}  // namespace raytree::inspector
