#include <QDockWidget>
#include <QLabel>
#include <QScrollArea>
#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>
#include <algorithm>
#include <tuple>
#include <utility>

#include "state/commands.h"
#include "window/actions.h"
#include "window/counts_pane.h"
#include "window/details_pane.h"
#include "window/diagram_pane.h"
#include "window/explained_pane.h"
#include "window/filter_pane.h"
#include "window/fitting_label.h"
#include "window/fitting_tabs.h"
#include "window/icons.h"
#include "window/lesson_pane.h"
#include "window/main_window.h"
#include "window/outline_pane.h"
#include "window/overlay_legend.h"
#include "window/panel_frame.h"
#include "window/picture_pane.h"
#include "window/qt_text.h"
#include "window/scene_pane.h"
#include "window/side_dock.h"

/// The window's part in where its panes are, and how they share its room.
namespace raytree::inspector {
namespace {

constexpr int legend_room = 90;  // of an overlay, below the picture

}  // namespace

QDockWidget* MainWindow::add_dock(const QString& title, QWidget* widget, Qt::DockWidgetArea area) {
    auto* const dock = new QDockWidget(title, this);
    dock->setObjectName(title);
    dock->setFeatures(QDockWidget::DockWidgetMovable);
    dock->setWidget(widget);
    addDockWidget(area, dock);
    return dock;
}

/// Its tabs are its title, so that they take no room.
void MainWindow::add_tree_dock() {
    outline_ = new OutlinePane(state_);
    diagram_ = new DiagramPane(state_);
    filter_ = new FilterPane(state_);
    counts_pane_ = new CountsPane(state_);
    tree_panes_ = new QStackedWidget;
    auto* const tabs = new FittingTabs;
    auto* const filter_area = new QScrollArea;  // where the window is narrow, it scrolls
    filter_area->setFrameShape(QFrame::NoFrame);
    filter_area->setWidgetResizable(true);
    filter_area->setWidget(filter_);
    filter_area->setFocusProxy(filter_);
    const std::tuple<const char*, const char*, QWidget*> panes[] = {
        {"Ray tree", "Tree", outline_},
        {"Diagram", "Diagram", diagram_},
        {"Counts", "Counts", counts_pane_},
        {"Rays shown", "Shown", filter_area},
        {"Explained", "Why", new ExplainedPane(state_)}};
    for (const auto& [title, brief, pane] : panes) {
        tabs->add(QString::fromUtf8(title), QString::fromUtf8(brief));
        tree_panes_->addWidget(pane);
    }
    tabs_ = tabs;
    state_.observe([this, tabs](const Changes& changes) {
        if (changes.look || changes.document) {
            const Palette& palette = palette_of(state_.look().theme);
            QList<QIcon> icons;
            for (const char* const id :
                 {"tab.outline", "tab.diagram", "tab.counts", "tab.filter", "tab.explained"}) {
                icons << command_icon(id, palette);
            }
            tabs->set_icons(icons);
        }
    });
    connect(tabs_, &QTabBar::currentChanged, this, [this](int tab) {
        if (tab != static_cast<int>(state_.tree_pane().tab)) {
            TreePane pane = state_.tree_pane();
            pane.tab = static_cast<TreePane::Tab>(tab);
            state_.change_tree_pane(pane);
        }
    });
    tree_dock_ = add_dock(QStringLiteral("Ray tree"), tree_panes_, Qt::BottomDockWidgetArea);
    tree_dock_->setTitleBarWidget(tabs_);
}

void MainWindow::add_lesson_dock() {
    lesson_pane_ =
        new LessonPane(state_, [this](const std::string& command, const std::string& argument) {
            actions_->run(*find_command(command), argument);
        });
    lesson_dock_ = add_dock(QStringLiteral("Lesson"), lesson_pane_, Qt::RightDockWidgetArea);
    lesson_dock_->setTitleBarWidget(new QWidget);  // the pane says itself what it is
    lesson_dock_->hide();
    frame_ = new PanelFrame(this);
}

QWidget* MainWindow::make_picture_box() {
    auto* const box = new QWidget;
    picture_ = new PicturePane(state_, feed_);
    hovered_ = new FittingLabel;
    hovered_->setMargin(4);
    hovered_->setIndent(6);
    hovered_->setObjectName(QStringLiteral("aside"));
    hovered_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    show_hovered(std::nullopt);
    connect(picture_, &PicturePane::hovered, this, &MainWindow::show_hovered);
    auto* const layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(1);
    layout->addWidget(picture_, 1);
    layout->addWidget(new OverlayLegend(state_, feed_));
    layout->addWidget(hovered_);
    return box;
}

QWidget* MainWindow::make_centre() {
    auto* const box = new QWidget;
    message_ = new QLabel;
    message_->setWordWrap(true);
    message_->setMargin(6);
    message_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    message_->hide();
    scene_ = new ScenePane(state_, feed_);
    auto* const layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(message_);
    layout->addWidget(scene_, 1);
    return box;
}

/// The lesson's pane, an overlay's legend, and a frame around the pane that a step talks about.
void MainWindow::show_lesson() {
    const bool shown = state_.lesson_side() != LessonSide::hidden;
    const bool overlaid = state_.look().overlay || state_.look().depth_overlay;
    const bool legend_comes_or_goes = overlaid != std::exchange(overlaid_, overlaid);
    if (lesson_dock_->isVisibleTo(this) != shown) {
        lesson_dock_->setVisible(shown);
        share_room();
    } else if (legend_comes_or_goes) {
        // It takes its room from the details: the picture stays as large as it is.
        const int more = overlaid ? legend_room : -legend_room;
        resizeDocks({picture_dock_, details_dock_},
                    {picture_dock_->height() + more, details_dock_->height() - more}, Qt::Vertical);
    }
    QWidget* const panes[] = {picture_,   scene_,   tree_dock_, tree_dock_,
                              tree_dock_, details_, tree_dock_};
    const LessonRun* const lesson = state_.lesson();
    const auto panel = lesson && state_.lesson_side() == LessonSide::lesson
                           ? lesson->here().show.panel
                           : std::nullopt;
    const bool diagram = panel == lesson::Panel::diagram;
    if (diagram != std::exchange(teaches_by_diagram_, diagram)) {
        share_room();
    }
    frame_->put_around(panel ? panes[static_cast<std::size_t>(*panel)] : nullptr,
                       palette_of(state_.look().theme).accent);
}

/// The docks keep their shares of the window; a lesson's text has lines that are easy to read.
void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    share_room();
}

