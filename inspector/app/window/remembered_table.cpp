#include "window/remembered_table.h"

#include <QSettings>
#include <QStringList>

#include "window/qt_text.h"

namespace raytree::inspector {
namespace {

const QString& key() {
    static const QString name = QStringLiteral("table/columns");
    return name;
}

constexpr const char *organisation = "raytree", *program = "inspector";

}  // namespace

void remember_table(State& state) {
    const QSettings kept(QString::fromUtf8(organisation), QString::fromUtf8(program));
    const QStringList words = kept.value(key()).toStringList();
    if (!words.isEmpty()) {
        Table table;
        table.columns = {Column::ray};
        for (const QString& word : words) {
            const auto column = column_from(word.toStdString());
            if (column && !table.has(*column)) {  // what another version knew is left out
                table.flip(*column);
            }
        }
        state.change_table(table);
    }
    state.observe([&state](const Changes& changes) {
        if (changes.table) {
            QStringList columns;
            for (const Column column : state.table().columns) {
                columns << qt(text_of(column).word);
            }
            QSettings(QString::fromUtf8(organisation), QString::fromUtf8(program))
                .setValue(key(), columns);
        }
    });
}

}  // namespace raytree::inspector
