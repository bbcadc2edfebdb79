#include "tree/explain.h"
#include "tree/eight_bit.h"

#include <doctest/doctest.h>

#include <limits>

#include "support/example_tree.h"

using namespace raytree;

TEST_CASE("numbers have four digits, and fewer where these are all") {
    CHECK(number_text(0) == "0");
    CHECK(number_text(-0.0) == "0");
    CHECK(number_text(1) == "1");
    CHECK(number_text(0.25) == "0.25");
    CHECK(number_text(1.0 / 3) == "0.3333");
    CHECK(number_text(0.50203) == "0.5020");
    CHECK(number_text(-2.0 / 3) == "-0.6667");
    CHECK(number_text(9.99996) == "10.00");
    CHECK(number_text(123.456) == "123.5");
    CHECK(number_text(12345.6) == "12346");
    CHECK(number_text(999999) == "999999");
    CHECK(number_text(1234567) == "1.235e6");
    CHECK(number_text(2e7) == "2e7");
    CHECK(number_text(0.00012346) == "0.0001235");
    CHECK(number_text(0.000012346) == "1.235e-5");
    CHECK(number_text(5e-324) == "4.941e-324");
}

TEST_CASE("rounding errors of a product do not make a number longer") {
    CHECK(number_text(0.1 + 0.2) == "0.3");
    CHECK(number_text(0.1 * 3) == "0.3");
    CHECK(number_text(0.3 + 1e-9) == "0.3000");
}

TEST_CASE("numbers that are not finite are said in words") {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    CHECK(number_text(infinity) == "infinite");
    CHECK(number_text(-infinity) == "-infinite");
    CHECK(number_text(std::numeric_limits<double>::quiet_NaN()) == "not a number");
}

TEST_CASE("triples are one number where the channels look alike") {
    CHECK(triple_text({0.5, 0.5, 0.5}) == "0.5");
    CHECK(triple_text({0.5, 0.5, 0.25}) == "(0.5, 0.5, 0.25)");
    CHECK(point_text({1, 1, 1}) == "(1, 1, 1)");
}

TEST_CASE("angles are in degrees") {
    CHECK(angle_text(0) == "90°");
    CHECK(angle_text(0.5) == "60°");
    CHECK(angle_text(-1) == "180°");
    CHECK(angle_text(1) == "0°");
    CHECK(angle_text(1 + 1e-15) == "0°");
    CHECK(angle_text(1 - 1e-16) == "0°");
}

TEST_CASE("a pixel's bytes are rounded or cut, and clamping is said") {
    const Rgb<double> intensity{0.5, 1.25, -0.1};
    const EightBit rounded = eight_bit(intensity, Quantize::round);
    CHECK(rounded.value == std::array{128, 255, 0});
    CHECK(rounded.clamped == std::array{false, true, true});
    CHECK(eight_bit(intensity, Quantize::floor).value == std::array{127, 255, 0});
    CHECK(eight_bit(Rgb<double>(1), Quantize::round).clamped == std::array{false, false, false});
}

TEST_CASE("refraction is told with indices and angles") {
    const RayTree<double> tree = test::example_tree();
    CHECK(refraction_text(*tree.rays[0].hit) == "1 → 1.5, 36.87° → 23.58° from the normal");
}

TEST_CASE("total internal reflection is told with the sine and the critical angle") {
    const RayTree<double> tree = test::example_tree();
    CHECK(refraction_text(*tree.rays[3].hit) ==
          "1.5 → 1, 53.13° → none: its sin² would be 1.44 > 1; the critical angle is 41.81°");
}

TEST_CASE("the terms of a hit are those of the model, branches last") {
    const RayTree<double> tree = test::example_tree();
    const std::vector<Term> terms = terms_of(tree, tree.rays[0], children_of(tree)[0]);
    REQUIRE(terms.size() == 5);
    CHECK(terms[1].symbols == "diffuse");
    CHECK(terms[1].numbers == std::array<std::string, 3>{"0.2", "0.1", "0.05"});
    CHECK_FALSE(terms[1].grey);
    CHECK(terms[3].symbols == "kr·Ir");
    CHECK(terms[3].numbers[2] == "0.25·0.8");
    CHECK(terms[4].symbols == "kt·f·It");
    CHECK(terms[4].numbers[0] == "0.5·0.5·0.1");
    CHECK(terms[4].grey);
}

