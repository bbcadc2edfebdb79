#include "window/question_box.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>
#include <cmath>

#include "tree/explain.h"
#include "window/choice_button.h"
#include "window/lesson_html.h"
#include "window/qt_text.h"

namespace raytree::inspector {
namespace {

using lesson::AskKind;

constexpr int slider_steps = 200;

}  // namespace

QuestionBox::QuestionBox(State& state, Run run, QWidget* parent)
    : QFrame(parent), state_(state), run_(std::move(run)) {
    setObjectName(QStringLiteral("question"));
    auto* const outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    trying_.setSingleShot(true);
    trying_.setInterval(120);
    connect(&trying_, &QTimer::timeout, this, [this] { state_.try_value(tried_); });
}

QWidget* QuestionBox::verdict() const { return result_; }

QLabel* QuestionBox::add_text(QVBoxLayout* rows, const QString& html) {
    auto* const label = new QLabel(html);
    label->setTextFormat(Qt::RichText);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    rows->addWidget(label);
    return label;
}

QPushButton* QuestionBox::add_button(QLayout* row, const QString& text,
                                     const std::string& command) {
    auto* const button = new QPushButton(text);
    connect(button, &QPushButton::clicked, this, [this, command] { run_(command, ""); });
    row->addWidget(button);
    return button;
}

void QuestionBox::renew() {
    trying_.stop();
    delete content_;
    content_ = nullptr;
    result_ = nullptr;
    tell_ = again_ = nullptr;
    number_ = nullptr;
    slider_ = nullptr;
    field_ = nullptr;
    const LessonRun* const run = state_.lesson();
    setVisible(run && run->here().ask);
    if (!run || !run->here().ask) {
        return;
    }
    theme_ = state_.look().theme;
    const Palette& palette = palette_of(theme_);
    content_ = new QWidget;
    layout()->addWidget(content_);
    auto* const rows = new QVBoxLayout(content_);
    rows->setContentsMargins(10, 8, 10, 9);
    rows->setSpacing(6);
    add_text(rows,
             QStringLiteral("<b style='color:%1'>Your turn</b>").arg(qt(palette.accent).name()));
    add_text(rows, html_of(run->page().question, palette));
    add_input();
    auto* const buttons = new QHBoxLayout;
    tell_ = add_button(buttons, QStringLiteral("Show me"), "lesson.tell");
    again_ = add_button(buttons, QStringLiteral("Ask me again"), "lesson.again");
    for (QPushButton* const button : {tell_, again_}) {
        button->setObjectName(QStringLiteral("quiet"));
    }
    again_->hide();
    buttons->addStretch(1);
    rows->addLayout(buttons);
    result_ = add_text(rows, {});
    result_->setObjectName(QStringLiteral("verdict"));
    refresh();
}

void QuestionBox::add_input() {
    auto* const rows = static_cast<QVBoxLayout*>(content_->layout());
    switch (state_.lesson()->here().ask->kind) {
        case AskKind::number:
            return add_number(rows);
        case AskKind::choice:
            return add_choices(rows);
        case AskKind::value:
            return add_value(rows);
        default:
            return add_picker(rows);
    }
}

void QuestionBox::add_number(QVBoxLayout* rows) {
    auto* const row = new QHBoxLayout;
    auto* const field = new QLineEdit;
    const double tolerance = state_.lesson()->here().ask->tolerance;
    const QString wanted = tolerance > 0
                               ? QStringLiteral("a number, ± %1").arg(qt(number_text(tolerance)))
                               : QStringLiteral("an exact number");
    field->setPlaceholderText(wanted);
    field->setAccessibleName(QStringLiteral("Your answer, ") + wanted);
    number_ = field;
    auto* const button = new QPushButton(QStringLiteral("Answer"));
    button->setEnabled(false);
    connect(field, &QLineEdit::textChanged, button, [button](const QString& text) {
        bool good = false;
        text.trimmed().replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&good);
        button->setEnabled(good);
    });
    const auto give = [this, field] {
        answer(field->text().trimmed().replace(QLatin1Char(','), QLatin1Char('.')).toStdString());
    };
    connect(button, &QPushButton::clicked, this, give);
    connect(field, &QLineEdit::returnPressed, button, &QPushButton::click);
    row->addWidget(field, 1);
    if (const std::string& unit = state_.lesson()->here().ask->unit; !unit.empty()) {
        row->addWidget(new QLabel(qt(unit)));
    }
    row->addWidget(button);
    rows->addLayout(row);
}

