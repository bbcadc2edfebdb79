#include "window/step_bar.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

#include "window/qt_text.h"

namespace raytree::inspector {

StepBar::StepBar(State& state, QWidget* parent) : QWidget(parent), state_(state) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setCursor(Qt::PointingHandCursor);
    state_.observe([this](const Changes& changes) {
        if (changes.lesson || changes.look) {
            update();
        }
    });
}

QRectF StepBar::piece(std::size_t step) const {
    const double each = width() / static_cast<double>(state_.lesson()->count());
    const bool here = step == state_.lesson()->step();
    const double height = here ? 8 : 5;
    return {each * static_cast<double>(step) + 1, (this->height() - height) / 2, each - 2, height};
}

std::size_t StepBar::step_at(double x) const {
    const auto count = static_cast<double>(state_.lesson()->count());
    return static_cast<std::size_t>(std::clamp(std::floor(x / width() * count), 0.0, count - 1));
}

/// The step one is at is taller; steps gone through are filled.
void StepBar::paintEvent(QPaintEvent*) {
    if (!state_.lesson()) {
        return;
    }
    const Palette& palette = palette_of(state_.look().theme);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    for (std::size_t k = 0; k < state_.lesson()->count(); ++k) {
        const bool gone = k <= state_.lesson()->step();
        painter.setBrush(qt(gone ? palette.accent : palette.rule));
        painter.drawRoundedRect(piece(k), 2, 2);
    }
}

void StepBar::mousePressEvent(QMouseEvent* event) {
    if (state_.lesson()) {
        state_.go_to_lesson_step(step_at(event->localPos().x()));
    }
}

bool StepBar::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip && state_.lesson()) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const std::size_t step = step_at(help->pos().x());
        QToolTip::showText(help->globalPos(),
                           QStringLiteral("%1. %2").arg(step + 1).arg(
                               qt(state_.lesson()->lesson().steps[step].title)),
                           this);
        return true;
    }
    return QWidget::event(event);
}

}  // namespace raytree::inspector
