#include "lesson/expression.h"

#include <doctest/doctest.h>

#include <map>

using namespace raytree;
using namespace raytree::lesson;

namespace {

class Names final : public Scope {
  public:
    std::optional<Value> member(std::string_view name) const override {
        const auto found = values.find(std::string(name));
        return found == values.end() ? std::nullopt : std::optional(Value::of(found->second));
    }
    std::vector<std::string> names() const override { return {"x", "v", "list", "thing", "gone"}; }

    std::map<std::string, Json> values = {
        {"x", 4},
        {"v", Json::array({1, 2, 2})},
        {"list", Json::array({{{"name", "a b"}, {"t", 1.5}}, {{"name", "c"}, {"t", 2}}})},
        {"thing", {{"inner", {{"word", "yes"}}}}},
        {"gone", nullptr}};
};

Json value(const char* text) { return Expression(text).data(Names()); }
double number(const char* text) { return Expression(text).number(Names()); }
bool truth(const char* text) { return Expression(text).truth(Names()); }

std::string complaint(const char* text) {
    try {
        Expression(text).data(Names());
    } catch (const ExpressionError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("expression: arithmetic binds as in mathematics") {
    CHECK(number("1 + 2 * 3") == 7);
    CHECK(number("(1 + 2) * 3") == 9);
    CHECK(number("2 - 3 - 4") == -5);
    CHECK(number("12 / 3 / 2") == 2);
    CHECK(number("-2 ^ 2") == -4);
    CHECK(number("2 ^ -1") == 0.5);
    CHECK(number("x * x - 1") == 15);
    CHECK(value("2 * v + [1, 0, 0]") == Json::array({3.0, 4.0, 4.0}));
    CHECK(value("-v") == Json::array({-1.0, -2.0, -2.0}));
}

TEST_CASE("expression: functions") {
    CHECK(number("sqrt(x)") == 2);
    CHECK(number("length(v)") == 3);
    CHECK(number("dot(v, [1, 1, 0])") == 3);
    CHECK(value("cross([1, 0, 0], [0, 1, 0])") == Json::array({0.0, 0.0, 1.0}));
    CHECK(number("sin(30)") == doctest::Approx(0.5));
    CHECK(number("angle(0)") == doctest::Approx(90));
    CHECK(number("max(1, min(5, x))") == 4);
}

TEST_CASE("expression: members, elements, names with blanks") {
    CHECK(value("thing.inner.word") == "yes");
    CHECK(number("list[1].t") == 2);
    CHECK(number("list['a b'].t") == 1.5);
    CHECK(number("list.c.t") == 2);
    CHECK(number("list.count") == 2);
    CHECK(number("v.z") == 2);
}

TEST_CASE("expression: comparisons, with a tolerance where it is said") {
    CHECK(truth("x == 4 and not x == 5"));
    CHECK(truth("x == 4.01 within 0.02"));
    CHECK(!truth("x == 4.01 within 0.001"));
    CHECK(truth("x == 4.01 ± 0.02"));
    CHECK(truth("v == [1, 2, 2.001] within 0.01"));
    CHECK(!truth("v == [1, 2, 2.001]"));
    CHECK(truth("gone == null or gone.t == 1"));
    CHECK(truth("thing.inner.word != 'no'"));
    CHECK(truth("x <= 4 and x >= 4 and not x < 4 and not x > 4"));
}

TEST_CASE("expression: what is wrong is said, with the name that was probably meant") {
    CHECK(complaint("thin.inner").find("did you mean \"thing\"") != std::string::npos);
    CHECK(complaint("thing.iner").find("did you mean \"inner\"") != std::string::npos);
    CHECK(complaint("gone.t").find("not there") != std::string::npos);
    CHECK(complaint("sqr(2)").find("did you mean \"sqrt\"") != std::string::npos);
    CHECK(complaint("sqrt(1, 2)").find("takes 1 argument") != std::string::npos);
    CHECK(complaint("x + thing.inner.word").find("numbers are wanted") != std::string::npos);
    CHECK(complaint("list[2]").find("no element 2") != std::string::npos);
    CHECK(complaint("list[-1]").find("no element") != std::string::npos);
    for (const char* const bad :
         {"", "1 +", "(1", "x..y", "'open", "1 2", "x = 4", "[1,", "f(", "%"}) {
        CAPTURE(std::string(bad));
        CHECK_THROWS_AS(Expression{bad}, ExpressionError);
    }
    CHECK_THROWS_AS(Expression{std::string(500, '(')}, ExpressionError);
    CHECK_THROWS_AS(Expression{std::string(5000, '1')}, ExpressionError);
}

TEST_CASE("expression: a number written down refers to nothing") {
    CHECK(!Expression("sqrt(2) + 1").refers());
    CHECK(Expression("x + 1").refers());
    CHECK(Expression("at(3, 4).primary").refers());
    CHECK(Expression("x == 5").found(Names()) == "the left side is 4");
}
