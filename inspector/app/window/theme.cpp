#include "window/theme.h"

#include <QApplication>
#include <QPainter>
#include <QPalette>
#include <QPointer>
#include <QProxyStyle>
#include <QStyleFactory>
#include <QStyleOption>
#include <QToolButton>
#include <QWidget>
#include <optional>

#include "window/qt_text.h"

namespace raytree::inspector {
namespace {

/// Fusion's boxes to tick are framed in a shade of the window's colour and what is behind the end
/// of a menu bar is told by black arrows, both invisible on a dark one.
class Style : public QProxyStyle {
  public:
    explicit Style(const Palette& palette)
        : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))), palette_(palette) {}
    void set_colours(const Palette& palette) { palette_ = palette; }

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override {
        if (element != PE_IndicatorItemViewItemCheck && element != PE_IndicatorCheckBox) {
            QProxyStyle::drawPrimitive(element, option, painter, widget);
            return;
        }
        const QRectF box = QRectF(option->rect).adjusted(1.5, 1.5, -1.5, -1.5);
        const bool enabled = option->state & State_Enabled;
        const QColor ink = qt(enabled ? palette_.text : palette_.dim_text);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(QPen(qt(palette_.dim_text), 1.2));
        painter->setBrush(qt(palette_.panel));
        painter->drawRoundedRect(box, 2, 2);
        if (option->state & State_On) {
            painter->setPen(QPen(ink, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
            painter->drawPolyline(
                QPolygonF({box.topLeft() + QPointF(0.22 * box.width(), 0.52 * box.height()),
                           box.topLeft() + QPointF(0.42 * box.width(), 0.74 * box.height()),
                           box.topLeft() + QPointF(0.8 * box.width(), 0.26 * box.height())}));
        } else if (option->state & State_NoChange) {
            painter->fillRect(QRectF(box.left() + 2.5, box.center().y() - 1, box.width() - 5, 2),
                              ink);
        }
        painter->restore();
    }

    /// Disabled words are not written a second time, one pixel off.
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* more) const override {
        return hint == SH_EtchDisabledText ? 0 : QProxyStyle::styleHint(hint, option, widget, more);
    }

    QIcon standardIcon(StandardPixmap which, const QStyleOption* option,
                       const QWidget* widget) const override {
        if (which != SP_ToolBarHorizontalExtensionButton) {
            return QProxyStyle::standardIcon(which, option, widget);
        }
        QPixmap arrows(64, 64);
        arrows.fill(Qt::transparent);
        QPainter painter(&arrows);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(qt(palette_.text), 7, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        for (const int x : {14, 36}) {
            painter.drawPolyline(QPolygon({{x, 14}, {x + 16, 32}, {x, 50}}));
        }
        return arrows;
    }

  private:
    Palette palette_;
};

/// Qt asks for the icon of a bar's button once.
void renew_arrows(const QStyle& style) {
    for (QWidget* widget : QApplication::allWidgets()) {
        auto* button = qobject_cast<QToolButton*>(widget);
        if (button && (button->objectName() == QLatin1String("qt_menubar_ext_button") ||
                       button->objectName() == QLatin1String("qt_toolbar_ext_button"))) {
            button->setIcon(style.standardIcon(QStyle::SP_ToolBarHorizontalExtensionButton));
        }
    }
}

/// While it lives, a new style sheet changes what widgets look like and not how large they are:
/// none is to lay itself out anew, which takes most of the time.
class KeepsSizes : public QObject {
  public:
    KeepsSizes() { qApp->installEventFilter(this); }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::StyleChange || !watched->isWidgetType()) {
            return false;
        }
        static_cast<QWidget*>(watched)->update();
        return true;
    }
};

QString css(Ink ink) { return qt(ink).name(); }

