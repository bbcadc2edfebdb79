#include "window/scene_labels.h"

#include <algorithm>
#include <cmath>

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

/// Of very many lights, those that stand close together on the screen have one name for all.
void add_lights_seen(std::vector<SceneLabel>& labels, const State& state, const Extent& extent,
                     const View& view) {
    constexpr std::size_t many = 6;
    constexpr double wide = 100, high = 26;  // pixels that a name takes
    struct Group {
        ScreenPoint at;
        std::size_t light, others = 0;
    };
    const std::vector<Light>& lights = state.document()->scene().lights;
    std::vector<Group> groups;
    for (std::size_t k = 0; k < lights.size(); ++k) {
        const Point3 place = place_of(lights[k], extent);
        const QString name = qt(lights[k].name);
        if (state.thing() == Thing{Thing::Kind::light, k}) {
            labels.push_back({place, name, true, std::nullopt, name});
        } else if (const auto at = project(view, place)) {
            const auto near = std::ranges::find_if(groups, [&](const Group& group) {
                return std::abs(group.at.x - at->x) < wide && std::abs(group.at.y - at->y) < high;
            });
            if (lights.size() > many && near != groups.end()) {
                ++near->others;
            } else {
                groups.push_back({*at, k});
            }
        }
    }
    for (const Group& group : groups) {
        QString name = qt(lights[group.light].name);
        if (group.others > 0) {
            name += QStringLiteral(" and %1 more").arg(group.others);
        }
        labels.push_back({place_of(lights[group.light], extent), name});
    }
}

/// The lights to which the shown rays ask their way, in the order of the scene.
std::vector<std::size_t> asked_lights(const State& state) {
    constexpr std::size_t most_rays = 5000;  // that are looked at
    const auto& tree = state.tree();
    const std::vector<Light>& lights = state.document()->scene().lights;
    std::vector<bool> asked(lights.size());
    for (std::size_t k = 0; tree && k < std::min(most_rays, tree->tree.rays.size()); ++k) {
        const TreeRay<double>& ray = tree->tree.rays[k];
        const bool sent = !state.playback() || state.playback()->stage(ray.id) != Stage::unsent;
        if (ray.shadow && sent && shown(state.look().filter, *tree, ray) != Shown::hidden) {
            const auto light = std::ranges::find(lights, ray.shadow->light, &Light::name);
            if (light != lights.end()) {
                asked[static_cast<std::size_t>(light - lights.begin())] = true;
            }
        }
    }
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < asked.size(); ++k) {
        if (asked[k]) {
            places.push_back(k);
        }
    }
    return places;
}

/// Where the light comes from when its lamp is outside the view.
void add_lights_away(std::vector<SceneLabel>& labels, const State& state, const Extent& extent,
                     const View& view) {
    constexpr std::size_t most_arrows = 3;
    const std::vector<Light>& lights = state.document()->scene().lights;
    std::vector<std::size_t> away = asked_lights(state);
    std::erase_if(away, [&](std::size_t k) {
        return state.thing() == Thing{Thing::Kind::light, k} ||
               !is_outside(view, place_of(lights[k], extent));
    });
    for (std::size_t k = 0; k < std::min(away.size(), most_arrows); ++k) {
        QString name = qt(lights[away[k]].name);
        if (k + 1 == most_arrows && away.size() > most_arrows) {
            name += QStringLiteral(" and %1 more lights").arg(away.size() - most_arrows);
        }
        SceneLabel label{place_of(lights[away[k]], extent), {}, false, std::nullopt, name};
        if (const TreeRay<double>* const ray = selected_and_found(state)) {
            label.seen_from = ray->shadow ? ray->origin
                              : ray->hit  ? std::optional(ray->hit->point)
                                          : std::nullopt;
        }
        if (const auto* const sun = std::get_if<DirectionalLight>(&lights[away[k]].kind);
            sun && label.seen_from) {  // its rays are parallel: its mark is on none of them
            label.at =
                *label.seen_from - sun->direction * (3 * extent.diagonal / length(sun->direction));
        }
        labels.push_back(std::move(label));
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
            labels.push_back(
                {ray->hit->point, qt(ray->hit->object), true, std::nullopt, away, {}, true});
        }
        if (state.look().angles) {
            labels.push_back({.at = normal_tip(*ray->hit, extent, view),
                              .text = QStringLiteral("n"),
                              .stem = ray->hit->point});
        }
    } else if (ray && ray->shadow && ray->shadow->blocked_by) {
        labels.push_back({along(ray->origin, ray->shadow->blocked_by->t, ray->direction),
                          qt(ray->shadow->blocked_by->object),
                          true,
                          std::nullopt,
                          away,
                          {},
                          true});
    } else if (ray) {
        labels.push_back({ray->origin, QString(), true, std::nullopt, away});
    }
    for (const ExplainedMark& mark : explained_marks(state, extent)) {
        labels.push_back({mark.at, qt(mark.words), true});
    }
    add_marks(labels, state, extent);
    add_lights_seen(labels, state, extent, view);
    add_lights_away(labels, state, extent, view);
    if (!from_the_eye) {
        labels.push_back({scene.camera.eye, QStringLiteral("eye"), false});
        labels.push_back({picture_corners(*state.document(), extent.plane_distance)[0],
                          QStringLiteral("picture"), false});
    }
    return labels;
}

void mark_hidden(std::vector<SceneLabel>& labels, const Document& document, const View& view) {
    for (SceneLabel& label : labels) {
        label.hidden = is_hidden(document, view, label.at);
    }
}

}  // namespace raytree::inspector
