#pragma once

#include <QObject>
#include <string>

#include "state/commands.h"

class QWidget;

namespace raytree::inspector {

/// Writes and copies what only the window has: its picture, itself, and its 3D view.
class Exporter : public QObject {
    Q_OBJECT

  public:
    Exporter(State& state, QWidget* window, QWidget* view);

  private:
    void obey(const Changes& changes);
    void write_picture(const std::string& file);

    State& state_;
    QWidget *window_, *view_;
};

/// A widget as it is drawn, in a PNG file's bytes.
std::string png_of(QWidget& widget);

/// Asks for the file that a command writes; empty to do nothing.
std::string ask_new_file(const State& state, const Command& command, QWidget* parent);

}  // namespace raytree::inspector
