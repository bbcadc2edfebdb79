#include <doctest/doctest.h>

#include <algorithm>

#include "check/check.h"
#include "check/describe.h"
#include "check/support.h"
#include "tree/record.h"

namespace raytree::test {
namespace {

struct Case {
    Scene scene = data_scene("glass-ball");
    check::Checker checker{scene, options()};
    RayTree<double> tree = record_tree(World<double>(scene), 210, 286);

    static check::CheckOptions options() {
        check::CheckOptions options;
        options.profile = "lecture";
        return options;
    }
    std::size_t first(RayKind kind) const {
        for (const TreeRay<double>& ray : tree.rays) {
            if (ray.kind == kind) {
                return ray.id;
            }
        }
        return 0;
    }
};

TEST_CASE("one wrong number in the middle is one cause, and what is right stays right") {
    Case c;
    const std::size_t ray = c.first(RayKind::refracted);
    c.tree.rays[ray].hit->t *= 1.1;
    const check::Report report = check_tree(c.checker, c.tree);
    CAPTURE(in_words(report));
    CHECK(report.verdict == check::Verdict::fail);
    CHECK(report.causes() == 1);
    CHECK(report.findings.front().ray == ray);
    CHECK(report.findings.front().field == Field::t);
    CHECK(report.mistakes.empty());  // no formula gives this: nobody is accused
}

TEST_CASE("what one factor explains is named, but not with sure") {
    Case c;
    const std::size_t lights = c.scene.lights.size();
    REQUIRE(lights == 2);
    for (TreeRay<double>& ray : c.tree.rays) {
        ray.ambient = 2.0 * ray.ambient;
    }
    const check::Report twice = check_tree(c.checker, c.tree);
    CAPTURE(in_words(twice));
    REQUIRE(!twice.mistakes.empty());  // that it is added for each light gives these numbers too
    CHECK(!twice.mistakes.front().sure);
    CHECK(std::ranges::any_of(twice.remarks, [](const std::string& remark) {
        return remark.find("2 times what it must be") != std::string::npos;
    }));
    for (TreeRay<double>& ray : c.tree.rays) {
        ray.ambient = Rgb<double>(0);
    }
    const check::Report none = check_tree(c.checker, c.tree);
    REQUIRE(!none.mistakes.empty());
    CHECK(none.mistakes.front().id == "lit.ambient_missing");
    CHECK(none.mistakes.front().sure);
}

TEST_CASE("a missing branch is missed once, and its parent's intensity is not held against it") {
    Case c;
    const std::size_t gone = c.first(RayKind::reflected);
    const std::size_t parent = *c.tree.rays[gone].parent;
    std::vector<bool> drop(c.tree.rays.size());
    RayTree<double> less = c.tree;
    less.rays.clear();
    std::vector<std::size_t> place(c.tree.rays.size());
    for (const TreeRay<double>& ray : c.tree.rays) {
        drop[ray.id] = ray.id == gone || (ray.parent && drop[*ray.parent]);
        if (!drop[ray.id]) {
            place[ray.id] = less.rays.size();
            TreeRay<double> kept = ray;
            kept.id = less.rays.size();
            kept.parent = ray.parent ? std::optional(place[*ray.parent]) : std::nullopt;
            less.rays.push_back(kept);
        }
    }
    const check::Report report = check_tree(c.checker, less);
    CAPTURE(in_words(report));
    CHECK(report.causes() == 1);
    CHECK(report.findings.front().problem == check::Problem::missing);
    CHECK(report.findings.front().kind == RayKind::reflected);
    CHECK(report.findings.front().ray == parent);
}

TEST_CASE("what follows from a wrong direction says so") {
    Case c;
    // A program whose first refracted ray goes astray, and which is right in all that follows.
    const std::size_t ray = c.first(RayKind::refracted);
    c.tree.rays[ray].direction =
        UnitVec3<double>::of(c.tree.rays[ray].direction + Vec3<double>(1e-3, 0, 0));
    c.tree.rays.resize(ray + 1);
    c.tree.rays[ray].hit.reset();
    check::Submission submission =
        check::parse_submission(R"({"format": "raytree/1.0", "pixel": [210, 286], "rays": [
            {"id": "eye", "kind": "primary"}]})",
                                "s.json");
    const check::Report report = c.checker.check(submission);
    CHECK(report.verdict == check::Verdict::fail);
    const check::Report astray = check_tree(c.checker, c.tree);
    CAPTURE(in_words(astray));
    CHECK(astray.findings.front().field == Field::direction);
    CHECK(astray.findings.front().ray == ray);
}

TEST_CASE("an export without unit directions, and one with offset origins, are right") {
    Case c;
    RayTree<double> offset = c.tree;
    for (TreeRay<double>& ray : offset.rays) {
        if (ray.kind == RayKind::shadow) {
            ray.origin += 1e-4 * ray.direction;
            if (ray.shadow->distance) {
                *ray.shadow->distance -= 1e-4;
            }
        }
        if (ray.kind == RayKind::refracted || ray.kind == RayKind::reflected) {
            ray.origin += 1e-4 * ray.direction;
            if (ray.hit) {
                ray.hit->t -= 1e-4;
            }
        }
    }
    const check::Report report = check_tree(c.checker, offset);
    CAPTURE(in_words(report));
    CHECK(report.verdict == check::Verdict::pass);
}

TEST_CASE("what a submission is called cannot make a report say more than text") {
    CHECK(check::harmless("a\nb\x1b[2J") == "a\uFFFDb\uFFFD[2J");
    CHECK(check::harmless(std::string(1000, 'x')).size() < 400);
}

}  // namespace
}  // namespace raytree::test
