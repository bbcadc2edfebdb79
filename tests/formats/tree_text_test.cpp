#include "formats/tree_text.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>

#include "formats/styled_text.h"
#include "support/example_tree.h"

using namespace raytree;

namespace {

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        lines.push_back(line);
    }
    return lines;
}

}  // namespace

TEST_CASE("the outline of a small tree is as worked out by hand") {
    const std::string expected = R"(The ray tree of pixel 3,4 of example

pixel  (0.425, 0.325, 0.375), in 8 bits (108, 83, 96)
rays   5: 1 primary, 1 reflected, 1 refracted, 2 shadow; 2 levels
bound  at most 21 rays = (2 lights + 1) (2³ − 1) for 3 levels; here 23.81 % of them
tests  12 of a ray with a shape
f(t)   min(1, 1 / (1 + 0.5 t)), t the way of a reflected or refracted ray to its hit

I = ambient + diffuse + specular + kr·f·Ir + kt·f·It for (red, green, blue), one number where the
three are equal. A term without its ray and an f of 1 are left out. The share of a ray is what its
f·I is multiplied by on the way to the pixel. Numbers have 4 digits; those with fewer are exact.

#0 primary ray hits ball (glass) at t = 4, on its front
│  point  (0, 0, 1); 36.87° from the normal (0.6, 0, 0.8)
│  η      1 → 1.5, 36.87° → 23.58° from the normal
│  share  1 of the pixel
│         I     = ambient + diffuse + specular + kr·Ir    + kt·f·It
│  red    0.425 = 0.1     + 0.2     + 0        + 0.25·0.4 + 0.5·0.5·0.1
│  green  0.325 = 0.1     + 0.1     + 0        + 0.25·0.4 + 0.5·0.5·0.1
│  blue   0.375 = 0.1     + 0.05    + 0        + 0.25·0.8 + 0.5·0.5·0.1
├─ #1 shadow ray to key reaches it, 7 away
│     adds   diffuse (0.2, 0.1, 0.05) + specular 0
├╌ no shadow ray to sun: the light is behind the surface: n · L ≤ 0, so it adds nothing here
│
├─ #2 reflected ray escapes
│     share  0.25 of the pixel
│     I      (0.4, 0.4, 0.8), the background
│     ends   it meets nothing: the background is seen
│
└─ #3 refracted ray hits ball (glass) at t = 2, on its back
   │  point  (0, 0, -1); 53.13° from the normal (0, 0.8, 0.6)
   │  η      1.5 → 1, 53.13° → none: its sin² would be 1.44 > 1; the critical angle is 41.81°
   │  share  0.5 of the pixel; f(2) = 0.5
   │         I   = ambient + diffuse + specular
   │  each   0.1 = 0.1     + 0       + 0
   │  ends   no branch is sent: its share of the pixel would be below min_weight in every channel
   │         (reflected 0.0625, min_weight = 0.1)
   ├─ #4 shadow ray to key is blocked by wall at t = 3; the light is 9 away
   ├╌ no shadow ray to sun: the light is behind the surface: n · L ≤ 0, so it adds nothing here
   ├╌ no reflected ray: its share of the pixel would be below min_weight in every channel (0.0625 at
   │  most, min_weight = 0.1)
   └╌ no refracted ray: total internal reflection: sin² of the refracted angle would exceed 1
)";
    CHECK(write_tree_text(test::example_tree()) == expected);
}

TEST_CASE("colours change nothing but the colours") {
    std::string coloured = write_tree_text(test::example_tree(), {.colour = true});
    CHECK(contains(coloured, "\x1b[1;38;5;166mreflected ray\x1b[0m"));
    std::string plain;
    for (std::size_t k = 0; k < coloured.size(); ++k) {
        if (coloured[k] == '\x1b') {
            k = coloured.find('m', k);
        } else {
            plain += coloured[k];
        }
    }
    // Blanks at the ends of lines are where a colour stops; they do not show.
    std::string trimmed;
    for (std::string line : lines_of(plain)) {
        line.erase(line.find_last_not_of(' ') + 1);
        trimmed += line + "\n";
    }
    CHECK(trimmed == write_tree_text(test::example_tree()));
}

TEST_CASE("lines keep to the width") {
    for (const int width : {80, 100, 120}) {
        for (const std::string& line :
             lines_of(write_tree_text(test::example_tree(), {.width = width}))) {
            CHECK(columns_of(line) <= static_cast<std::size_t>(width));
        }
    }
}

