#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "lesson/expression_node.h"

namespace raytree::lesson {
namespace {

constexpr double pi = 3.14159265358979323846;

struct OfNumber {
    std::string_view name;
    double (*apply)(double);
};
constexpr OfNumber of_numbers[] = {
    {"sqrt", [](double x) { return std::sqrt(x); }},
    {"abs", [](double x) { return std::abs(x); }},
    {"sin", [](double x) { return std::sin(x * pi / 180); }},
    {"cos", [](double x) { return std::cos(x * pi / 180); }},
    {"tan", [](double x) { return std::tan(x * pi / 180); }},
    {"asin", [](double x) { return std::asin(x) * 180 / pi; }},
    {"angle", [](double x) { return std::acos(std::clamp(x, -1.0, 1.0)) * 180 / pi; }},
    {"floor", [](double x) { return std::floor(x); }},
    {"round", [](double x) { return std::round(x); }},
    {"log10", [](double x) { return std::log10(x); }},
};

double number_of(const Json& value, std::string_view function) {
    if (!value.is_number()) {
        throw ExpressionError(std::string(function) + "(…) takes a number; found " +
                              value_text(value));
    }
    return value.get<double>();
}

std::array<double, 3> triple_of(const Json& value, std::string_view function) {
    if (!value.is_array() || value.size() != 3) {
        throw ExpressionError(std::string(function) + "(…) takes a list of three numbers; found " +
                              value_text(value));
    }
    return {number_of(value[0], function), number_of(value[1], function),
            number_of(value[2], function)};
}

double inner(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

using Arguments = std::vector<Json>;
struct OfList {
    std::string_view name;
    std::size_t arguments;
    Json (*apply)(const Arguments&);
};

Json cross(const Arguments& given) {
    const auto a = triple_of(given[0], "cross");
    const auto b = triple_of(given[1], "cross");
    return Json::array(
        {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]});
}
Json unit(const Arguments& given) {
    const auto v = triple_of(given[0], "unit");
    const double size = std::sqrt(inner(v, v));
    return Json::array({v[0] / size, v[1] / size, v[2] / size});
}
Json least(const Arguments& given) {
    return std::min(number_of(given[0], "min"), number_of(given[1], "min"));
}
Json most(const Arguments& given) {
    return std::max(number_of(given[0], "max"), number_of(given[1], "max"));
}

const OfList of_lists[] = {
    {"dot", 2,
     [](const Arguments& given) {
         return Json(inner(triple_of(given[0], "dot"), triple_of(given[1], "dot")));
     }},
    {"length", 1,
     [](const Arguments& given) {
         const auto v = triple_of(given[0], "length");
         return Json(std::sqrt(inner(v, v)));
     }},
    {"cross", 2, cross},
    {"unit", 1, unit},
    {"min", 2, least},
    {"max", 2, most},
};

void expect_arguments(std::string_view name, std::size_t expected, std::size_t given) {
    if (expected != given) {
        throw ExpressionError(std::string(name) + "(…) takes " + std::to_string(expected) +
                              (expected == 1 ? " argument" : " arguments") + "; found " +
                              std::to_string(given));
    }
}

}  // namespace

std::optional<Json> call_function(std::string_view name, std::span<const Value> arguments) {
    Arguments given;
    for (const Value& argument : arguments) {
        given.push_back(argument.json ? *argument.json : Json("something with members"));
    }
    for (const OfNumber& function : of_numbers) {
        if (function.name == name) {
            expect_arguments(name, 1, given.size());
            return function.apply(number_of(given[0], name));
        }
    }
    for (const OfList& function : of_lists) {
        if (function.name == name) {
            expect_arguments(name, function.arguments, given.size());
            return function.apply(given);
        }
    }
    return std::nullopt;
}

std::vector<std::string> function_names() {
    std::vector<std::string> names;
    for (const OfNumber& function : of_numbers) {
        names.emplace_back(function.name);
    }
    for (const OfList& function : of_lists) {
        names.emplace_back(function.name);
    }
    return names;
}

bool is_function_of_numbers(std::string_view name) {
    const std::vector<std::string> names = function_names();
    return std::ranges::find(names, name) != names.end();
}

}  // namespace raytree::lesson
