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
#include "view3d/scene3d.h"
#include "window/picture_feed.h"

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
    /// Whether the shapes that are drawn are those of the scene shown, all of them as they are.
    bool has_shapes() const { return !meshing_ && !scene3d_.is_rough(); }
    /// Whether the last frame drew no more than rays over shapes that had stood still.
    bool keeps() const { return scene3d_.keeps(); }
    /// Asks for a frame with everything as it is now.
    void draw_again() { redraw(); }
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
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    friend class SceneCanvas;

    void obey(const Changes& changes);
    void obey(Request request);
    void take_document();
    void take_tree();
    void take_picture();
    /// None where there is no such view.
    std::optional<View> asked_view(Request request) const;
    std::vector<Point3> selected_points() const;
    void change_view(const View& view);
    void show_notes();
    void make_mesh(double pixel);
    bool take_mesh(std::chrono::milliseconds patience);
    void place_picture();
    void prepare_rays();
    std::vector<WordLine> ray_lines() const;
    void lay_shapes_over(std::initializer_list<const Mesh*> things);
    bool looks_from_the_eye() const;
    /// Hands over what has changed since the last frame; whether anything has.
    bool prepare_frame();
    void redraw();
    void finish_frame();
    void settle();
    void draw_more();
    void drag(QPointF by, bool move);
    void click(QPointF at);
    void show_hint(QPointF at, QPoint global);
    std::optional<std::size_t> ray_at(QPointF at) const;
    std::optional<Thing> thing_at(QPointF at) const;

    State& state_;
    PictureFeed& feed_;
    Scene3d scene3d_;
    SceneCanvas* canvas_ = nullptr;
    SceneOverlay* overlay_ = nullptr;
    View view_;
    Extent extent_;
    SceneMesh mesh_;
    std::vector<std::size_t> shape_order_;  ///< of its objects, where they are see-through
    std::vector<RayPath> paths_;
    std::vector<RayPath> beside_;  ///< of the pixels around
    bool stale_shapes_ = false;    ///< what the next frame has to be given anew
    bool stale_rays_ = false;
    bool stale_view_ = false;
    double mesh_pixel_ = 0;  ///< for which mesh_ has been made, or is being made
    bool meshing_ = false;
    std::chrono::milliseconds mesh_patience_{40};
    NewestWork<SceneMesh> mesh_work_;
    QTimer meshed_;  ///< asks for it
    bool stale_picture_ = false;
    QTimer settled_;  ///< runs out when the view has stood still for a while
    QTimer drawing_;  ///< then draws many shapes little by little
    QPointF pressed_, last_;
    bool dragged_ = false;
    int frames_ = 0;
    /// The view that was asked for, until it is turned by hand: it is fitted to the pane's size.
    std::optional<Request> standing_ = Request::from_side;
};

}  // namespace raytree::inspector
