#pragma once

#include <QPixmap>
#include <QTimer>
#include <QWidget>
#include <initializer_list>
#include <memory>

#include "drawing/extent.h"
#include "drawing/ray_paths.h"
#include "drawing/scene_mesh.h"
#include "drawing/words.h"
#include "state/newest_work.h"
#include "view3d/scene_drawing.h"
#include "window/picture_feed.h"
#include "window/scene_labels.h"

namespace raytree::inspector {

class SceneCanvas;
class SceneOverlay;

/// The 3D view: dragging turns it about, with the right button or Shift moves it, the wheel zooms,
/// a click selects a ray, a light, or an object.
class ScenePane : public QWidget {
    Q_OBJECT

  public:
    ScenePane(State& state, PictureFeed& feed, QWidget* parent = nullptr);
    ~ScenePane() override;

    /// Where a point is in the pane; none behind the viewer.
    std::optional<QPointF> place_of(const Point3& p) const;
    const std::vector<RayPath>& paths() const { return paths_; }
    const View& view() const { return view_; }
    /// How many frames have been drawn.
    int frames() const { return frames_; }
    /// Whether the last of them shows everything as it is now, many shapes roughly, and the picture
    /// as it may have been.
    bool is_current() const { return !stale_ && !meshing_ && shown_ >= current_; }
    /// Whether it shows them as they are, too.
    bool has_shapes() const { return is_current() && !rough_; }
    /// Whether no more than rays was drawn for it, over shapes that had stood still.
    bool keeps() const { return is_current() && keeps_; }
    /// Asks for a frame with everything as it is now.
    void draw_again() { redraw(); }
    /// Waits for that frame.
    void catch_up();
    /// What the pane shows, drawn at another size.
    QImage image(QSize size);
    /// An image of a widget that holds the view, which shows all shapes as they are.
    QPixmap grabbed(QWidget& widget);
    /// From how many triangles and lines on shapes are drawn roughly at first.
    void set_many(int many);

  Q_SIGNALS:
    /// A frame is on the screen.
    void drawn();

  protected:
    void resizeEvent(QResizeEvent*) override;
    void showEvent(QShowEvent*) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    using Shapes = std::shared_ptr<const SceneMesh>;
    /// A frame to be drawn, and what is written over it.
    struct Described {
        SceneFrame frame;
        std::vector<SceneLabel> labels;
        std::vector<WordLine> lines;
    };

    void obey(const Changes& changes);
    void obey(Request request);
    void take_document();
    void take_tree();
    /// None where there is no such view.
    std::optional<View> asked_view(Request request) const;
    std::optional<View> moved_view(Request request) const;
    std::vector<RayPath> whole_tree() const;
    std::vector<Point3> selected_points() const;
    void change_view(const View& view);
    /// Only solid shapes are.
    View cut_open(View view) const;
    void show_notes();
    void make_mesh(double pixel);
    bool take_mesh(std::chrono::milliseconds patience);
    Shapes shapes_for(const View& view);
    QImage drawn_whole(const SceneFrame& frame);
    PicturePlace picture_place(const View& view) const;
    Described describe(const View& view, const Shapes& shapes) const;
    SceneThings things(const View& view, const SceneMesh& shapes) const;
    std::vector<WordLine> ray_lines(const View& view) const;
    bool looks_from_the_eye(const View& view) const;
    void redraw();
    void begin_frame();
    void ask_for_frame();
    void take_frames();
    void show_frame(const DrawnFrame& frame);
    void drag(QPointF by, bool move);
    void click(QPointF at);
    void show_hint(QPointF at, QPoint global);
    std::optional<std::size_t> ray_at(QPointF at) const;
    std::optional<Thing> thing_at(QPointF at) const;

    State& state_;
    PictureFeed& feed_;
    SceneCanvas* canvas_ = nullptr;
    SceneOverlay* overlay_ = nullptr;
    View view_;
    Extent extent_;
    Shapes mesh_ = std::make_shared<SceneMesh>();
    std::shared_ptr<const ShownPicture> picture_;
    std::vector<RayPath> paths_;
    std::vector<RayPath> beside_;  ///< of the pixels around
    double mesh_pixel_ = 0;        ///< for which mesh_ has been made, or is being made
    bool meshing_ = false;
    NewestWork<SceneMesh> mesh_work_;
    QTimer meshed_;               ///< asks for it
    bool stale_ = false;          ///< something has changed since the last frame was asked for
    bool stale_picture_ = false;  ///< the picture has
    QTimer changed_;              ///< runs out when all that changes at once has changed
    int many_ = SceneFrame{}.many;
    Described described_;                 ///< what the last frame was asked for to show
    int asked_ = 0, shown_ = 0;           ///< numbers of frames
    int current_ = 0;                     ///< of the first that shows everything as it is
    bool rough_ = false, keeps_ = false;  ///< the frame that is shown
    QPointF pressed_, last_;
    bool dragged_ = false;
    int frames_ = 0;
    /// The view that was asked for, until it is turned by hand: it is fitted to the pane's size.
    std::optional<Request> standing_ = Request::from_side;
    SceneDrawing drawing_;  ///< the last one: it ends before what it tells ends
};

}  // namespace raytree::inspector
