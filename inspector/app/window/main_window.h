#pragma once

#include <QMainWindow>

#include "window/picture_feed.h"

class QDockWidget;
class QLabel;
class QStackedWidget;
class QTabBar;

namespace raytree::inspector {

class Actions;
class CountsPane;
class FilterPane;
class FittingLabel;
class DetailsPane;
class DiagramPane;
class Files;
class LessonPane;
class OutlinePane;
class PanelFrame;
class PicturePane;
class ScenePane;
class SideDock;

/// The window: 3D view in the middle, picture and details at the left, the tree below:
/// as an outline, a diagram or counts.
class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    explicit MainWindow(State& state);

    PicturePane& picture_pane() const { return *picture_; }
    ScenePane& scene_pane() const { return *scene_; }
    OutlinePane& outline_pane() const { return *outline_; }
    DetailsPane& details_pane() const { return *details_; }
    DiagramPane& diagram_pane() const { return *diagram_; }
    CountsPane& counts_pane() const { return *counts_pane_; }
    LessonPane& lesson_pane() const { return *lesson_pane_; }
    FilterPane& filter_pane() const { return *filter_; }
    SideDock& side_dock() const { return *side_; }
    Files& files() const { return *files_; }
    const PictureFeed& feed() const { return feed_; }

    /// The scene or tree of a file; what goes wrong is shown in a dialog.
    void open(const QString& file);

    /// Whether there is somebody to answer questions: else what needs an answer throws InputError,
    /// and unsaved changes are dropped at the end.
    void set_asking(bool asks) { asks_ = asks; }

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    QDockWidget* add_dock(const QString& title, QWidget* widget, Qt::DockWidgetArea area);
    QWidget* make_picture_box();
    QWidget* make_centre();
    void add_tree_dock();
    void add_lesson_dock();
    void show_lesson();
    void share_room();
    void go_to_pane(int by);
    void colour_message();
    void show_message();
    void show_tab();
    void obey(const Changes& changes);
    void show_status();
    void show_hovered(std::optional<Pixel> pixel);
    QString ask_file(const QString& title);
    bool asks_ = true;
    void report(const InputError& error);

    State& state_;
    PictureFeed feed_;
    Theme theme_;
    Actions* actions_ = nullptr;
    Files* files_ = nullptr;
    SideDock* side_ = nullptr;
    PicturePane* picture_ = nullptr;
    ScenePane* scene_ = nullptr;
    OutlinePane* outline_ = nullptr;
    DetailsPane* details_ = nullptr;
    DiagramPane* diagram_ = nullptr;
    CountsPane* counts_pane_ = nullptr;
    LessonPane* lesson_pane_ = nullptr;
    PanelFrame* frame_ = nullptr;
    FilterPane* filter_ = nullptr;
    QTabBar* tabs_ = nullptr;
    QStackedWidget* tree_panes_ = nullptr;  ///< in the order of TreePane::Tab, as the tabs
    QDockWidget *picture_dock_ = nullptr, *details_dock_ = nullptr, *tree_dock_ = nullptr;
    QDockWidget* lesson_dock_ = nullptr;
    bool tall_tree_ = false;           ///< as the room is shared just now
    bool overlaid_ = false;            ///< whether room was left for an overlay's legend
    bool teaches_by_diagram_ = false;  ///< whether a lesson's step is about the whole of it
    QTimer message_due_;               ///< runs out when work takes long enough to say so
    QTimer working_;                   ///< runs while a tree or an explanation is to come
    QLabel* message_ = nullptr;
    FittingLabel *hovered_ = nullptr, *pixel_ = nullptr, *counts_ = nullptr;
};

}  // namespace raytree::inspector
