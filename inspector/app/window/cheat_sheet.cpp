#include "window/cheat_sheet.h"

#include <QApplication>
#include <QDialog>
#include <QHeaderView>
#include <QKeyEvent>
#include <QKeySequence>
#include <QLineEdit>
#include <QVBoxLayout>
#include <algorithm>

#include "window/qt_text.h"
#include "window/wrapped_list.h"

namespace raytree::inspector {
namespace {

/// What the mouse does has no place in the table of commands.
struct Gesture {
    const char *what, *how, *help;
};
constexpr Gesture gestures[] = {
    {"Choose a pixel", "click or drag", "In the picture."},
    {"Zoom", "wheel", "In the picture, the 3D view and the diagram."},
    {"Move", "right drag",
     "In the picture, the 3D view and the diagram; in the 3D view Shift and drag, too, and in the "
     "diagram any drag."},
    {"Turn", "drag", "In the 3D view."},
    {"Select a ray", "click", "In the 3D view, the outline, the diagram and the other lists."},
    {"Select a light or an object", "click", "In the 3D view."},
};

enum ListColumn { title_column, key_column, menu_column, help_column };

void fill(QTreeWidget* list, const State& state) {
    for (const Command& command : commands()) {
        QStringList keys;
        for (const QString& key : qt(command.keys).split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
            keys.push_back(QKeySequence(key).toString(QKeySequence::NativeText));
        }
        const bool scripted = command.menu.empty();
        auto* const item = new QTreeWidgetItem(
            {scripted ? qt(command.id) : qt(command.title), keys.join(QStringLiteral(", ")),
             scripted ? QStringLiteral("scripts") : qt(command.menu), qt(command.help)});
        item->setData(title_column, Qt::UserRole, qt(command.id));
        item->setToolTip(title_column, qt(command.id));
        const bool possible = !scripted && (!command.possible || command.possible(state));
        for (int column = 0; column < list->columnCount() && !possible; ++column) {
            item->setForeground(column, list->palette().brush(QPalette::Disabled, QPalette::Text));
        }
        list->addTopLevelItem(item);
    }
    for (const Gesture& gesture : gestures) {
        list->addTopLevelItem(
            new QTreeWidgetItem({QString::fromUtf8(gesture.what), QString::fromUtf8(gesture.how),
                                 QStringLiteral("mouse"), QString::fromUtf8(gesture.help)}));
    }
}

void filter(QTreeWidget* list, const QString& text) {
    QTreeWidgetItem* first = nullptr;
    for (int k = 0; k < list->topLevelItemCount(); ++k) {
        QTreeWidgetItem* const item = list->topLevelItem(k);
        bool found = item->toolTip(title_column).contains(text, Qt::CaseInsensitive);
        for (int column = 0; column < list->columnCount(); ++column) {
            found = found || item->text(column).contains(text, Qt::CaseInsensitive);
        }
        item->setHidden(!found);
        first = found && !first ? item : first;
    }
    list->setCurrentItem(first);
}

/// Keys that move in the list do so from here.
class SearchLine : public QLineEdit {
  public:
    SearchLine(QTreeWidget* list, QWidget* parent) : QLineEdit(parent), list_(list) {}

  protected:
    void keyPressEvent(QKeyEvent* event) override {
        const int key = event->key();
        const bool moves = key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp ||
                           key == Qt::Key_PageDown;
        moves ? void(QApplication::sendEvent(list_, event)) : QLineEdit::keyPressEvent(event);
    }

  private:
    QTreeWidget* list_;
};

}  // namespace

void show_cheat_sheet(const State& state, QWidget* parent,
                      std::function<void(const Command&)> run) {
    auto* const dialog = new QDialog(parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(QStringLiteral("Keys and commands"));
    // What a command does is read to its end in a narrow window too.
    auto* const list = new WrappedList(help_column, dialog);
    auto* const search = new SearchLine(list, dialog);
    search->setPlaceholderText(QStringLiteral("Search; Return runs the command that is marked"));
    search->setAccessibleName(QStringLiteral("Search"));
    search->setClearButtonEnabled(true);
    list->setAccessibleName(QStringLiteral("Commands"));
    list->setHeaderLabels({QStringLiteral("Command"), QStringLiteral("Key"), QStringLiteral("Menu"),
                           QStringLiteral("What it does")});
    list->setFocusPolicy(Qt::NoFocus);  // whatever is typed is searched for
    fill(list, state);
    for (const int column : {title_column, key_column, menu_column}) {
        list->resizeColumnToContents(column);
    }
    list->fit_rows();
    const QFontMetrics metrics = dialog->fontMetrics();
    dialog->resize(std::min(metrics.averageCharWidth() * 150, parent->width() * 9 / 10),
                   std::min(metrics.height() * 38, parent->height() * 9 / 10));
    const auto run_item = [dialog, run = std::move(run)](const QTreeWidgetItem* item) {
        const Command* const command =
            item ? find_command(item->data(title_column, Qt::UserRole).toString().toStdString())
                 : nullptr;
        if (command && !command->menu.empty()) {
            dialog->close();
            run(*command);
        }
    };
    QObject::connect(search, &QLineEdit::textChanged, list,
                     [list](const QString& text) { filter(list, text); });
    QObject::connect(search, &QLineEdit::returnPressed, list,
                     [=] { run_item(list->currentItem()); });
    QObject::connect(list, &QTreeWidget::itemActivated, dialog, run_item);
    auto* const layout = new QVBoxLayout(dialog);
    layout->addWidget(search);
    layout->addWidget(list);
    dialog->show();
}

}  // namespace raytree::inspector
