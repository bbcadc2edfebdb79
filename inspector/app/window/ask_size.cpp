#include "window/ask_size.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QSpinBox>

namespace raytree::inspector {

std::string ask_size(QWidget* parent) {
    QDialog dialog(parent);
    dialog.setWindowTitle(QStringLiteral("Size of the image"));
    auto* const layout = new QFormLayout(&dialog);
    QSpinBox* boxes[2];
    for (int k = 0; k < 2; ++k) {
        boxes[k] = new QSpinBox(&dialog);
        boxes[k]->setRange(64, 8192);
        boxes[k]->setSuffix(QStringLiteral(" px"));
        boxes[k]->setValue(k == 0 ? 1920 : 1080);
        layout->addRow(k == 0 ? QStringLiteral("&Width") : QStringLiteral("&Height"), boxes[k]);
    }
    auto* const buttons =
        new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, &dialog);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    layout->addRow(buttons);
    return dialog.exec() == QDialog::Accepted
               ? std::to_string(boxes[0]->value()) + "x" + std::to_string(boxes[1]->value())
               : std::string();
}

}  // namespace raytree::inspector