void MainWindow::share_room() {
    const bool teaches = lesson_dock_->isVisibleTo(this);
    const bool three = teaches || side_->isVisibleTo(this);  // columns
    const int left = three ? std::clamp(static_cast<int>(width() * 0.26), 312, 560)
                           : std::clamp(static_cast<int>(width() * 0.31), 330, 620);
    if (teaches) {
        resizeDocks({lesson_dock_}, {std::clamp(static_cast<int>(width() * 0.27), 300, 480)},
                    Qt::Horizontal);
    }
    if (teaches && side_->isVisibleTo(this)) {
        resizeDocks({lesson_dock_, side_}, {height() * 55 / 100, height() * 45 / 100},
                    Qt::Vertical);
    }
    tall_tree_ = state_.tree_pane().tall;
    const double share = teaches_by_diagram_ ? 0.56 : teaches ? 0.4 : 0.36;
    const int below = tall_tree_ ? std::max(height() / 2, std::min(height() * 3 / 5, 480))
                                 : std::clamp(static_cast<int>(height() * share), 160, 480);
    const int picture = std::min(left * 3 / 4 + 50 + (overlaid_ ? legend_room : 0),
                                 static_cast<int>(height() * (overlaid_ ? 0.55 : 0.5)));
    const int letter = fontMetrics().averageCharWidth();
    const int side = std::clamp(width() * 9 / 40, 36 * letter, std::max(400, 48 * letter));
    resizeDocks({picture_dock_, side_}, {left, side}, Qt::Horizontal);
    resizeDocks({tree_dock_}, {below}, Qt::Vertical);
    resizeDocks({picture_dock_, details_dock_}, {picture, height() - picture}, Qt::Vertical);
}

}  // namespace raytree::inspector
