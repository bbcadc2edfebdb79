#include "window/scene_labels.h"

#include <algorithm>

#include "drawing/angles.h"
#include "drawing/edge_place.h"
#include "drawing/explained_mesh.h"
#include "drawing/picking.h"
#include "drawing/ray_mesh.h"
#include "state/marked_texts.h"
#include "window/qt_text.h"

namespace raytree::inspector {
namespace {

constexpr std::size_t most_marks = 14;

Point3 middle_of(const std::vector<Point3>& points) {
    Point3 sum(0);
    for (const Point3& p : points) {
        sum += p;
    }
    return points.empty() ? sum : sum / static_cast<double>(points.size());
}

bool is_outside(const View& view, const Point3& p) {
    const WordBox whole{0, 0, static_cast<double>(view.width), static_cast<double>(view.height)};
    return edge_place(view, whole, p).has_value();
}

/// Halfway along a ray, or near its start where it has no end.
Point3 along_way(const TreeRay<double>& ray, const Extent& extent) {
    const double way = ray.hit                                ? ray.hit->t / 2
                       : ray.shadow && ray.shadow->blocked_by ? ray.shadow->blocked_by->t / 2
                                                              : 0.12 * extent.diagonal;
    return along(ray.origin, way, ray.direction);
}

/// The sign of each ray that is not the same in both trees, those first where it begins.
void add_marks(std::vector<SceneLabel>& labels, const State& state, const Extent& extent) {
    const auto& tree = state.tree();
    if (!tree || !tree->contrast) {
        return;
    }
    std::size_t count = 0;
    const auto add = [&](const TreeRay<double>& ray, bool causes) {
        const RayMark mark = tree->mark(ray.id);
        const bool sent = !state.playback() || state.playback()->stage(ray.id) != Stage::unsent;
        const bool due = mark != RayMark::none && mark != RayMark::same && sent &&
                         shown(state.look().filter, *tree, ray) != Shown::hidden;
        const bool below_cut =
            mark == RayMark::cut && ray.parent && tree->mark(*ray.parent) == RayMark::cut;
        if (due && !below_cut && causes == (mark != RayMark::follows) && count < most_marks) {
            labels.push_back({along_way(ray, extent),
                              qt(std::string(text_of(mark).sign) + " " + number_of(*tree, ray.id)),
                              mark == RayMark::different});
            ++count;
        }
    };
    for (const bool causes : {true, false}) {
        for (const TreeRay<double>& ray : tree->tree.rays) {
            add(ray, causes);
        }
    }
}

RayKind kind_of_look(RayLook look) {
    switch (look) {
        case RayLook::primary:
            return RayKind::primary;
        case RayLook::reflected:
            return RayKind::reflected;
        case RayLook::refracted:
            return RayKind::refracted;
        default:
            return RayKind::shadow;
    }
}

}  // namespace

SceneLegend legend_of(const State& state, const std::vector<RayPath>& paths) {
    SceneLegend legend;
    for (const RayPath& path : paths) {
        legend.looks[static_cast<std::size_t>(path.look)] = true;
        legend.dimmed[static_cast<std::size_t>(path.look)] =
            state.look().filter.of(group_of(kind_of_look(path.look))) == Shown::dimmed;
        legend.open |= path.end == RayPath::End::open;
    }
    const TreeRay<double>* const ray = state.look().ghosts ? state.selected() : nullptr;
    legend.unsent = ray && can_derive(*state.tree(), ray->id, state.playback()) &&
                    has_ghosts(state.document()->scene(), *ray,
                               state.playback() ? &*state.playback() : nullptr);
    return legend;
}

std::string contrast_note(const State& state) {
    const auto& tree = state.tree();
    if (!tree || !tree->contrast) {
        return {};
    }
    if (tree->contrast->what == Contrast::What::cut) {
        return tree->grafted == 0 ? "" : "╌ cut away by the change (Esc lets go)";
    }
    return "≠ differs   ~ follows   − missing   + extra";
}

const TreeRay<double>* selected_and_found(const State& state) {
    const TreeRay<double>* const ray = state.selected();
    return ray && is_found(state.playback(), ray->id) ? ray : nullptr;
}

std::vector<SceneLabel> scene_labels(const State& state, const Extent& extent, const View& view,
                                     bool from_the_eye) {
    std::vector<SceneLabel> labels;
    if (!state.document()) {
        return labels;
    }
    const Scene& scene = state.document()->scene();
    const TreeRay<double>* const ray = selected_and_found(state);
    if (state.thing() && state.thing()->kind == Thing::Kind::object) {
        const QString name = qt(name_of(scene, *state.thing()));
        const Point3 at = middle_of(corners_of(*state.document(), extent, *state.thing()));
        const auto part = is_outside(view, at) ? seen_point(*state.document(), view, *state.thing())
                                               : std::nullopt;
        labels.push_back({part.value_or(at), name, true, std::nullopt, name});
    }
    // One that is seen to go out of the view needs no arrow.
    const bool from_outside = ray && ray->parent && is_outside(view, ray->origin);
    const QString away = from_outside && !state.thing() ? qt(title_of(*ray)) : QString();
    if (ray && ray->hit) {
        if (object_named(scene, ray->hit->object) != state.thing()) {
            labels.push_back({ray->hit->point, qt(ray->hit->object), true, std::nullopt, away});
        }
        if (state.look().angles) {
            labels.push_back({normal_tip(*ray->hit, extent, view), QStringLiteral("n"), false});
        }
    } else if (ray && ray->shadow && ray->shadow->blocked_by) {
        labels.push_back({along(ray->origin, ray->shadow->blocked_by->t, ray->direction),
                          qt(ray->shadow->blocked_by->object), true, std::nullopt, away});
    } else if (ray) {
        labels.push_back({ray->origin, QString(), true, std::nullopt, away});
    }
    for (const ExplainedMark& mark : explained_marks(state, extent)) {
        labels.push_back({mark.at, qt(mark.words), true});
    }
    add_marks(labels, state, extent);
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        const bool chosen = state.thing() == Thing{Thing::Kind::light, k};
        const QString name = qt(scene.lights[k].name);
        labels.push_back({place_of(scene.lights[k], extent), name, chosen, std::nullopt,
                          chosen ? name : QString()});
    }
    if (!from_the_eye) {
        labels.push_back({scene.camera.eye, QStringLiteral("eye"), false});
        labels.push_back({picture_corners(*state.document(), extent.plane_distance)[0],
                          QStringLiteral("picture"), false});
    }
    return labels;
}

}  // namespace raytree::inspector
