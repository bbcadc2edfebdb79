#include "window/lesson_pane.h"

#include <QCoreApplication>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTextBrowser>
#include <QTimer>
#include <QVBoxLayout>
#include <utility>

#include "lesson/lesson_folder.h"
#include "window/lesson_html.h"
#include "window/lesson_list.h"
#include "window/qt_text.h"
#include "window/step_bar.h"

namespace raytree::inspector {
namespace {

QLabel* rich_label(const char* name) {
    auto* const label = new QLabel;
    label->setObjectName(QLatin1String(name));
    label->setTextFormat(Qt::RichText);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

}  // namespace

LessonPane::LessonPane(State& state, QuestionBox::Run run, QWidget* parent)
    : QStackedWidget(parent), state_(state), run_(std::move(run)) {
    setMinimumWidth(36 * fontMetrics().averageCharWidth());
    list_ = new QTextBrowser;
    list_->setOpenLinks(false);
    list_->setFrameShape(QFrame::NoFrame);
    list_->document()->setDocumentMargin(12);
    connect(list_, &QTextBrowser::anchorClicked, this,
            [this](const QUrl& to) { run_("lesson.open", to.path().toStdString()); });
    addWidget(list_);
    addWidget(make_page());
    state_.observe([this](const Changes& changes) { obey(changes); });
}

QPushButton* LessonPane::add_button(QLayout* row, const QString& text, const std::string& command) {
    auto* const button = new QPushButton(text);
    button->setFocusPolicy(Qt::TabFocus);
    connect(button, &QPushButton::clicked, this, [this, command] { run_(command, ""); });
    row->addWidget(button);
    return button;
}

QLayout* LessonPane::make_head() {
    auto* const rows = new QVBoxLayout;
    rows->setContentsMargins(12, 8, 12, 4);
    rows->setSpacing(3);
    auto* const row = new QHBoxLayout;
    lesson_ = rich_label("aside");
    place_ = new QLabel;
    place_->setObjectName(QStringLiteral("aside"));
    row->addWidget(lesson_, 1);
    row->addWidget(place_, 0, Qt::AlignTop);
    rows->addLayout(row);
    bar_ = new StepBar(state_);
    rows->addWidget(bar_);
    return rows;
}

QWidget* LessonPane::make_foot() {
    foot_ = new QWidget;
    foot_->setObjectName(QStringLiteral("lesson"));
    auto* const row = new QHBoxLayout(foot_);
    row->setContentsMargins(12, 6, 12, 8);
    back_ = add_button(row, {}, "lesson.back");
    back_->setAccessibleName(QStringLiteral("Back"));
    back_->setToolTip(QStringLiteral("To the step before  (F7)"));
    view_ = add_button(row, {}, "lesson.view");
    view_->setObjectName(QStringLiteral("quiet"));
    view_->setToolTip(QStringLiteral("Back to what the step shows  (F6)"));
    row->insertStretch(1, 1);
    row->addStretch(1);
    next_ = add_button(row, {}, "lesson.next");
    next_->setObjectName(QStringLiteral("onwards"));
    return foot_;
}

/// As many words as there is room for; those of the way onwards always.
void LessonPane::fit_foot() {
    constexpr std::pair<const char*, const char*> words[] = {
        {"◂ Back", "Lesson's view"}, {"◂", "Lesson's view"}, {"◂", "View"}};
    for (const auto& [back, view] : words) {
        back_->setText(QString::fromUtf8(back));
        view_->setText(QString::fromUtf8(view));
        foot_->layout()->invalidate();
        if (foot_->layout()->minimumSize().width() <= width()) {
            break;
        }
    }
}

void LessonPane::resizeEvent(QResizeEvent* event) {
    QStackedWidget::resizeEvent(event);
    fit_foot();
}

QWidget* LessonPane::make_page() {
    auto* const page = new QWidget;
    page->setObjectName(QStringLiteral("lesson"));
    auto* const rows = new QVBoxLayout(page);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addLayout(make_head());
    auto* const content = new QWidget;
    content->setObjectName(QStringLiteral("lesson"));
    auto* const column = new QVBoxLayout(content);
    column->setContentsMargins(12, 4, 12, 8);
    column->setSpacing(6);
    title_ = rich_label("step");
    text_ = rich_label("text");
    question_ = new QuestionBox(state_, run_);
    column->addWidget(title_);
    column->addWidget(text_);
    column->addWidget(question_);
    column->addStretch(1);
    scroll_ = new QScrollArea;
    scroll_->setObjectName(QStringLiteral("lesson"));
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll_->setWidgetResizable(true);
    scroll_->setWidget(content);
    rows->addWidget(scroll_, 1);
    rows->addWidget(make_foot());
    return page;
}

void LessonPane::obey(const Changes& changes) {
    if (changes.lesson || (changes.look && state_.lesson_side() != LessonSide::hidden)) {
        const bool lists = state_.lesson_side() == LessonSide::contents;
        setCurrentIndex(lists ? 0 : 1);
        lists ? show_list() : show_step();
    } else if ((changes.selection || changes.tree) && shows_step()) {
        question_->refresh();
    }
}

/// While the state goes on to another step its views change before the pane has that step's
/// question.
bool LessonPane::shows_step() const {
    const LessonRun* const run = state_.lesson();
    return run && run == shown_ && run->step() == step_;
}

void LessonPane::show_list() {
    const Palette& palette = palette_of(state_.look().theme);
    const LessonRun* const open = state_.lesson();
    try {
        const auto& folder = state_.lesson_folder();
        list_->setHtml(list_html(lessons_in(folder.empty() ? lesson::own_lessons() : folder),
                                 open ? open->lesson().name : "", palette));
    } catch (const InputError& error) {
        list_->setPlainText(QString::fromUtf8(error.what()));
    }
}

void LessonPane::show_step() {
    const LessonRun* const run = state_.lesson();
    const bool turned = run != shown_ || (run && run->step() != step_);
    shown_ = run;
    if (!run) {
        return;
    }
    step_ = run->step();
    const Palette& palette = palette_of(state_.look().theme);
    lesson_->setText(qt(run->lesson().title).toHtmlEscaped());
    place_->setText(QStringLiteral("%1 of %2").arg(step_ + 1).arg(run->count()));
    title_->setText(QStringLiteral("<b>%1</b>").arg(qt(run->here().title).toHtmlEscaped()));
    const LessonPage& page = run->page();
    text_->setText(page.failure.empty()
                       ? html_of(page.text, palette)
                       : QStringLiteral("<p><b>This step cannot be shown.</b></p><p>%1</p>")
                             .arg(qt(page.failure).toHtmlEscaped()));
    const bool last = step_ + 1 == run->count();
    next_->setText(last ? QStringLiteral("Next lesson ▸") : QStringLiteral("Next ▸"));
    fit_foot();
    bar_->update();
    const bool answered = run->answer() != nullptr;
    if (turned) {
        question_->renew();
        scroll_->verticalScrollBar()->setValue(0);
    } else {
        question_->refresh();
        if (answered && !answered_) {
            scroll_to_verdict();
        }
    }
    answered_ = answered;
}

/// Once it has its place.
void LessonPane::scroll_to_verdict() {
    QTimer::singleShot(0, this, [this] {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        if (QWidget* const verdict = question_->verdict()) {
            constexpr int margin = 12;
            scroll_->ensureWidgetVisible(verdict, 0, margin);
        }
    });
}

}  // namespace raytree::inspector
