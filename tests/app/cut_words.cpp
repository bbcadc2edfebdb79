#include "app/cut_words.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QPushButton>
#include <QScrollBar>
#include <QTabBar>
#include <QTextBrowser>
#include <QToolButton>
#include <QTreeWidget>

namespace raytree::inspector::test {
namespace {

constexpr int arrow = 20;  // of a box to choose from

class Search {
  public:
    QStringList cut;

    void look_at(const QWidget& window) {
        look_at_all<QLabel>(window);
        look_at_all<QAbstractButton>(window);
        look_at_all<QTabBar>(window);
        look_at_all<QComboBox>(window);
        look_at_all<QLineEdit>(window);
        look_at_all<QTreeWidget>(window);
        look_at_all<QHeaderView>(window);
        look_at_all<QTextBrowser>(window);
        look_at_all<QMenuBar>(window);
    }

  private:
    template <class Widget> void look_at_all(const QWidget& window) {
        for (const Widget* const widget : window.findChildren<Widget*>()) {
            if (widget->isVisible()) {
                check(*widget);
            }
        }
    }

    void need(int wanted, int room, const QString& what) {
        if (wanted > room) {
            cut << QStringLiteral("%1: %2 pixels in %3").arg(what).arg(wanted).arg(room);
        }
    }

    void check(const QLabel& label) {
        if (label.wordWrap()) {
            need(label.heightForWidth(label.width()), label.height(), label.text());
        } else if (!label.text().isEmpty()) {
            need(label.sizeHint().width(), label.width(), label.text());
        }
    }

    void check(const QAbstractButton& button) {
        const auto* const tool = qobject_cast<const QToolButton*>(&button);
        if (!button.text().isEmpty() &&
            !(tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly)) {
            need(button.sizeHint().width(), button.width(), button.text());
        }
    }

    void check(const QTabBar& tabs) {
        for (int k = 0; k < tabs.count(); ++k) {
            const int wanted = tabs.fontMetrics().horizontalAdvance(tabs.tabText(k));
            need(wanted, tabs.tabRect(k).width(), tabs.tabText(k));
            need(tabs.tabRect(k).right(), tabs.width(), tabs.tabText(k));
        }
    }

    void check(const QComboBox& box) {
        need(box.fontMetrics().horizontalAdvance(box.currentText()) + arrow, box.width(),
             box.currentText());
    }

    void check(const QLineEdit& field) {
        need(field.fontMetrics().horizontalAdvance(field.text()), field.width() - 8, field.text());
    }

    void check(const QTreeWidget& list) {
        for (const QTreeWidgetItem* item = list.topLevelItem(0); item;
             item = list.itemBelow(item)) {
            for (int column = 0; column < list.columnCount(); ++column) {
                check(list, *item, column);
            }
        }
    }

    void check(const QTreeWidget& list, const QTreeWidgetItem& item, int column) {
        const QString text = item.text(column);
        const QVariant own = item.data(column, Qt::FontRole);
        const QFontMetrics metrics(own.isValid() ? own.value<QFont>() : list.font());
        const int width = list.columnWidth(column);
        if (list.wordWrap()) {
            const QRect room(0, 0, width - 6, 10'000);
            const int wanted = metrics.boundingRect(room, Qt::TextWordWrap, text).height();
            need(text.isEmpty() ? 0 : wanted, list.visualItemRect(&item).height(), text);
        } else {
            need(metrics.horizontalAdvance(text), width, text);
        }
    }

    void check(const QHeaderView& header) {
        for (int k = 0; header.orientation() == Qt::Horizontal && k < header.count(); ++k) {
            const QString text = header.model()->headerData(k, Qt::Horizontal).toString();
            QFont bold = header.font();
            bold.setBold(true);
            if (!header.isSectionHidden(k) && !text.isEmpty()) {
                need(QFontMetrics(bold).horizontalAdvance(text), header.sectionSize(k), text);
            }
        }
    }

    void check(const QTextBrowser& text) {
        need(text.horizontalScrollBar()->maximum(), 0, text.toPlainText().left(60));
    }

    void check(const QMenuBar& bar) {
        for (const QAction* const menu : bar.actions()) {
            if (bar.actionGeometry(const_cast<QAction*>(menu)).isEmpty()) {
                cut << menu->text() + QStringLiteral(": off the bar");
            }
        }
    }
};

}  // namespace

QStringList cut_words(const QWidget& window) {
    Search search;
    search.look_at(window);
    return search.cut;
}

}  // namespace raytree::inspector::test
