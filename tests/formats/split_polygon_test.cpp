#include "formats/split_polygon.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace raytree {
namespace {

double area_of(const std::vector<Polygon>& triangles) {
    double area = 0;
    for (const Polygon& triangle : triangles) {
        const auto& v = triangle.vertices;
        REQUIRE(v.size() == 3);
        area += length(outer(v[1] - v[0], v[2] - v[0])) / 2;
    }
    return area;
}

TEST_CASE("a convex polygon is fanned from its first vertex") {
    const Polygon square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                         {{0, 0, 1}, {0, 0, 2}, {0, 0, 3}, {0, 0, 4}}};
    const auto triangles = split_into_triangles(square);
    REQUIRE(triangles.size() == 2);
    CHECK(triangles[0].vertices == std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
    CHECK(triangles[0].normals == std::vector<Point>{{0, 0, 1}, {0, 0, 2}, {0, 0, 3}});
    CHECK(triangles[1].vertices == std::vector<Point>{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}});
}

TEST_CASE("triangles cover a concave polygon and no more, whichever way it runs") {
    // A comb of two teeth: 5 x 1, and two teeth of 1 x 2 on it.
    Polygon comb{
        {{0, 0, 0}, {5, 0, 0}, {5, 3, 0}, {4, 3, 0}, {4, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}},
        {}};
    CHECK(area_of(split_into_triangles(comb)) == doctest::Approx(9));
    std::reverse(comb.vertices.begin(), comb.vertices.end());
    const auto triangles = split_into_triangles(comb);
    CHECK(triangles.size() == 6);
    CHECK(area_of(triangles) == doctest::Approx(9));
}

TEST_CASE("vertices on a line, twice there or on a crossing outline come to an end") {
    const Polygon redundant{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, {}};
    CHECK(area_of(split_into_triangles(redundant)) == doctest::Approx(4));
    const Polygon crossing{{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}, {4, 2, 1}}, {}};
    CHECK(!split_into_triangles(crossing).empty());
}

}  // namespace
}  // namespace raytree
