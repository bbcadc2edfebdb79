#include "math/vector.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

using namespace raytree;

namespace {

/// Components of very unlike sizes, times a power of two.
template <class T> Vec3<T> unlike(int power, int k) {
    const double size = std::ldexp(1.0, power);
    return {static_cast<T>(size * (1 + 0.37 * k)), static_cast<T>(size * -0.013 * (k + 1)),
            static_cast<T>(size * 1.7e-4 * (k + 3))};
}

/// How far a number is from what it is to be, in units of rounding of the latter.
template <class T> double roundings(T number, Quad exact) {
    return static_cast<double>(abs((static_cast<Quad>(number) - exact) / exact)) /
           static_cast<double>(Real<T>::unit_roundoff);
}

template <class T> void check_at(int power) {
    CAPTURE(power);
    for (int k = 0; k < 20; ++k) {
        const Vec3<T> v = unlike<T>(power, k);
        const Quad exact = length(vector_cast<Quad>(v));
        CHECK(roundings(length(v), exact) <= 4);
        const Vec3<T> unit = UnitVec3<T>::of(v).vec();
        for (int axis = 0; axis < 3; ++axis) {
            CHECK(roundings(unit[axis], static_cast<Quad>(v[axis]) / exact) <= 5);
        }
        const Quad of_unit = length(vector_cast<Quad>(unit));
        CHECK(roundings(static_cast<T>(1), of_unit) <= 4);  // two units in the last place
    }
}

}  // namespace

// Whether a vector is scaled first depends on how large it is, how long it is does not.
TEST_CASE("lengths and directions are as good for vectors of every size") {
    for (const int power : {-990, -600, -501, -500, -499, -60, 0, 60, 499, 500, 501, 700, 1000}) {
        check_at<double>(power);
    }
    for (const int power : {-110, -80, -61, -60, -59, -1, 0, 1, 59, 60, 61, 90, 120}) {
        check_at<float>(power);
    }
}

TEST_CASE("the length of what has none, and of what is infinite or no number") {
    const double infinity = Real<double>::infinity;
    CHECK(length(Vec3<double>(0.0)) == 0);
    CHECK(length(Vec3<double>(0, -infinity, 1)) == infinity);
    CHECK(std::isnan(length(Vec3<double>(1, 1, std::nan("")))));
}
