#pragma once

#include <QObject>
#include <QWidget>
#include <string>

#include "state/commands.h"

namespace raytree::inspector {

class ScenePane;

/// Writes and copies what only the window has: its picture, itself, and its 3D view.
class Exporter : public QObject {
    Q_OBJECT

  public:
    Exporter(State& state, QWidget* window, ScenePane* view);

  private:
    void obey(const Changes& changes);
    void write_picture(const std::string& file);
    void write_view(const std::string& file_and_size);
    void write_image(const QImage& image, const std::string& file);

    State& state_;
    QWidget* window_;
    ScenePane* view_;
};

/// A widget as it is drawn, in a PNG file's bytes.
std::string png_of(QWidget& widget);
std::string png_of(const QImage& image);

/// Asks for what a command that writes a file takes; empty to do nothing.
std::string ask_new_file(const State& state, const Command& command, QWidget* parent);

}  // namespace raytree::inspector
