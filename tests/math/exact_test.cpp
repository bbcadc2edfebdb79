#include "math/exact.h"

#include <doctest/doctest.h>

#include <random>

#include "math/vector.h"

using namespace raytree;

namespace {

// GCC 12 at -O2 drops the rounding to float of straight-line code like this unless it is told not
// to vectorise it; the library's mixed precision depends on its being kept.
struct TwoDoubles {
    double a, b;
};
[[gnu::noinline]] TwoDoubles through_float(double a, double b) {
    const auto x = static_cast<float>(a);
    const auto y = static_cast<float>(b);
    return {static_cast<double>(x), static_cast<double>(y)};
}

}  // namespace

TEST_CASE("exact: the compiler keeps the rounding of double to float") {
    const TwoDoubles r = through_float(0.1, 0.2);
    CHECK(r.a == 0.100000001490116119384765625);  // the float nearest to 0.1, written out
    CHECK(r.b == 0.20000000298023223876953125);
}

TEST_CASE("exact: a product is not contracted into a sum") {
    volatile double a = 1 + 0x1p-30;
    volatile double product = (1 + 0x1p-30) * (1 + 0x1p-30);
    CHECK(a * a - product == 0.0);
}

TEST_CASE("exact: the difference of products keeps its digits where its terms cancel") {
    // 1 + 2^-52 squared exceeds (1 + 2^-51) * 1 by 2^-104 exactly.
    const double a = 1 + 0x1p-52;
    CHECK(difference_of_products(a, a, 1 + 0x1p-51, 1.0) == 0x1p-104);
    CHECK(a * a - (1 + 0x1p-51) * 1.0 == 0.0);
}

TEST_CASE("exact: the difference of products is within 1.5 ulp of the reference") {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> near_one(1, 1 + 1e-9);
    for (int k = 0; k < 10'000; ++k) {
        const double a = near_one(random), b = near_one(random);
        const double c = near_one(random), d = near_one(random);
        const Quad exact = Quad(a) * b - Quad(c) * d;
        const Quad error = abs(Quad(difference_of_products(a, b, c, d)) - exact);
        CHECK(error <= abs(exact) * 1.5 * 0x1p-52);
    }
}

TEST_CASE("exact: sums and products come with their error") {
    const auto sum = two_sum(1.0, 0x1p-60);
    CHECK(sum.value == 1.0);
    CHECK(sum.error == 0x1p-60);
    const auto product = two_product(1 + 0x1p-30, 1 + 0x1p-30);
    CHECK(product.value + product.error == product.value);
    CHECK(product.error == 0x1p-60);
}

TEST_CASE("vector: length neither overflows nor underflows") {
    CHECK(length(Vec3<double>(3e200, 4e200, 0)) == doctest::Approx(5e200));
    CHECK(length(Vec3<double>(3e-200, 0, 4e-200)) == doctest::Approx(5e-200));
    CHECK(length(Vec3<double>(0, 0, 0)) == 0);
}

TEST_CASE("vector: a unit vector has length 1, in every arithmetic") {
    const auto d = UnitVec3<double>::of({1e-200, 2e-200, -2e-200});
    CHECK(d.vec().x == doctest::Approx(1.0 / 3).epsilon(1e-15));
    CHECK(d.vec().z == doctest::Approx(-2.0 / 3).epsilon(1e-15));
    const auto q = UnitVec3<Quad>::of({1, 1, 1});
    CHECK(static_cast<double>(abs(inner(q, q) - 1)) < 1e-33);
}
