#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lesson/expression.h"

namespace raytree::lesson {

/// A part of an expression.
struct Expression::Node {
    enum class Kind {
        literal,
        name,
        member,
        element,
        call,
        call_of,
        list,
        negate,
        negation,
        binary
    };

    Kind kind = Kind::literal;
    std::string text;  ///< a name, or the operator
    Json literal;
    std::vector<Node> parts;  ///< of a comparison a third one: the tolerance;
                              ///< of call_of the thing called first
};

/// Throws ExpressionError.
Expression::Node parse_expression(std::string_view text);

/// The value of a function of numbers alone (sqrt, angle, dot, ...); nothing for another name.
std::optional<Json> call_function(std::string_view name, std::span<const Value> arguments);
std::vector<std::string> function_names();
bool is_function_of_numbers(std::string_view name);

}  // namespace raytree::lesson
