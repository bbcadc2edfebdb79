#include "window/cheat_sheet.h"

#include <QDialog>
#include <QHeaderView>
#include <QKeySequence>
#include <QLineEdit>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "state/commands.h"
#include "window/qt_text.h"

namespace raytree::inspector {
namespace {

/// What the mouse does has no place in the table of commands.
struct Gesture {
    const char *what, *how, *help;
};
constexpr Gesture gestures[] = {
    {"Choose a pixel", "click or drag", "In the picture."},
    {"Zoom", "wheel", "In the picture and in the 3D view."},
    {"Move", "right drag", "In the picture and in the 3D view; there also Shift and drag."},
    {"Turn", "drag", "In the 3D view."},
    {"Select a ray", "click", "In the 3D view and in the outline."},
};

void fill(QTreeWidget* list) {
    for (const Command& command : commands()) {
        QStringList keys;
        for (const QString& key : qt(command.keys).split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
            keys.push_back(QKeySequence(key).toString(QKeySequence::NativeText));
        }
        if (!keys.isEmpty()) {
            QString title = qt(command.title);
            list->addTopLevelItem(
                new QTreeWidgetItem({title, keys.join(QStringLiteral(", ")), qt(command.help)}));
        }
    }
    for (const Gesture& gesture : gestures) {
        list->addTopLevelItem(
            new QTreeWidgetItem({QString::fromUtf8(gesture.what), QString::fromUtf8(gesture.how),
                                 QString::fromUtf8(gesture.help)}));
    }
}

void filter(QTreeWidget* list, const QString& text) {
    for (int k = 0; k < list->topLevelItemCount(); ++k) {
        QTreeWidgetItem* const item = list->topLevelItem(k);
        bool found = false;
        for (int column = 0; column < 3; ++column) {
            found = found || item->text(column).contains(text, Qt::CaseInsensitive);
        }
        item->setHidden(!found);
    }
}

}  // namespace

void show_cheat_sheet(QWidget* parent) {
    auto* const dialog = new QDialog(parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(QStringLiteral("Keys and commands"));
    dialog->resize(680, 620);
    auto* const search = new QLineEdit(dialog);
    search->setPlaceholderText(QStringLiteral("Search"));
    search->setClearButtonEnabled(true);
    auto* const list = new QTreeWidget(dialog);
    list->setHeaderLabels(
        {QStringLiteral("Command"), QStringLiteral("Key"), QStringLiteral("What it does")});
    list->setRootIsDecorated(false);
    fill(list);
    list->resizeColumnToContents(0);
    list->resizeColumnToContents(1);
    QObject::connect(search, &QLineEdit::textChanged, list,
                     [list](const QString& text) { filter(list, text); });
    auto* const layout = new QVBoxLayout(dialog);
    layout->addWidget(search);
    layout->addWidget(list);
    dialog->show();
}

}  // namespace raytree::inspector
