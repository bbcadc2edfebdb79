#include <doctest/doctest.h>

#include "check/check.h"
#include "check/support.h"
#include "formats/tree_json.h"
#include "trace/world.h"
#include "tree/record.h"

namespace raytree::test {
namespace {

check::Report by_the_lecture(const Scene& scene, const RayTree<double>& tree) {
    check::CheckOptions options;
    options.profile = "lecture";
    return check_tree(check::Checker(scene, options), tree);
}

}  // namespace

// A program without an offset meets the surface that a ray starts on only where rounding has put
// the start behind it: at some hits and not at others.
TEST_CASE("shadow rays that sometimes meet their own start are named") {
    Scene scene = data_scene("glass-ball");
    RayTree<double> tree = record_tree(World<double>(scene), 210, 286);
    int lit = 0, spoilt = 0;
    for (TreeRay<double>& ray : tree.rays) {
        const bool seen = ray.shadow && !ray.shadow->blocked_by;
        if (!seen || lit++ % 2 == 1) {
            continue;
        }
        // The light of this shadow ray is lost, and with it its share of every ray above.
        ++spoilt;
        ray.shadow->blocked_by = {tree.rays[*ray.parent].hit->object, 3e-17};
        ray.shadow->transmittance = Rgb<double>(0.0);
        const Rgb<double> lost = ray.diffuse + ray.specular;
        TreeRay<double>* at = &tree.rays[*ray.parent];
        at->diffuse += -1.0 * ray.diffuse;
        at->specular += -1.0 * ray.specular;
        Rgb<double> share = lost;
        while (true) {
            at->intensity += -1.0 * share;
            if (!at->parent) {
                break;
            }
            TreeRay<double>& above = tree.rays[*at->parent];
            const bool mirrored = at->kind == RayKind::reflected;
            share = at->attenuation * ((mirrored ? above.hit->kr : above.hit->kt) * share);
            at = &above;
        }
        ray.diffuse = ray.specular = Rgb<double>(0.0);
    }
    tree.intensity = tree.rays.front().intensity;
    REQUIRE(spoilt >= 2);
    const check::Report report = by_the_lecture(scene, tree);
    REQUIRE_FALSE(report.mistakes.empty());
    CHECK(report.mistakes.front().id == "shd.no_offset");
}

}  // namespace raytree::test