QString style_sheet(const Palette& p) {
    QString sheet = QStringLiteral(R"(
QMainWindow::separator { background: @window; width: 6px; height: 6px; }
QDockWidget { color: @dim; font-weight: bold; }
QDockWidget::title { background: @window; padding: 5px 4px 4px 6px; text-align: left; }
QTabBar { font-weight: bold; }
QTabBar::tab { background: transparent; color: @dim; padding: 4px 8px 3px 8px;
               border-bottom: 2px solid transparent; }
QTabBar::tab:hover { color: @text; }
QTabBar::tab:selected { color: @text; border-bottom-color: @accent; }
QTabBar::tab:focus { background: @checked; }
QToolBar { background: @window; border: none; border-bottom: 1px solid @rule; padding: 3px 6px;
           spacing: 1px; }
QToolBar::separator { background: @rule; width: 1px; margin: 5px 3px; }
QToolButton { color: @text; border: 1px solid transparent; border-radius: 4px; padding: 3px 4px; }
QToolButton:hover { background: @hover; }
QToolButton:pressed, QToolButton:checked { background: @checked; border-color: @rule; }
QToolButton:disabled { color: @faint; }
QMenuBar { background: @window; color: @text; }
QMenuBar::item { background: transparent; padding: 4px 7px; border-radius: 4px; }
QMenuBar::item:selected { background: @checked; }
QStatusBar { background: @window; color: @text; border-top: 1px solid @rule; }
QStatusBar::item { border: none; }
QStatusBar QLabel { color: @text; padding: 1px 8px; }
QTreeView, QTextBrowser { background: @panel; color: @text; border: 1px solid @rule; }
QTreeView { selection-background-color: @selected; selection-color: @text; }
QTreeView::item { padding: 1px 4px 1px 2px; }
QHeaderView::section { background: @window; color: @dim; border: none;
                       border-bottom: 1px solid @rule; padding: 4px 6px; font-weight: bold; }
QLabel#aside { color: @dim; }
QWidget#lesson, QWidget#lesson > QWidget > QWidget#lesson { background: @panel; }
QLabel#step { font-size: large; }
QFrame#question { background: @asking; border: 1px solid @rule; border-radius: 6px; }
QFrame#question QLabel { background: transparent; border: none; }
QPushButton { color: @text; background: @panel; border: 1px solid @rule; border-radius: 4px;
              padding: 4px 11px; }
QPushButton:hover { background: @hover; }
QPushButton:pressed { background: @checked; }
QPushButton:focus { border-color: @accent; }
QPushButton:disabled { color: @faint; }
QPushButton#onwards { background: @accent; color: @panel; border-color: @accent;
                      font-weight: bold; }
QPushButton#quiet { background: transparent; border-color: transparent; color: @accent;
                    padding: 4px 6px; }
QPushButton#quiet:hover, QPushButton#quiet:focus { border-color: @rule; }
QPushButton#choice { padding: 0; text-align: left; }

QToolTip { background: @panel; color: @text; border: 1px solid @rule; padding: 3px; }
)");
    const std::pair<const char*, Ink> names[] = {
        {"@window", p.window},
        {"@panel", p.panel},
        {"@text", p.text},
        {"@dim", p.dim_text},
        {"@rule", p.rule},
        {"@accent", p.accent},
        {"@hover", mixed(p.window, p.text, 0.06)},
        {"@checked", mixed(p.window, p.accent, 0.2)},
        {"@selected", mixed(p.panel, p.selection, 0.2)},
        {"@asking", mixed(p.panel, p.accent, 0.07)},
        {"@faint", mixed(p.window, p.dim_text, 0.5)},
    };
    for (const auto& [name, ink] : names) {
        sheet.replace(QLatin1String(name), css(ink));
    }
    return sheet;
}

}  // namespace

void apply_theme(const Palette& p) {
    // The same style stays: another one has every widget polished once more.
    static QPointer<QProxyStyle> style;
    std::optional<KeepsSizes> keeps;
    if (style) {
        keeps.emplace();
        static_cast<Style*>(style.data())->set_colours(p);
    } else {
        QApplication::setStyle(style = new Style(p));
    }
    QPalette colours;
    colours.setColor(QPalette::Window, qt(p.window));
    colours.setColor(QPalette::WindowText, qt(p.text));
    colours.setColor(QPalette::Base, qt(p.panel));
    colours.setColor(QPalette::AlternateBase, qt(mixed(p.panel, p.window, 0.5)));
    colours.setColor(QPalette::Text, qt(p.text));
    colours.setColor(QPalette::Button, qt(p.window));
    colours.setColor(QPalette::ButtonText, qt(p.text));
    colours.setColor(QPalette::ToolTipBase, qt(p.panel));
    colours.setColor(QPalette::ToolTipText, qt(p.text));
    colours.setColor(QPalette::Highlight, qt(p.accent));
    colours.setColor(QPalette::HighlightedText, qt(p.panel));
    colours.setColor(QPalette::Link, qt(p.accent));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        colours.setColor(QPalette::Disabled, role, qt(mixed(p.window, p.dim_text, 0.5)));
    }
    QApplication::setPalette(colours);
    qApp->setStyleSheet(style_sheet(p));
    renew_arrows(*style);
}

}  // namespace raytree::inspector
