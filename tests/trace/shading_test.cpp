#include "trace/shading.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "trace/media.h"

using namespace raytree;
using doctest::Approx;
using V = Vec3<double>;

namespace {

V unit(double x, double y, double z) { return UnitVec3<double>::of({x, y, z}).vec(); }

}  // namespace

TEST_CASE("shading: a reflected direction makes the same angle on the other side") {
    const V r = reflected_direction<double>(unit(1, -1, 0), {0, 1, 0}).vec();
    CHECK(r.x == Approx(std::sqrt(0.5)));
    CHECK(r.y == Approx(std::sqrt(0.5)));
    const V reversed = reflected_direction<double>(unit(1, -1, 0), {0, -1, 0}).vec();
    CHECK(reversed.y == Approx(r.y));  // the sign of n does not matter
}

TEST_CASE("shading: refraction obeys Snell's law and lies in the plane of incidence") {
    const V n(0, 1, 0);
    for (double degrees = 1; degrees < 90; degrees += 4) {
        const double a = degrees * M_PI / 180;
        const V d(std::sin(a) * 0.6, -std::cos(a), std::sin(a) * 0.8);
        const auto s = snell(1.0, 1.5, d, n);
        CHECK(s.sin2_transmitted == Approx(std::pow(std::sin(a) / 1.5, 2)));
        const V t = refracted_direction(s, d, n).vec();
        const double sine = std::sqrt(t.x * t.x + t.z * t.z);
        CHECK(1.5 * sine == Approx(std::sin(a)));
        CHECK(t.x * 0.8 == Approx(t.z * 0.6));
        CHECK(t.y < 0);
        // Back along the refracted ray, out of the medium.
        const auto back = snell(1.5, 1.0, V(-t), V(-n));
        const V out = refracted_direction(back, V(-t), V(-n)).vec();
        CHECK(length<double>(out + d) < 1e-14);
    }
}

TEST_CASE("shading: beyond the critical angle there is no refracted ray") {
    const double critical = std::asin(1 / 1.5);
    const auto at = [](double angle) {
        return snell(1.5, 1.0, V(std::sin(angle), -std::cos(angle), 0), V(0, 1, 0));
    };
    CHECK_FALSE(at(critical - 1e-9).total_reflection());
    CHECK(at(critical + 1e-9).total_reflection());
    CHECK(at(critical + 1e-9).sin2_transmitted > 1);
}

TEST_CASE("shading: equal indices do not bend a ray, whatever the normal") {
    const V d = unit(0.3, -0.5, 0.2);
    const auto s = snell(1.33, 1.33, d, V(0, 1, 0));
    CHECK(length<double>(refracted_direction(s, d, V(0, 1, 0)).vec() - d) < 1e-15);
}

TEST_CASE("shading: near normal incidence the sine keeps its digits") {
    const double small = 1e-9;
    const auto s = snell(1.0, 1.0, V(small, -1, 0), V(0, 1, 0));
    CHECK(s.sin2_transmitted == Approx(1e-18).epsilon(1e-12));
}

TEST_CASE("shading: a direction stays unit over 64 bounces, in every arithmetic") {
    const auto worst = []<class T>(T) {
        std::mt19937_64 random(9);
        std::uniform_real_distribution<double> uniform(-1, 1);
        const auto unit = [&] {
            return UnitVec3<T>::of(
                vector_cast<T>(Vec3<double>(uniform(random), uniform(random), uniform(random))));
        };
        T largest = 0;
        for (int path = 0; path < 50; ++path) {
            Vec3<T> d = unit();
            for (int bounce = 0; bounce < 64; ++bounce) {
                Vec3<T> n = unit();
                n = inner(d, n) < 0 ? n : Vec3<T>(-n);
                const Snell<T> into = snell(T(1), T(1.5), d, n);
                d = bounce % 2 == 0 ? reflected_direction(d, n).vec()
                                    : refracted_direction(into, d, n).vec();
                const Quad square = inner(vector_cast<Quad>(d), vector_cast<Quad>(d));
                largest = max_of(largest, static_cast<T>(abs(sqrt(square) - 1)));
            }
        }
        return static_cast<double>(largest / Real<T>::unit_roundoff);
    };
    CHECK(worst(1.0F) <= 4);
    CHECK(worst(1.0) <= 4);
}

TEST_CASE("shading: attenuation never amplifies") {
    const WorldAttenuation<double> f{0.5, 0.1, 0.01};
    CHECK(f.at(0) == 1);
    CHECK(f.at(10) == Approx(1 / 2.5));
    const WorldAttenuation<double> inverse_square{0, 0, 1};
    CHECK(inverse_square.at(0.1) == 1);
    CHECK(inverse_square.at(4) == 0.0625);
}

TEST_CASE("media: leaving takes out the most recent entry of that material alone") {
    Media media;
    for (const std::uint32_t m : {1U, 2U, 1U, 3U}) {
        media.enter(m);
    }
    media.leave(1);
    REQUIRE(media.size() == 3);
    CHECK(media[0] == 1);
    CHECK(media[1] == 2);
    CHECK(media.last() == 3);
    media.leave(7);
    CHECK(media.size() == 3);
    const Media copy = media;
    CHECK(copy.size() == 3);
    CHECK(copy.last() == 3);
}