TEST_CASE("of a summand that its sum does not notice a text says 0") {
    RayTree<double> tree = test::example_tree();
    tree.rays[0].specular = {2e-141, 0.25, 1e-30};
    const std::vector<Term> terms = terms_of(tree, tree.rays[0], children_of(tree)[0]);
    CHECK(terms[2].numbers == std::array<std::string, 3>{"0", "0.25", "0"});
    // Half a unit in the last place of 1 is what 1 does not notice; a sum of its own size does.
    CHECK(noticed({0x1p-53, 0x1p-52, 1e-141}, {1, 1, 1e-141}) == Rgb<double>(0, 0x1p-52, 1e-141));
}

TEST_CASE("a reason is followed by the numbers behind it") {
    RayTree<double> tree = test::example_tree();
    const TreeRay<double>& ray = tree.rays[3];
    CHECK(skipped_text(tree, ray, ray.skipped[1]) ==
          std::string(text_of(Reason::low_intensity).sentence) +
              " (0.0625 at most, min_weight = 0.1)");
    CHECK(skipped_text(tree, ray, {RayKind::reflected, "", Reason::max_depth}) ==
          std::string(text_of(Reason::max_depth).sentence) + " (max_depth = 3)");
    CHECK(skipped_text(tree, ray, {RayKind::reflected, "", Reason::ray_budget}) ==
          std::string(text_of(Reason::ray_budget).sentence) + " (ray_budget = 1000000)");
    CHECK(ended_text(tree, ray) ==
          "no branch is sent: " + std::string(text_of(Reason::low_intensity).sentence) +
              " (reflected 0.0625, min_weight = 0.1)");
    CHECK(ended_text(tree, tree.rays[0]).empty());
    tree.settings.max_distance = 20;
    tree.rays[2].termination = Reason::max_distance;
    CHECK(ended_text(tree, tree.rays[2]) ==
          std::string(text_of(Reason::max_distance).sentence) + " (max_distance = 20)");
}

TEST_CASE("no number is given for a setting that is not known") {
    RayTree<double> tree = test::example_tree();
    tree.counts.full_tree = 0;
    tree.rays[3].hit->kr = Rgb<double>(0);
    CHECK(skipped_text(tree, tree.rays[3], tree.rays[3].skipped[1]) ==
          text_of(Reason::low_intensity).sentence);
}

TEST_CASE("shadow rays say what became of them") {
    RayTree<double> tree = test::example_tree();
    CHECK(shadow_text(tree.rays[1]) == "reaches it, 7 away");
    CHECK(shadow_text(tree.rays[4]) == "is blocked by wall at t = 3; the light is 9 away");
    CHECK(reaches_light(tree.rays[1]));
    CHECK_FALSE(reaches_light(tree.rays[4]));
    CHECK_FALSE(reaches_light(tree.rays[0]));
    ShadowPart<double>& shadow = *tree.rays[1].shadow;
    shadow.transmittance = {0.5, 0.5, 0.25};
    CHECK(shadow_text(tree.rays[1]) ==
          "reaches it, 7 away, through surfaces that let (0.5, 0.5, 0.25) of the light pass");
    shadow = {"sun", {}, {}, Rgb<double>(0)};
    CHECK(shadow_text(tree.rays[1]) == "does not reach it");
}

TEST_CASE("an end that both branches share says it for both") {
    RayTree<double> tree = test::example_tree();
    TreeRay<double>& ray = tree.rays[3];
    CHECK_FALSE(told_by_termination(ray, ray.skipped[1]));
    ray.skipped[2].reason = Reason::low_intensity;
    CHECK(told_by_termination(ray, ray.skipped[1]));
    CHECK_FALSE(told_by_termination(ray, ray.skipped[0]));
    ray.skipped[1].reason = Reason::not_reflective;
    ray.skipped[2].reason = Reason::not_transmissive;
    ray.termination = Reason::opaque;
    CHECK(told_by_termination(ray, ray.skipped[2]));
}
