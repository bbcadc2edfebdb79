#include "window/steps_pane.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QSlider>
#include <QStyle>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "state/commands.h"
#include "state/palette.h"
#include "window/actions.h"
#include "window/qt_text.h"

namespace raytree::inspector {
namespace {

QLabel* words() {
    auto* const label = new QLabel;
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

constexpr int waits_for_role = Qt::UserRole + 1;

/// Calls of two lines: the upper one has two columns, the lower one goes across both.
class CallList : public QTreeWidget {
  protected:
    void drawRow(QPainter* painter, const QStyleOptionViewItem& option,
                 const QModelIndex& index) const override {
        QTreeWidget::drawRow(painter, option, index);
        const int margin = 10;
        QRect below = option.rect.adjusted(margin, option.rect.height() / 2, 0, 0);
        below.setRight(viewport()->width());
        painter->setPen(
            palette().color(isEnabled() ? QPalette::Normal : QPalette::Disabled, QPalette::Text));
        painter->drawText(below, Qt::AlignLeft | Qt::AlignTop,
                          fontMetrics().elidedText(index.data(waits_for_role).toString(),
                                                   Qt::ElideRight, below.width()));
    }
};

}  // namespace

StepsPane::StepsPane(State& state, QWidget* parent)
    : QWidget(parent), state_(state), timer_(new QTimer(this)) {
    position_ = new QSlider(Qt::Horizontal);
    position_->setAccessibleName(QStringLiteral("Step"));
    place_ = words();
    place_->setObjectName(QStringLiteral("aside"));
    event_ = words();
    event_->setMinimumHeight(3 * fontMetrics().height());
    event_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    calls_title_ = words();
    calls_ = new CallList;
    calls_->setHeaderLabels({QStringLiteral("Open call"), QStringLiteral("sum so far")});
    calls_->setRootIsDecorated(false);
    calls_->setUniformRowHeights(true);
    calls_->header()->setStretchLastSection(false);
    calls_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    calls_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    calls_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(make_buttons());
    layout->addWidget(position_);
    layout->addWidget(place_);
    layout->addWidget(event_);
    layout->addWidget(calls_title_);
    layout->addWidget(calls_, 1);
    connect(position_, &QSlider::valueChanged, this, [this](int stop) {
        if (!following_) {
            state_.play(false);
            state_.go_to_stop(static_cast<std::size_t>(stop));
        }
    });
    connect(calls_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        if (item && !following_) {
            state_.select(item->data(0, Qt::UserRole).toULongLong());
        }
    });
    connect(timer_, &QTimer::timeout, this, [this] { state_.tick(); });
    state_.observe([this](const Changes& changes) { obey(changes); });
}

QToolButton* StepsPane::button(const char* command, int icon) {
    auto* const made = new QToolButton;
    const Command& of = *find_command(command);
    made->setProperty("sign", icon);
    made->setAccessibleName(qt(of.title));
    made->setToolTip(hint_of(of));
    connect(made, &QToolButton::clicked, this, [this, command] { run(command); });
    return made;
}

QWidget* StepsPane::make_buttons() {
    auto* const box = new QWidget;
    auto* const rows = new QVBoxLayout(box);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(2);
    auto* const layout = new QHBoxLayout;
    auto* const below = new QHBoxLayout;
    rows->addLayout(layout);
    rows->addLayout(below);
    layout->addWidget(button("step.first", QStyle::SP_MediaSkipBackward));
    layout->addWidget(button("step.back", QStyle::SP_MediaSeekBackward));
    play_ = button("step.play", QStyle::SP_MediaPlay);
    layout->addWidget(play_);
    layout->addWidget(button("step.forward", QStyle::SP_MediaSeekForward));
    layout->addWidget(button("step.last", QStyle::SP_MediaSkipForward));
    layout->addStretch(1);
    for (const auto& [command, title] :
         {std::pair("step.slower", "Slower"), std::pair("step.faster", "Faster"),
          std::pair("step.by_levels", "Levels")}) {
        QToolButton* const made = button(command, QStyle::SP_MediaPlay);
        made->setText(QString::fromUtf8(title));
        made->setToolButtonStyle(Qt::ToolButtonTextOnly);
        below->addWidget(made);
        if (find_command(command)->on) {
            made->setCheckable(true);
            state_.observe([this, made, command](const Changes&) {
                made->setChecked(find_command(command)->on(state_));
            });
        }
    }
    below->addStretch(1);
    return box;
}

/// The style's own signs, in the theme's colour.
void StepsPane::colour_signs() {
    const std::pair now(state_.look().theme, state_.playing());
    if (std::exchange(signs_of_, now) == now) {
        return;
    }
    const QColor ink = qt(palette_of(state_.look().theme).text);
    for (QToolButton* const made : findChildren<QToolButton*>()) {
        const bool plays = made == play_ && state_.playing();
        const int sign =
            plays ? static_cast<int>(QStyle::SP_MediaPause) : made->property("sign").toInt();
        if (made->text().isEmpty()) {
            QPixmap picture =
                style()->standardIcon(static_cast<QStyle::StandardPixmap>(sign)).pixmap(16, 16);
            QPainter painter(&picture);
            painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
            painter.fillRect(picture.rect(), ink);
            painter.end();
            made->setIcon(picture);
        }
    }
}

void StepsPane::run(const char* command) { run_command(state_, command); }

QString StepsPane::event() const { return event_->text(); }

void StepsPane::obey(const Changes& changes) {
    if (changes.playback || changes.tree || changes.look) {
        timer_->setInterval(static_cast<int>(1000 / state_.pace()));
        state_.playing() ? (timer_->isActive() ? void() : timer_->start()) : timer_->stop();
        stale_ = true;
        if (isVisible()) {
            renew();
        }
    }
}

void StepsPane::renew() {
    if (std::exchange(stale_, false)) {
        colour_signs();
        show_step();
    }
}

void StepsPane::show_step() {
    following_ = true;
    const auto& playback = state_.playback();
    position_->setEnabled(playback.has_value());
    calls_->setEnabled(playback.has_value());
    if (playback) {
        position_->setRange(0, static_cast<int>(playback->stops()) - 1);
        position_->setValue(static_cast<int>(playback->stop()));
        place_->setText(QStringLiteral("Step %1 of %2, %3 a second")
                            .arg(playback->stop() + 1)
                            .arg(playback->stops())
                            .arg(state_.pace()));
        event_->setText(qt(event_text(*playback)));
        show_calls(*playback);
    } else {
        position_->setRange(0, 0);
        place_->setText(QStringLiteral("The whole tree is shown."));
        event_->setText(
            QStringLiteral("Step forward (key .) to see it computed: rays go out, intensities fill "
                           "in when they come back."));
        calls_title_->clear();
        calls_->clear();
    }
    following_ = false;
}

void StepsPane::show_calls(const Playback& playback) {
    calls_->clear();
    const std::vector<CallText> texts = call_texts(playback);
    calls_title_->setText(
        playback.order() == StepOrder::depth_first
            ? QStringLiteral("Call stack, the innermost call below: %1 open").arg(texts.size())
            : QStringLiteral("Rays whose intensity is not known yet: %1").arg(texts.size()));
    for (const CallText& text : texts) {
        const QString waits = QStringLiteral("waits for ") + qt(text.waits_for);
        auto* const item =
            new QTreeWidgetItem(calls_, {qt(text.title) + QLatin1Char('\n'), qt(text.sum)});
        item->setData(0, waits_for_role, waits);
        item->setData(0, Qt::AccessibleTextRole, qt(text.title) + QLatin1Char(' ') + waits);
        item->setTextAlignment(1, Qt::AlignLeft | Qt::AlignTop);
        item->setData(0, Qt::UserRole, QVariant::fromValue<qulonglong>(text.ray));
        for (int column = 0; column < 2; ++column) {
            item->setToolTip(column, qt(text.title) + QLatin1Char('\n') + waits);
        }
        if (text.ray == playback.event().ray) {
            calls_->setCurrentItem(item);
        }
    }
    calls_->scrollToBottom();
}

}  // namespace raytree::inspector
