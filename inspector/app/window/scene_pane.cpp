#include "window/scene_pane.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <iterator>
#include <new>
#include <utility>

#include "drawing/picking.h"
#include "drawing/standard_views.h"
#include "window/qt_text.h"
#include "window/scene_canvas.h"
#include "window/scene_overlay.h"

namespace raytree::inspector {
namespace {

const std::vector<std::shared_ptr<const PixelTree>> no_neighbours;

/// The angle that spans so many times the height.
double opened(double degrees, double times) {
    return times == 1 ? degrees
                      : glm::degrees(2 * std::atan(times * std::tan(glm::radians(degrees) / 2)));
}

}  // namespace

ScenePane::ScenePane(State& state, PictureFeed& feed, QWidget* parent)
    : QWidget(parent), state_(state), feed_(feed), drawing_(feed.right_of_way(), [this] {
          QMetaObject::invokeMethod(this, &ScenePane::take_frames, Qt::QueuedConnection);
      }) {
    canvas_ = new SceneCanvas(this);
    canvas_->installEventFilter(this);
    canvas_->setMouseTracking(true);
    canvas_->setFocusPolicy(Qt::StrongFocus);
    setFocusProxy(canvas_);
    connect(canvas_, &SceneCanvas::drawn, this, &ScenePane::drawn);
    overlay_ = new SceneOverlay(state_, canvas_);
    setMinimumSize(240, 180);
    changed_.setSingleShot(true);
    connect(&changed_, &QTimer::timeout, this, &ScenePane::ask_for_frame);
    meshed_.setInterval(5);
    connect(&meshed_, &QTimer::timeout, this, [this] {
        if (take_mesh({})) {
            redraw();
        }
    });
    canvas_->set_palette_of(state_.look().theme);
    state_.observe([this](const Changes& changes) { obey(changes); });
    connect(&feed_, &PictureFeed::updated, this, [this] {
        stale_picture_ = true;
        begin_frame();
    });
}

ScenePane::~ScenePane() = default;

void ScenePane::obey(const Changes& changes) {
    if (changes.document) {
        mesh_ = std::make_shared<SceneMesh>();
        take_document();
    }
    if (changes.look) {
        canvas_->set_palette_of(state_.look().theme);
    }
    if (changes.coats) {
        take_document();
    }
    if (changes.tree || changes.look || changes.playback) {
        take_tree();
    }
    if (changes.document) {
        obey(Request::from_side);
    }
    if (changes.request) {
        obey(*changes.request);
    }
    if (changes.view_from) {
        View view = view_;
        view.eye = changes.view_from->eye;
        view.target = changes.view_from->target;
        view.up = changes.view_from->up;
        view.fov_degrees = View{}.fov_degrees;  // whatever was looked through before
        view.cut = 0;
        standing_.reset();
        change_view(view);
    }
    if (changes.document || changes.tree || changes.selection || changes.look || changes.playback ||
        changes.explained) {
        redraw();
    }
}

void ScenePane::obey(Request request) {
    if (!state_.document()) {
        return;
    }
    const auto view = asked_view(request);
    if (view) {
        standing_ = request;
        change_view(*view);
    } else if (const auto moved = moved_view(request)) {
        standing_.reset();
        change_view(*moved);
    }
}

std::optional<View> ScenePane::asked_view(Request request) const {
    const Document& document = *state_.document();
    View now = view_;
    now.foot = overlay_->foot(now.width);
    switch (request) {
        case Request::through_camera:
            return camera_view(document, extent_, now);
        case Request::from_side:
            return side_view(document, extent_, whole_tree(), now);
        case Request::onto_hit:
            return state_.tree() && state_.selected()->hit
                       ? std::optional(hit_view(document, *state_.selected(), extent_, now))
                       : std::nullopt;
        case Request::fit_tree:
            return fitted_above_legend(now, points_of(whole_tree(), extent_));
        case Request::fit_selection:
            return fitted_above_legend(now, selected_points(), 0.3);
        default:
            return std::nullopt;
    }
}

/// Its rays, those that are still to be sent too: the view stays while one steps through them.
std::vector<RayPath> ScenePane::whole_tree() const {
    return state_.tree() && state_.playback()
               ? ray_paths(*state_.tree(), extent_, state_.look().filter)
               : paths_;
}

std::vector<Point3> ScenePane::selected_points() const {
    if (state_.thing()) {
        return corners_of(*state_.document(), extent_, *state_.thing());
    }
    std::vector<RayPath> chosen;
    if (state_.tree()) {
        std::ranges::copy_if(paths_, std::back_inserter(chosen), [&](const RayPath& path) {
            return path.ray == state_.selected()->id;
        });
    }
    return points_of(chosen, extent_);
}

void ScenePane::take_document() {
    extent_ = extent_of(*state_.document());
    mesh_pixel_ = 0;
    stale_picture_ = true;
}

void ScenePane::take_tree() {
    paths_.clear();
    if (state_.tree()) {
        paths_ = ray_paths(*state_.tree(), extent_, state_.look().filter);
        if (const auto& playback = state_.playback()) {
            std::erase_if(paths_, [&](const RayPath& path) {
                return playback->stage(path.ray) == Stage::unsent;
            });
        }
    }
    beside_.clear();
    for (const auto& tree : state_.tree() ? state_.tree()->neighbours : no_neighbours) {
        constexpr std::size_t most = 2000;  // of each
        std::ranges::copy(ray_paths(*tree, extent_, state_.look().filter, most),
                          std::back_inserter(beside_));
    }
    show_notes();
    std::vector<RayPath> all = paths_;
    all.insert(all.end(), beside_.begin(), beside_.end());
    overlay_->set_legend(legend_of(state_, all));
}

/// What of the tree is not drawn as it is.
void ScenePane::show_notes() {
    constexpr std::size_t most = 100'000;
    QStringList notes;
    const RayFilter& filter = state_.look().filter;
    if (state_.tree() && !filter.empty()) {
        notes << qt(text_of(filter));
    }
    if (state_.tree() && paths_.size() >= most && state_.tree()->tree.rays.size() > most) {
        notes << QStringLiteral("drawn are the %1 weightiest of %2 rays")
                     .arg(paths_.size())
                     .arg(state_.tree()->tree.rays.size());
    }
    if (mesh_->thinned_from > 0) {
        notes << QStringLiteral("meshes of %1 triangles are drawn with fewer")
                     .arg(mesh_->thinned_from);
    }
    if (cut_open(view_).cut > 0) {
        notes << QStringLiteral("solid shapes are cut open here");
    }
    if (state_.tree() && !state_.tree()->neighbours.empty()) {
        const Neighbours which = state_.look().neighbours;
        const auto count = state_.tree()->neighbours.size();
        notes << QStringLiteral("thin: the trees of %1 %2 %3")
                     .arg(count)
                     .arg(count == 1 ? QStringLiteral("pixel") : QStringLiteral("pixels"),
                          which == Neighbours::row      ? QStringLiteral("of its row")
                          : which == Neighbours::column ? QStringLiteral("of its column")
                                                        : QStringLiteral("around it"));
    }
    if (const std::string contrast = contrast_note(state_); !contrast.empty()) {
        notes << qt(contrast);
    }
    overlay_->set_notes(notes);
}

void ScenePane::change_view(const View& view) {
    view_ = view;
    show_notes();
    redraw();
}

/// However long it takes. Throws InputError where there is too little memory for it.
QImage ScenePane::drawn_whole(const SceneFrame& frame) {
    FrameImage drawn;
    try {
        state_.do_beside("Drawing the 3D view", [&] { drawn = drawing_.draw_image(frame).get(); });
    } catch (const std::bad_alloc&) {
        throw InputError("", "", "there is too little memory for a picture of the 3D view");
    }
    return image_of(drawn, frame.ratio);
}

/// All that the pane shows, and in a larger image letters and lines as large beside it as there.
QImage ScenePane::image(QSize size) {
    size = size.expandedTo({1, 1});
    const double scale = std::min(static_cast<double>(size.width()) / std::max(1, width()),
                                  static_cast<double>(size.height()) / std::max(1, height()));
    const double ratio = std::max(1.0, scale);
    View view = view_;
    view.width = static_cast<int>(std::ceil(size.width() / ratio));
    view.height = static_cast<int>(std::ceil(size.height() / ratio));
    view.fov_degrees = opened(view_.fov_degrees, view.height * ratio / scale / height());
    View fine = view;  // as many pixels as the image has
    fine.width = size.width();
    fine.height = size.height();
    Described described = describe(view, shapes_for(fine));
    described.frame.ratio = ratio;
    QImage image = drawn_whole(described.frame);
    redraw();
    SceneOverlay overlay(state_, nullptr);
    overlay.take_words_of(*overlay_);
    overlay.set_labels(view, std::move(described.labels), std::move(described.lines));
    overlay.resize(view.width, view.height);
    {
        QPainter painter(&image);
        overlay.render(&painter, {}, {}, {});
    }
    image.setDevicePixelRatio(1);
    return image.copy(QRect(QPoint(0, 0), size));  // less a part of a pixel of the view
}

QPixmap ScenePane::grabbed(QWidget& widget) {
    const Shapes shapes = shapes_for(view_);
    Described described = describe(view_, shapes);
    canvas_->show_frame(drawn_whole(described.frame));
    overlay_->set_labels(described.frame.view, std::move(described.labels),
                         std::move(described.lines));
    redraw();
    return widget.grab();
}

std::optional<QPointF> ScenePane::place_of(const Point3& p) const {
    const auto at = project(view_, p);
    return at ? std::optional(QPointF(at->x, at->y)) : std::nullopt;
}

void ScenePane::resizeEvent(QResizeEvent*) {
    canvas_->setGeometry(rect());
    overlay_->setGeometry(canvas_->rect());
    view_.width = std::max(1, width());
    view_.height = std::max(1, height());
    if (state_.document() && standing_) {
        obey(*standing_);
    }
    redraw();
}

void ScenePane::showEvent(QShowEvent*) { redraw(); }

}  // namespace raytree::inspector
