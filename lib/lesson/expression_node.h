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

/// `before` and the names, in the order of the alphabet; nothing where they are too many to read.
std::string all_of(const char* before, std::vector<std::string> names);
/// Throws ExpressionError: `found` is none of `names`.
[[noreturn]] void no_such(std::string_view what, const std::string& found,
                          std::vector<std::string> names);

/// What a value is as data, a number, or true or false; throws ExpressionError where it is not.
const Json& data_of(const Value& value, const char* wanted);
double number_of(const Value& value);
bool truth_of(const Value& value);

/// `whole.name` and `whole[place]`. Throw ExpressionError where there is none.
Value member_of(const Value& whole, const std::string& name);
Value element_of(const Value& whole, const Value& place);

/// `+ - * / ^` of numbers, and of lists of them element by element. Throws ExpressionError.
Json arithmetic(const std::string& symbol, const Json& a, const Json& b);

/// The value of a function of numbers alone (sqrt, angle, dot, ...); nothing for another name.
std::optional<Json> call_function(std::string_view name, std::span<const Value> arguments);
std::vector<std::string> function_names();
bool is_function_of_numbers(std::string_view name);

}  // namespace raytree::lesson
