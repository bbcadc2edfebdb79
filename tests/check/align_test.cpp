#include "check/align.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "check/support.h"
#include "tree/explain.h"
#include "tree/record.h"

namespace raytree::test {
namespace {

using check::align;
using check::Alignment;

RayTree<double> glass_ball_tree() {
    const Scene scene = data_scene("glass-ball");
    return record_tree(World<double>(scene), 210, 286);
}

/// Without a ray and all that was sent from where it went; ids and parents anew.
RayTree<double> without(const RayTree<double>& tree, std::size_t cut) {
    RayTree<double> rest = tree;
    rest.rays.clear();
    std::vector<std::optional<std::size_t>> place(tree.rays.size());
    for (const TreeRay<double>& ray : tree.rays) {
        if (ray.id == cut || (ray.parent && !place[*ray.parent])) {
            continue;
        }
        place[ray.id] = rest.rays.size();
        rest.rays.push_back(ray);
        rest.rays.back().id = *place[ray.id];
        if (ray.parent) {
            rest.rays.back().parent = place[*ray.parent];
        }
    }
    return rest;
}

std::size_t first_of(const RayTree<double>& tree, RayKind kind) {
    return std::ranges::find(tree.rays, kind, &TreeRay<double>::kind)->id;
}

TEST_CASE("align: a tree corresponds to itself ray by ray, and nothing differs") {
    const RayTree<double> tree = glass_ball_tree();
    const Alignment found = align(tree, tree);
    for (std::size_t ray = 0; ray < tree.rays.size(); ++ray) {
        CHECK(found.of_first[ray] == ray);
        CHECK(found.of_second[ray] == ray);
        CHECK(check::differences(tree, ray, tree, ray, 0).empty());
    }
}

TEST_CASE("align: of a tree with a branch cut off, that branch alone has no counterpart") {
    const RayTree<double> tree = glass_ball_tree();
    for (const TreeRay<double>& cut : tree.rays) {
        if (!cut.parent) {
            continue;
        }
        const RayTree<double> rest = without(tree, cut.id);
        const Alignment found = align(tree, rest);
        CHECK(std::ranges::none_of(found.of_second, [](auto& other) { return !other; }));
        for (const TreeRay<double>& ray : tree.rays) {
            bool below = false;
            for (std::optional<std::size_t> at = ray.id; at; at = tree.rays[*at].parent) {
                below |= at == cut.id;
            }
            CHECK(found.of_first[ray.id].has_value() != below);
        }
        for (std::size_t ray = 0; ray < rest.rays.size(); ++ray) {
            CHECK(check::differences(tree, *found.of_second[ray], rest, ray, 0).empty());
        }
    }
}

TEST_CASE("align: shadow rays correspond by their lights, and without names by their order") {
    RayTree<double> tree = glass_ball_tree();
    const auto children = children_of(tree);
    std::vector<std::size_t> two;
    for (const auto& of_one : children) {
        std::vector<std::size_t> shadows;
        std::ranges::copy_if(of_one, std::back_inserter(shadows), [&](std::size_t child) {
            return tree.rays[child].shadow.has_value();
        });
        if (shadows.size() == 2) {
            two = shadows;
        }
    }
    REQUIRE(two.size() == 2);
    RayTree<double> turned = tree;
    std::swap(turned.rays[two[0]].shadow->light, turned.rays[two[1]].shadow->light);
    CHECK(align(tree, turned).of_first[two[0]] == two[1]);
    RayTree<double> nameless = tree;
    for (TreeRay<double>& ray : nameless.rays) {
        if (ray.shadow) {
            ray.shadow->light.clear();
        }
    }
    for (const Alignment& found : {align(tree, nameless), align(nameless, tree)}) {
        CHECK(found.of_first[two[0]] == two[0]);
        CHECK(found.of_first[two[1]] == two[1]);
    }
}

TEST_CASE("align: what differs is told by field, with both values") {
    const RayTree<double> tree = glass_ball_tree();
    const std::size_t ray = first_of(tree, RayKind::refracted);
    RayTree<double> other = tree;
    other.rays[ray].hit->t *= 1.1;
    other.rays[ray].hit->side = tree.rays[ray].hit->side == Side::front ? Side::back : Side::front;
    const auto found = check::differences(tree, ray, other, ray, 1e-9);
    REQUIRE(found.size() == 2);
    CHECK(found[0].field == Field::t);
    CHECK(found[0].error == doctest::Approx(0.1 / 1.1));
    CHECK(found[1].field == Field::side);
    CHECK(found[1].first.word != found[1].second.word);
    CHECK(check::differences(tree, ray, other, ray, 0.2).size() == 1);
}

TEST_CASE("align: a part of an intensity is measured by the whole of it") {
    RayTree<double> tree = glass_ball_tree();
    RayTree<double> other = tree;
    tree.rays[0].intensity = other.rays[0].intensity = {0.5, 0.25, 0.125};
    tree.rays[0].specular = {3e-147, 0, 0};
    other.rays[0].specular = {0, 2e-150, 0};
    CHECK(check::differences(tree, 0, other, 0, 1e-9).empty());
    other.rays[0].specular = {1e-3, 0, 0};
    const auto found = check::differences(tree, 0, other, 0, 1e-9);
    REQUIRE(found.size() == 1);
    CHECK(found[0].field == Field::specular);
    CHECK(found[0].error == doctest::Approx(1e-3 / 0.5));
    // A ray of little intensity is measured by its own, as long as that is seen in the pixel.
    const std::size_t ray = first_of(tree, RayKind::refracted);
    tree.rays[ray].intensity = other.rays[ray].intensity = {1e-8, 1e-8, 1e-8};
    tree.rays[ray].diffuse = {1e-9, 0, 0};
    other.rays[ray].diffuse = {2e-9, 0, 0};
    CHECK(check::differences(tree, ray, other, ray, 1e-9).size() == 1);
    tree.rays[ray].intensity = {1e-147, 0, 0};
    other.rays[ray].intensity = {0, 0, 0};
    tree.rays[ray].diffuse = other.rays[ray].diffuse = {0, 0, 0};
    CHECK(check::differences(tree, ray, other, ray, 1e-9).empty());
}

TEST_CASE("align: a ray that meets nothing differs from one that meets something") {
    const RayTree<double> tree = glass_ball_tree();
    RayTree<double> other = tree;
    other.rays[0].hit.reset();
    const auto found = check::differences(tree, 0, other, 0, 1e-9);
    REQUIRE_FALSE(found.empty());
    CHECK(found[0].field == Field::object);
    CHECK(found[0].second.word == "nothing");
}

}  // namespace
}  // namespace raytree::test