void QuestionBox::add_choices(QVBoxLayout* rows) {
    const Palette& palette = palette_of(state_.look().theme);
    const auto& options = state_.lesson()->page().options;
    for (std::size_t k = 0; k < options.size(); ++k) {
        const std::string letter(1, static_cast<char>('a' + k));
        auto* const button =
            new ChoiceButton(qt(letter), html_of(options[k], palette), qt(plain_text(options[k])));
        connect(button, &QPushButton::clicked, this, [this, letter] { answer(letter); });
        rows->addWidget(button);
    }
}

void QuestionBox::add_picker(QVBoxLayout* rows) {
    const bool pixel = state_.lesson()->here().ask->kind == AskKind::pixel;
    add_text(rows, pixel ? QStringLiteral("<i>Click it in the picture.</i>")
                         : QStringLiteral("<i>Click it in any view.</i>"));
}

void QuestionBox::add_value(QVBoxLayout* rows) {
    const lesson::Ask& ask = *state_.lesson()->here().ask;
    slider_ = new QSlider(Qt::Horizontal);
    field_ = new QDoubleSpinBox;
    const int steps = ask.whole ? static_cast<int>(ask.to - ask.from) : slider_steps;
    const double each = (ask.to - ask.from) / std::max(steps, 1);
    slider_->setRange(0, steps);
    field_->setRange(ask.from, ask.to);
    field_->setDecimals(ask.whole ? 0 : std::max(2, 2 - static_cast<int>(std::log10(each))));
    field_->setSingleStep(each);
    field_->setSuffix(qt(ask.unit));
    connect(slider_, &QSlider::valueChanged, field_,
            [field = field_, each, from = ask.from](int at) { field->setValue(from + each * at); });
    connect(field_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double value) {
        move_slider(value);
        tried_ = value;
        trying_.start();
    });
    auto* const button = new QPushButton(QStringLiteral("Answer"));
    connect(button, &QPushButton::clicked, this, [this] {
        trying_.stop();  // an answer is shown at once
        answer(QString::number(field_->value(), 'g', 15).toStdString());
    });
    rows->addWidget(slider_);
    auto* const row = new QHBoxLayout;
    row->addWidget(field_, 1);
    row->addWidget(button);
    rows->addLayout(row);
}

/// To a value that did not come from the slider.
void QuestionBox::move_slider(double value) {
    const lesson::Ask& ask = *state_.lesson()->here().ask;
    const QSignalBlocker quiet(slider_);
    slider_->setValue(static_cast<int>(
        std::lround((value - ask.from) / (ask.to - ask.from) * slider_->maximum())));
}

/// Slider and field as the scene has it, unless they are just being moved.
void QuestionBox::show_value() {
    if (trying_.isActive()) {
        return;
    }
    if (const double value = state_.value_tried(); field_->value() != value) {
        const QSignalBlocker quiet(field_);
        field_->setValue(value);
    }
    move_slider(field_->value());
}

void QuestionBox::refresh() {
    if (!content_) {
        return;
    }
    if (theme_ != state_.look().theme) {  // its texts have their colours in them
        const QString typed = number_ ? number_->text() : QString();
        renew();
        if (number_) {
            number_->setText(typed);
        }
        return;
    }
    if (field_) {
        show_value();
    }
    const LessonAnswer* const given = state_.lesson()->answer();
    if (number_ && given && given->given.is_number() && number_->text().isEmpty()) {
        number_->setText(QString::number(given->given.get<double>(), 'g', 10));
    }
    if (number_ && !given && again_->isVisibleTo(this)) {  // asked again: nothing is typed yet
        number_->clear();
        number_->setFocus();
    }
    tell_->setVisible(!given);
    again_->setVisible(given != nullptr);
    result_->setVisible(given != nullptr);
    if (given) {
        result_->setText(verdict_of(*given));
    }
}

/// Right or wrong by a mark and words, then the truth, and why.
QString QuestionBox::verdict_of(const LessonAnswer& answer) const {
    const Palette& palette = palette_of(state_.look().theme);
    const QString truth = qt(answer.truth).toHtmlEscaped();
    QString html;
    const auto line = [&](const QString& text) {
        html += QStringLiteral("<p style='margin:0 0 5px 0'>%1</p>").arg(text);
    };
    if (answer.given.is_null()) {
        line(QStringLiteral("The answer: <b>%1</b>").arg(truth));
    } else {
        const QString words = qt(answer.words).toHtmlEscaped();
        line(answer.right ? QStringLiteral("<b>✓&nbsp;Right:</b> %1").arg(words)
                          : QStringLiteral("<b>✗&nbsp;Not quite:</b> %1").arg(words));
        if (!answer.right) {
            html += html_of(answer.hint, palette);
            line(QStringLiteral("The answer: <b>%1</b>").arg(truth));
        }
    }
    return html + html_of(answer.after, palette);
}

}  // namespace raytree::inspector