TEST_CASE("what the pixel clamps is said") {
    RayTree<double> tree = test::example_tree();
    CHECK_FALSE(contains(write_tree_text(tree), "clamped"));
    tree.intensity = {1.5, 0.5, 1.25};
    CHECK(contains(write_tree_text(tree),
                   "(1.5, 0.5, 1.25), in 8 bits (255, 128, 255); clamped to the range 0 to 1: "
                   "red, blue"));
}

TEST_CASE("an opaque surface says once that it sends neither branch") {
    RayTree<double> tree = test::example_tree();
    TreeRay<double>& ray = tree.rays[3];
    ray.termination = Reason::opaque;
    ray.skipped = {{RayKind::reflected, "", Reason::not_reflective},
                   {RayKind::refracted, "", Reason::not_transmissive}};
    const std::string text = write_tree_text(tree);
    CHECK(contains(text, "no branch is sent: the surface neither reflects nor lets light through"));
    CHECK_FALSE(contains(text, "no reflected ray"));
    CHECK_FALSE(contains(text, "no refracted ray"));
}

TEST_CASE("total reflection that takes kt along says so") {
    RayTree<double> tree = test::example_tree();
    tree.settings.total_internal_reflection = TotalReflection::reflect;
    const auto text = [&] { return write_tree_text(tree, {.width = 200}); };
    for (TreeRay<double>& ray : tree.rays) {
        if (ray.hit && ray.hit->interface && ray.hit->interface->sin2_transmitted > 1) {
            ray.hit->kt = Rgb<double>(0);  // there is nothing to be added
        }
    }
    CHECK_FALSE(contains(text(), "kt is added to kr"));
    for (TreeRay<double>& ray : tree.rays) {
        if (ray.hit && ray.hit->interface && ray.hit->interface->sin2_transmitted > 1) {
            ray.hit->kt = Rgb<double>(0.5);
        }
    }
    CHECK(contains(text(), "the critical angle is 41.81°; kt is added to kr"));
}

TEST_CASE("without shadow rays the outline says how lights are seen") {
    RayTree<double> tree = test::example_tree();
    tree.settings.shadows = ShadowMode::none;
    CHECK(
        contains(write_tree_text(tree), "shadow none: every light in front of a surface is seen"));
}

TEST_CASE("a deep tree keeps its shape, beyond the width if it must") {
    RayTree<double> tree = test::example_tree();
    const TreeRay<double> below = tree.rays[3];
    tree.rays.resize(1);
    tree.rays[0].skipped.clear();
    for (std::size_t k = 1; k < 64; ++k) {
        TreeRay<double> ray = below;
        ray.id = k;
        ray.parent = k - 1;
        ray.level = static_cast<int>(k + 1);
        ray.skipped.clear();
        ray.termination = k == 63 ? below.termination : std::nullopt;
        tree.rays.push_back(ray);
    }
    const std::string text = write_tree_text(tree);
    CHECK(contains(text, "\n" + std::string(3 * 62, ' ') + "└─ #63 refracted ray"));
    CHECK(contains(text, "│  each   0.1 = 0.1     + 0       + 0        + 0.5·0.5·0.1\n"));
}

TEST_CASE("a sum that is too long goes on below, term under symbol") {
    RayTree<double> tree = test::example_tree();
    const std::string text = write_tree_text(tree, {.width = 70});
    CHECK(contains(text,
                   "│         I     = ambient + diffuse + specular + kr·Ir\n"
                   "│  red    0.425 = 0.1     + 0.2     + 0        + 0.25·0.4\n"));
    CHECK(contains(text,
                   "│               + kt·f·It\n"
                   "│  red          + 0.5·0.5·0.1\n"));
}

TEST_CASE("names from a file cannot steer the terminal") {
    RayTree<double> tree = test::example_tree();
    tree.rays[0].hit->object = "\x1b[2Jball\n";
    const std::string text = write_tree_text(tree);
    CHECK_FALSE(contains(text, "\x1b"));
    CHECK(contains(text, "hits \uFFFD[2Jball\uFFFD (glass)"));
}

TEST_CASE("an empty tree is a header") {
    CHECK(contains(write_tree_text({}), "rays   0: 0 primary"));
}
