#include "check/evidence.h"

#include <doctest/doctest.h>

namespace raytree::test {
namespace {

check::Finding cause(check::Problem problem, Field field = Field::intensity) {
    check::Finding finding;
    finding.problem = problem;
    finding.field = field;
    finding.found.numbers = {3, {0.1, 0.2, 0.3}};
    return finding;
}

TEST_CASE("evidence: a number is enough to be sure, a few decisions are not") {
    check::Report report;
    CHECK_FALSE(check::is_unmistakable(report));
    for (int decisions = 0; decisions < 3; ++decisions) {
        report.findings.push_back(cause(check::Problem::missing));
        CHECK_FALSE(check::is_unmistakable(report));
    }
    // A number that only follows says no more.
    report.findings.push_back(cause(check::Problem::differs));
    report.findings.back().follows_from = 0;
    CHECK_FALSE(check::is_unmistakable(report));
    report.findings.pop_back();
    SUBCASE("a fourth") {
        report.findings.push_back(cause(check::Problem::differs, Field::transmittance));
        CHECK(check::is_unmistakable(report));
    }
    SUBCASE("a number of its own") {
        report.findings.push_back(cause(check::Problem::differs, Field::diffuse));
        CHECK(check::is_unmistakable(report));
    }
}

TEST_CASE("evidence: a reflected ray that is right but for signs is no more than a decision") {
    check::Finding straight = cause(check::Problem::differs, Field::direction);
    straight.kind = RayKind::reflected;
    straight.expected.numbers = {3, {0.6, 0, 0.8}};
    straight.found.numbers = {3, {0.6, 0, -0.8}};
    check::Report report;
    report.findings = {straight};
    CHECK_FALSE(check::is_unmistakable(report));
    report.findings.front().found.numbers = {3, {0.8, 0, 0.6}};
    CHECK(check::is_unmistakable(report));
}

}  // namespace
}  // namespace raytree::test
