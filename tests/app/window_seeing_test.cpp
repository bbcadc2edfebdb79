// What can be selected, filtered and copied in the real window, by clicks and keys.

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QTreeWidget>
#include <QUrl>
#include <cmath>
#include <numeric>

#include "app/scenes.h"
#include "app/shown_window.h"
#include "drawing/edge_place.h"
#include "drawing/picking.h"
#include "drawing/ray_mesh.h"
#include "state/commands.h"
#include "state/emphasis.h"
#include "window/details_pane.h"
#include "window/diagram_pane.h"
#include "window/filter_pane.h"
#include "window/outline_pane.h"
#include "window/picture_pane.h"
#include "window/scene_labels.h"

namespace raytree::inspector {

class WindowSeeingTest : public test::ShownWindow {
    Q_OBJECT

    /// How many pixels of the 3D view are near a colour.
    int pixels_of(Ink ink) {
        const QImage image = view_image();
        int count = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const QColor at = image.pixelColor(x, y);
                count += std::abs(at.red() - ink.r) < 40 && std::abs(at.green() - ink.g) < 40 &&
                         std::abs(at.blue() - ink.b) < 40;
            }
        }
        return count;
    }

    QString dock_title() { return window_->details_pane().parentWidget()->windowTitle(); }

    /// A place in the 3D view where a click meets the object and no ray.
    std::optional<QPoint> place_of_object(std::size_t object) {
        const ScenePane& pane = window_->scene_pane();
        for (int y = 20; y < pane.height() - 60; y += 7) {
            for (int x = 20; x < pane.width() - 20; x += 7) {
                const auto thing = object_at(*state_.document(), pane.view(), x, y);
                if (thing == Thing{Thing::Kind::object, object} &&
                    !path_at(pane.paths(), pane.view(), x, y, 20) &&
                    !light_at(state_.document()->scene(), extent_of(*state_.document()),
                              pane.view(), x, y, 20)) {
                    return QPoint(x, y);
                }
            }
        }
        return std::nullopt;
    }

    /// How many pixels of the 3D view differ in its image, by more than smoothing of edges may.
    int different(const QImage& a, const QImage& b) {
        int count = 0;
        for (int y = 0; y < a.height(); ++y) {
            for (int x = 0; x < a.width(); ++x) {
                const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
                count += std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) +
                             std::abs(p.blue() - q.blue()) >
                         48;
            }
        }
        return count;
    }

    /// Whether the colour of what is selected is to be seen within 9 pixels of a place.
    static bool selection_is_seen(const QImage& image, QPointF at) {
        const double ratio = image.devicePixelRatio();
        const QColor ink(0xD6, 0x33, 0x6C);
        const int reach = static_cast<int>(9 * ratio);
        const QPoint middle = (at * ratio).toPoint();
        for (int y = middle.y() - reach; y <= middle.y() + reach; ++y) {
            for (int x = middle.x() - reach; x <= middle.x() + reach; ++x) {
                const QColor c = image.valid(x, y) ? image.pixelColor(x, y) : QColor(Qt::black);
                if (std::abs(c.red() - ink.red()) + std::abs(c.green() - ink.green()) +
                        std::abs(c.blue() - ink.blue()) <
                    60) {
                    return true;
                }
            }
        }
        return false;
    }

  private Q_SLOTS:
    void initTestCase() {
        show_window();
        state_.show(test::opened(test::glass_ball_scene()));
        QTRY_VERIFY(window_->feed().done());
        QTRY_VERIFY(window_->scene_pane().frames() > 0);
    }

    void init() {
        QApplication::setActiveWindow(window_.get());
        run_command(state_, "filter.clear");
        run_command(state_, "table.first_columns");
        run_command(state_, "tab.outline");
        state_.pick({0, 0});
        state_.pick({40, 30});
        QTRY_VERIFY(state_.tree());
        state_.select(0);
        state_.request(Request::from_side);
        QTest::qWait(50);
    }

    void a_click_on_an_object_selects_it_everywhere() {
        for (std::size_t object = 0; object < 3; ++object) {
            const auto place = place_of_object(object);
            QVERIFY2(place, std::to_string(object).c_str());
            QTest::mouseClick(canvas(), Qt::LeftButton, {}, *place);
            QVERIFY((state_.thing() == Thing{Thing::Kind::object, object}));
            QCOMPARE(dock_title(), QStringLiteral("Selected object"));
            const QString name =
                QString::fromStdString(state_.document()->scene().objects[object].name);
            QVERIFY(window_->details_pane().toPlainText().contains(name));
            QVERIFY(window_->details_pane().toPlainText().contains(QStringLiteral("Material")));
        }
    }

    void a_selected_object_is_drawn_and_listed_in_its_colour() {
        const Ink ink = palette_of(Theme::light).selection;
        run_command(state_, "light.next");  // a small ring
        const int before = pixels_of(ink);
        run_command(state_, "object.select", "ball");
        QVERIFY2(pixels_of(ink) > before + 100, std::to_string(pixels_of(ink)).c_str());
        const auto* model = static_cast<const OutlineModel*>(window_->outline_pane().model());
        const auto marked = emphasis_of(state_).marked;
        for (std::size_t ray = 0; ray < marked.size(); ++ray) {
            const bool shown = model->index_of_ray(ray).data(Qt::BackgroundRole).isValid();
            QCOMPARE(shown, bool(marked[ray]));
        }
    }

    void a_click_on_a_light_selects_it_and_its_rays_are_links() {
        const Extent extent = extent_of(*state_.document());
        const Light& key = state_.document()->scene().lights[0];
        const auto at = window_->scene_pane().place_of(place_of(key, extent));
        QVERIFY(at);
        QTest::mouseClick(canvas(), Qt::LeftButton, {}, at->toPoint());
        QVERIFY((state_.thing() == Thing{Thing::Kind::light, 0}));
        QCOMPARE(dock_title(), QStringLiteral("Selected light"));
        const auto rays =
            rays_that_concern(state_.document()->scene(), state_.tree()->tree, *state_.thing());
        QVERIFY(!rays.empty());
        Q_EMIT window_->details_pane().anchorClicked(QUrl(QStringLiteral("r:%1").arg(rays[0])));
        QCOMPARE(state_.selected()->id, rays[0]);
        QVERIFY(!state_.thing());
        QCOMPARE(dock_title(), QStringLiteral("Selected ray"));
    }

    void keys_reach_objects_and_lights() {
        canvas()->setFocus();
        QTest::keyClick(canvas(), Qt::Key_H);
        QVERIFY(state_.thing().has_value());
        QTest::keyClick(canvas(), Qt::Key_L, Qt::ShiftModifier);
        QVERIFY((state_.thing() == Thing{Thing::Kind::light, 0}));
        QTest::keyClick(canvas(), Qt::Key_Escape, Qt::ShiftModifier);
        QVERIFY(!state_.thing());
    }

    void a_click_on_nothing_lets_go() {
        run_command(state_, "object.select", "ball");
        const ScenePane& pane = window_->scene_pane();
        for (int x = 2; x < pane.width(); ++x) {
            if (!object_at(*state_.document(), pane.view(), x, 2) &&
                !path_at(pane.paths(), pane.view(), x, 2, 20)) {
                QTest::mouseClick(canvas(), Qt::LeftButton, {}, {x, 2});
                break;
            }
        }
        QVERIFY(!state_.thing());
    }

    void a_tick_in_the_filter_dims_and_hides() {
        run_command(state_, "tab.filter");
        FilterPane& filter = window_->filter_pane();
        QTRY_VERIFY(filter.isVisible());
        const Ink refracted = palette_of(Theme::light)[RayLook::refracted];
        const int before = pixels_of(refracted);
        const RayGroup group = group_of(RayKind::refracted);
        for (const Qt::CheckState tick : {Qt::PartiallyChecked, Qt::Unchecked}) {
            QVERIFY(filter.item_of(group));
            filter.item_of(group)->setCheckState(0, tick);
            QTRY_VERIFY(state_.look().filter.of(group) ==
                        (tick == Qt::Unchecked ? Shown::hidden : Shown::dimmed));
            QVERIFY(filter.item_of(group)->checkState(0) == tick);
        }
        const int after = pixels_of(refracted);
        QVERIFY2(after < before / 2,  // the legend keeps its sign
                 (std::to_string(before) + " -> " + std::to_string(after)).c_str());
        for (const RayPath& path : window_->scene_pane().paths()) {
            QVERIFY(path.look != RayLook::refracted);
        }
    }

    void a_click_on_a_title_sorts_and_rows_are_copied() {
        QHeaderView* const header = window_->outline_pane().header();
        const int t = static_cast<int>(Column::t);
        const QPoint place(header->sectionViewportPosition(t) + header->sectionSize(t) / 2,
                           header->height() / 2);
        QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, place);
        QVERIFY(state_.table().sorted_by == Column::t);
        const auto* model = static_cast<const OutlineModel*>(window_->outline_pane().model());
        const auto rays = sorted_rays(*state_.tree(), Column::t, false);
        QCOMPARE(model->rowCount({}), static_cast<int>(rays.size()));
        for (std::size_t k = 0; k < rays.size(); ++k) {
            const QModelIndex index = model->index(static_cast<int>(k), 0, {});
            QCOMPARE(model->row(index).ray, rays[k]);
            QCOMPARE(model->index_of_ray(rays[k]).row(), static_cast<int>(k));
        }
        window_->outline_pane().setCurrentIndex(model->index(2, 0, {}));
        QCOMPARE(state_.selected()->id, rays[2]);
        window_->outline_pane().setFocus();
        QTest::keyClick(&window_->outline_pane(), Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QApplication::clipboard()->text(),
                 QString::fromStdString(copied(*state_.tree(), {rays[2]}, Table().columns)));
        run_command(state_, "copy.table");
        QCOMPARE(QApplication::clipboard()->text().count(QLatin1Char('\n')),
                 static_cast<int>(rays.size()) + 1);
        QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, place);
        QVERIFY(state_.table().descending);
        run_command(state_, "table.as_tree");
        QCOMPARE(model->rowCount({}), 1);
        // The title has its room beside the arrow.
        run_command(state_, "table.column", "weight");
        run_command(state_, "table.sort", "weight");
        const int weight = static_cast<int>(Column::weight);
        const QString title = model->headerData(weight, Qt::Horizontal, Qt::DisplayRole).toString();
        QVERIFY(title.endsWith(QChar(QChar::Nbsp)));
        QFont letters = header->font();
        letters.setBold(true);
        QVERIFY(QFontMetrics(letters).horizontalAdvance(title) <= header->sectionSize(weight));
        run_command(state_, "table.first_columns");
    }

    void a_number_of_the_details_is_copied_with_all_its_digits() {
        DetailsPane& details = window_->details_pane();
        details.setFocus();
        QTest::keyClick(&details, Qt::Key_Tab);
        QTest::keyClick(&details, Qt::Key_Tab);
        run_command(state_, "copy.number");
        bool is_number = false;
        const double copied = QApplication::clipboard()->text().toDouble(&is_number);
        QVERIFY2(is_number, qPrintable(QApplication::clipboard()->text()));
        const TreeRay<double>& ray = *state_.selected();
        bool known = false;
        for (const auto& colour : {ray.ambient, ray.diffuse, ray.specular}) {
            known = known || copied == colour.r || copied == colour.g || copied == colour.b;
        }
        QVERIFY(known);
    }

    void the_picture_in_the_3d_view_consists_of_squares() {
        // Seen straight on from near, its pixels are as wide as a finger.
        ScenePane& pane = window_->scene_pane();
        const Extent extent = extent_of(*state_.document());
        const auto corners = picture_corners(*state_.document(), extent.plane_distance);
        const Camera& camera = state_.document()->scene().camera;
        const Point3 middle = (corners[0] + corners[2]) * 0.5;
        run_command(state_, "show.names");
        // From behind it, where looking through the camera does not hide it.
        state_.look_from({middle + 0.7 * (middle - camera.eye), middle});
        QTRY_VERIFY(pane.place_of(middle));
        QTest::qWait(250);
        const QImage image = view_image();
        const Point3 right = (corners[1] - corners[0]) / static_cast<double>(camera.width);
        const Point3 down = (corners[3] - corners[0]) / static_cast<double>(camera.height);
        int compared = 0, uneven = 0;
        for (int j = 0; j < camera.height; ++j) {
            for (int i = 0; i < camera.width; ++i) {
                const auto colour = [&](double x, double y) -> std::optional<QColor> {
                    const auto at = pane.place_of(corners[0] + right * (i + x) + down * (j + y));
                    const bool inside =
                        at && pane.rect().adjusted(9, 9, -9, -60).contains(at->toPoint());
                    return inside ? std::optional(image.pixelColor(at->toPoint())) : std::nullopt;
                };
                const auto a = colour(0.3, 0.3), b = colour(0.7, 0.7);
                if (a && b) {
                    ++compared;
                    uneven += std::abs(a->red() - b->red()) + std::abs(a->green() - b->green()) +
                                  std::abs(a->blue() - b->blue()) >
                              12;
                }
            }
        }
        run_command(state_, "show.names");
        QVERIFY2(compared > 100, std::to_string(compared).c_str());
        // But where a ray or a line of the frustum crosses it.
        QVERIFY2(uneven < compared / 10, std::to_string(uneven).c_str());
    }

    void what_lies_inside_something_solid_is_seen_onto_its_hit() {
        const Ink refracted = palette_of(Theme::light)[RayLook::refracted];
        run_command(state_, "shapes.solid");
        const int closed = pixels_of(refracted);
        run_command(state_, "view.hit");
        const int open = pixels_of(refracted);
        run_command(state_, "shapes.see_through");
        // What is left while all is closed: the legend's sign, and rays outside.
        QVERIFY2(open > closed + 200,
                 (std::to_string(closed) + " -> " + std::to_string(open)).c_str());
    }

    void an_arrow_points_to_a_selected_light_outside_the_view() {
        const Extent extent = extent_of(*state_.document());
        run_command(state_, "view.camera");
        run_command(state_, "light.select", "key");
        const ScenePane& pane = window_->scene_pane();
        const Light& key = state_.document()->scene().lights[0];
        const auto seen = pane.place_of(place_of(key, extent));
        QVERIFY(!seen || !QRectF(pane.rect()).contains(*seen));
        const WordBox frame{14, 14, pane.width() - 28.0, pane.height() - 62.0};
        const auto place = edge_place(pane.view(), frame, place_of(key, extent));
        QVERIFY(place);
        QVERIFY(selection_is_seen(view_image(), {place->x, place->y}));
        run_command(state_, "view.fit_selection");
        QVERIFY(QRectF(pane.rect()).contains(*pane.place_of(place_of(key, extent))));
        const auto gone = QPointF(place->x, place->y);
        QVERIFY(!selection_is_seen(view_image(), gone));
    }

    void a_very_small_image_shows_the_scene_and_no_legend() {
        run_command(state_, "view.side");
        const QImage image = window_->scene_pane().image({64, 64});
        const Ink ink = palette_of(state_.look().theme).selection;
        int selected = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const QColor at = image.pixelColor(x, y);
                selected += std::abs(at.red() - ink.r) < 60 && std::abs(at.green() - ink.g) < 60 &&
                            std::abs(at.blue() - ink.b) < 60;
            }
        }
        QVERIFY2(selected > 4, qPrintable(QString::number(selected)));
    }

    void lights_that_are_asked_outside_the_view_are_pointed_to() {
        const Extent extent = extent_of(*state_.document());
        run_command(state_, "view.camera");  // the lamp is behind it
        const auto pointed_to = [&] {
            QStringList names;
            for (const SceneLabel& label :
                 scene_labels(state_, extent, window_->scene_pane().view(), true)) {
                if (!label.strong && !label.away.isEmpty()) {
                    names << label.away;
                }
            }
            return names;
        };
        const auto& rays = state_.tree()->tree.rays;
        QVERIFY(std::ranges::any_of(rays, [](const TreeRay<double>& ray) {
            return ray.shadow && ray.shadow->light == "key";
        }));
        QVERIFY(pointed_to().contains(QStringLiteral("key")));
        run_command(state_, "filter.set", "hidden light key");  // nor are its rays seen
        QVERIFY(!pointed_to().contains(QStringLiteral("key")));
        run_command(state_, "filter.clear");
        run_command(state_, "light.select", "key");  // has a larger arrow of its own
        QVERIFY(!pointed_to().contains(QStringLiteral("key")));
        run_command(state_, "thing.none");
    }

    void many_lights_close_together_have_one_name() {
        Scene scene = test::glass_ball_scene();
        for (int k = 0; k < 18; ++k) {
            scene.lights.push_back({"lamp " + std::to_string(k), Colour(0.05),
                                    PointLight{{3 + 0.01 * k, 5.0, 4.0}, {}}});
        }
        state_.show(test::opened(scene));
        QTRY_VERIFY(state_.tree());
        const Extent extent = extent_of(*state_.document());
        int named = 0, told = 0;
        for (const SceneLabel& label :
             scene_labels(state_, extent, window_->scene_pane().view(), false)) {
            const bool lamp = label.text.startsWith(QStringLiteral("lamp")) ||
                              label.text.startsWith(QStringLiteral("key"));
            const QString more =
                label.text.section(QStringLiteral(" and "), 1).section(QLatin1Char(' '), 0, 0);
            named += lamp ? 1 : 0;
            told += lamp ? 1 + more.toInt() : 0;
        }
        QVERIFY2(named <= 3, qPrintable(QString::number(named)));
        QVERIFY2(told >= 18, qPrintable(QString::number(told)));
        state_.show(test::opened(test::glass_ball_scene()));
        QTRY_VERIFY(state_.tree() && window_->feed().done());
    }

    /// On screens of any number of pixels (run with QT_SCALE_FACTOR=2 as well).
    void a_ray_is_drawn_where_a_click_chooses_it() {
        ScenePane& pane = window_->scene_pane();
        run_command(state_, "show.names");
        QTRY_VERIFY(pane.keeps());
        int chosen = 0;
        for (const RayPath& path : std::vector<RayPath>(pane.paths())) {
            const auto ends = on_screen(path, pane.view());
            if (!ends ||
                std::hypot(ends->first.x - ends->second.x, ends->first.y - ends->second.y) < 60) {
                continue;
            }
            const QPointF middle(0.5 * (ends->first.x + ends->second.x),
                                 0.5 * (ends->first.y + ends->second.y));
            state_.select(std::nullopt);
            QTest::mouseClick(canvas(), Qt::LeftButton, {}, middle.toPoint());
            if (state_.thing()) {
                continue;  // a light stands before it
            }
            const auto near = path_at(pane.paths(), pane.view(), middle.x(), middle.y(), 9);
            QVERIFY(near && pane.paths()[*near].ray == state_.selected()->id);
            const QImage image = view_image();
            QVERIFY2(selection_is_seen(image, middle), qPrintable(QStringLiteral("ray %1 at %2, %3")
                                                                      .arg(state_.selected()->id)
                                                                      .arg(middle.x())
                                                                      .arg(middle.y())));
            ++chosen;
        }
        run_command(state_, "show.names");
        QVERIFY(chosen > 1);
    }

    void the_3d_view_is_drawn_at_any_size() {
        ScenePane& pane = window_->scene_pane();
        const View before = pane.view();
        const QImage image = pane.image({1500, 700});
        QCOMPARE(image.size(), QSize(1500, 700));
        QCOMPARE(pane.view().width, before.width);
        QVERIFY(pane.view().eye == before.eye);
        const QColor ray = QColor(0x2B, 0x34, 0x40);
        int count = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const QColor at = image.pixelColor(x, y);
                count += std::abs(at.red() - ray.red()) < 40 &&
                         std::abs(at.green() - ray.green()) < 40 &&
                         std::abs(at.blue() - ray.blue()) < 40;
            }
        }
        QVERIFY2(count > 500, std::to_string(count).c_str());
    }

    /// Nothing that the view shows is cut off, whatever the image's form, and of a large one
    /// letters and lines are as large beside it as they are in the view.
    void an_image_of_any_form_shows_all_of_the_view() {
        ScenePane& pane = window_->scene_pane();
        run_command(state_, "show.names");
        state_.request(Request::fit_tree);
        const auto inked = [](const QImage& image) {  // of the primary ray's colour, by its extent
            QRect around;
            for (int y = 0; y < image.height() * 3 / 4; ++y) {
                for (int x = 0; x < image.width(); ++x) {
                    const QColor at = image.pixelColor(x, y);
                    if (std::abs(at.red() - 0x2B) < 20 && std::abs(at.green() - 0x34) < 20 &&
                        std::abs(at.blue() - 0x40) < 20) {
                        around |= QRect(x, y, 1, 1);
                    }
                }
            }
            return around;
        };
        const QRect first = inked(pane.image(pane.size()));
        const double width = first.width();
        QVERIFY(width > 20);
        const QSize size = pane.size();
        for (const double wider : {1.0, 0.5}) {
            const QImage image = pane.image(
                {static_cast<int>(3 * wider * size.width()), static_cast<int>(3 * size.height())});
            const QRect now = inked(image);
            const double times = now.width() / width;
            QVERIFY2(std::abs(times - 3 * wider) < 0.25 * wider, std::to_string(times).c_str());
        }
        run_command(state_, "show.names");
    }

    /// Shapes, once they have stood still, are not drawn again when another ray is chosen.
    void what_is_kept_of_the_3d_view_is_what_a_whole_drawing_shows() {
        ScenePane& pane = window_->scene_pane();
        window_->picture_pane().setFocus();  // no frame around the view
        int compared = 0;
        for (const Request view : {Request::from_side, Request::fit_tree}) {
            state_.request(view);
            for (const std::size_t ray : {std::size_t{1}, state_.tree()->tree.rays.size() - 1}) {
                QTRY_VERIFY(pane.keeps());
                state_.select(ray);
                const QImage kept = view_image();
                compared += pane.keeps();
                const QImage whole = pane.image(pane.size());
                QVERIFY(!pane.keeps());
                QCOMPARE(kept.size(), whole.size());
                const int wrong = different(kept, whole);
                QVERIFY2(wrong < kept.width() * kept.height() / 100,
                         qPrintable(QString::number(wrong)));
                state_.request(view);
            }
        }
        QVERIFY(compared > 0);
    }

    /// Many shapes are first seen roughly, then as they are: to the last bit what is seen of them
    /// where they are drawn in one go.
    void many_shapes_are_drawn_little_by_little() {
        ScenePane& pane = window_->scene_pane();
        window_->picture_pane().setFocus();  // no frame around the view
        for (const char* const style : {"shapes.see_through", "shapes.solid", "shapes.wire"}) {
            run_command(state_, style);
            QTRY_VERIFY(pane.keeps());  // laid out by now
            QImage seen[2];
            for (const int many : {1'000'000'000, 100}) {
                pane.set_many(many);
                pane.catch_up();
                QCOMPARE(pane.has_shapes(), many > 100);
                const QImage rough = view_image();
                QTRY_VERIFY(pane.keeps());
                seen[many == 100] = view_image();
                QVERIFY(pane.has_shapes());
                // Rough is no other view: few pixels differ clearly.
                const int wrong = different(rough, seen[many == 100]);
                QVERIFY2(wrong < rough.width() * rough.height() / 20,
                         qPrintable(QString::number(wrong)));
            }
            QVERIFY2(seen[0] == seen[1], style);
        }
        pane.set_many(99);
        pane.catch_up();
        QVERIFY(!pane.has_shapes());
        const QImage image = pane.grabbed(pane).toImage();
        QTRY_VERIFY(pane.keeps());
        QVERIFY(different(image, view_image()) < image.width() * image.height() / 100);
        pane.set_many(1'000'000'000);
        run_command(state_, "shapes.see_through");
    }
};

}  // namespace raytree::inspector

int main(int argc, char** argv) {
    return raytree::inspector::test::run_tests<raytree::inspector::WindowSeeingTest>(argc, argv);
}

#include "window_seeing_test.moc"
