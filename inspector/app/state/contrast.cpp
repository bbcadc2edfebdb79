#include "state/contrast.h"

#include <algorithm>

#include "check/align.h"
#include "check/check.h"
#include "check/conventions.h"
#include "check/describe.h"
#include "check/forge.h"
#include "check/rulebook.h"
#include "scene/plan.h"
#include "state/contrast_lines.h"
#include "tree/error_bounds.h"
#include "tree/explain.h"
#include "tree/record.h"

namespace raytree::inspector {
namespace {

/// Appends the rays that only `other` has to where they would have been sent from.
void graft(PixelTree& shown, Contrast& contrast) {
    const check::Alignment found = check::align(shown.tree, contrast.other);
    contrast.counterparts = found.of_first;
    std::vector<std::optional<std::size_t>> place = found.of_second;
    for (const TreeRay<double>& ray : contrast.other.rays) {
        if (place[ray.id] || !ray.parent || !place[*ray.parent]) {
            continue;
        }
        TreeRay<double> added = ray;
        added.id = shown.tree.rays.size();
        added.parent = place[*ray.parent];
        place[ray.id] = added.id;
        shown.children[*added.parent].push_back(added.id);
        shown.children.emplace_back();
        shown.tree.rays.push_back(std::move(added));
        contrast.counterparts.push_back(ray.id);
        ++shown.grafted;
    }
}

/// A file need not say where its rays are: they are drawn where those of the truth are that they
/// correspond to, or go on from the hit that sent them. No view tells such a number as the file's.
void place(RayTree<double>& theirs, const check::Submission& recorded, const RayTree<double>& truth,
           const std::vector<std::optional<std::size_t>>& counterparts) {
    for (TreeRay<double>& ray : theirs.rays) {
        const auto gives = [&](Field field) { return recorded.gives(ray.id, field); };
        const TreeRay<double>* const true_ray =
            counterparts[ray.id] ? &truth.rays[*counterparts[ray.id]] : nullptr;
        const TreeRay<double>* const parent = ray.parent ? &theirs.rays[*ray.parent] : nullptr;
        if (!gives(Field::origin)) {
            ray.origin = parent && parent->hit ? parent->hit->point
                         : true_ray            ? true_ray->origin
                                               : truth.rays.front().origin;
        }
        if (!gives(Field::direction) && true_ray) {
            ray.direction = true_ray->direction;
        }
        if (ray.hit && true_ray && true_ray->hit) {
            TreeHit<double>& hit = *ray.hit;
            if (!gives(Field::t)) {
                hit.t = gives(Field::point) ? length(hit.point - ray.origin) : true_ray->hit->t;
            }
            if (!gives(Field::normal)) {
                hit.normal = true_ray->hit->normal;
            }
        }
        if (ray.hit && !gives(Field::point)) {
            ray.hit->point = along(ray.origin, ray.hit->t, ray.direction);
        }
        if (ray.shadow && true_ray && true_ray->shadow && !gives(Field::distance)) {
            ray.shadow->distance = true_ray->shadow->distance;
        }
    }
}

/// The truth by the conventions of whoever recorded the tree.
PixelTree truth_for(const TreeSource& source, const check::Choices& conventions) {
    const check::Rulebooks books(source.document->scene(),
                                 source.document->loaded().format == SceneFormat::course_text);
    check::Choices choices = books.lecture().choices;
    for (const check::Convention* const convention : conventions) {
        choices = check::with_choice(
            choices, std::string(convention->axis) + "=" + std::string(convention->value));
    }
    const check::Rulebook& book = books.of(choices);
    PixelTree tree;
    tree.tree = check::forge_tree(book.place, book.laws, source.pixel.i, source.pixel.j);
    tree.children = children_of(tree.tree);
    return tree;
}

void add_bounds(PixelTree& tree, const TreeSource& source) {
    constexpr std::size_t most =
        3000;  // rays: each is looked around of in the reference arithmetic
    if (source.bounds && tree.tree.rays.size() <= most) {
        tree.bounds = std::make_shared<const std::vector<RayBounds>>(
            error_bounds(source.document->world(), source.document->reference(), tree.tree,
                         Real<double>::unit_roundoff));
    }
}

/// A pixel whose tree has no finite intensity has none to show.
void add_neighbours(PixelTree& tree, const TreeSource& source, const std::stop_token& stop) {
    for (const Pixel pixel :
         neighbours_of(source.pixel, source.neighbours, source.document->scene().camera)) {
        try {
            tree.neighbours.push_back(
                std::make_shared<const PixelTree>(tree_from({source.document, pixel}, stop)));
        } catch (const InputError&) {
        }
    }
}

/// Holds the recorded tree against the truth.
check::Report judged(const TreeSource& recorded, const TreeSource& traced) {
    check::CheckOptions options;
    options.course_text = traced.document->loaded().format == SceneFormat::course_text;
    const check::Checker checker(traced.document->scene(), options);
    return checker.check(*recorded.recorded);
}

}  // namespace

PixelTree tree_from(const TreeSource& source, const std::stop_token& stop) {
    PixelTree tree;
    if (source.recorded) {
        tree.tree = source.recorded->tree;
        tree.recorded = source.recorded;
        if (tree.tree.counts.full_tree == 0) {  // the file has no settings: the scene has them
            const Scene& scene = source.document->scene();
            tree.tree.settings = scene.settings;
            tree.tree.counts.lights = scene.lights.size();
            tree.tree.counts.full_tree = full_tree_rays(scene);
        }
    } else {
        tree.tree = record_tree(source.document->world(), source.pixel.i, source.pixel.j, stop);
        tree.tree.scene_sha256 = source.document->loaded().sha256;
    }
    tree.children = children_of(tree.tree);
    if (!source.recorded) {
        add_bounds(tree, source);
        add_neighbours(tree, source, stop);
    }
    return tree;
}

PixelTree laid_over(const TreeSource& shown_source, const Comparison& with,
                    const std::stop_token& stop) {
    auto contrast = std::make_shared<Contrast>();
    contrast->what = with.what;
    contrast->shown_name = shown_source.name;
    contrast->other_name = with.other.name;
    contrast->shown_is_reference = with.shown_is_reference;
    contrast->other_recorded = with.other.recorded;

    std::optional<check::Report> report;
    const bool shown_is_recorded = shown_source.recorded != nullptr;
    if (shown_is_recorded != (with.other.recorded != nullptr)) {
        report =
            shown_is_recorded ? judged(shown_source, with.other) : judged(with.other, shown_source);
    }
    const bool by_conventions =
        report && !report->conventions.empty() && report->verdict != check::Verdict::unreadable;
    const auto tree_of = [&](const TreeSource& source) {
        return by_conventions && !source.recorded ? truth_for(source, report->conventions)
                                                  : tree_from(source, stop);
    };
    PixelTree shown = tree_of(shown_source);
    contrast->other = tree_of(with.other).tree;
    if (shown_is_recorded != (with.other.recorded != nullptr)) {
        const check::Alignment found = check::align(shown.tree, contrast->other);
        shown_is_recorded
            ? place(shown.tree, *shown.recorded, contrast->other, found.of_first)
            : place(contrast->other, *with.other.recorded, shown.tree, found.of_second);
    }
    graft(shown, *contrast);
    if (report) {
        mark_by_findings(shown, *contrast, *report, shown_is_recorded);
    } else {
        mark_by_numbers(shown, *contrast);
    }
    shown.contrast = std::move(contrast);
    return shown;
}

}  // namespace raytree::inspector
