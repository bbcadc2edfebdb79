#include "lesson/expression.h"

#include <algorithm>
#include <cmath>

#include "formats/did_you_mean.h"
#include "formats/json_reader.h"
#include "lesson/expression_node.h"
#include "tree/explain.h"

namespace raytree::lesson {
namespace {

using Node = Expression::Node;
using Kind = Node::Kind;

class Evaluation {
  public:
    explicit Evaluation(const Scope& scope) : scope_(scope) {}

    Value of(const Node& node) const {
        switch (node.kind) {
            case Kind::literal:
                return Value::of(node.literal);
            case Kind::name:
                return named(node);
            case Kind::member:
                return member_of(of(node.parts[0]), node.text);
            case Kind::element:
                return element_of(of(node.parts[0]), of(node.parts[1]));
            case Kind::call:
                return called(node);
            case Kind::call_of:
                return called_of(node);
            case Kind::list:
                return listed(node);
            case Kind::negate:
                return Value::of(arithmetic("*", -1.0, data_of(of(node.parts[0]), "a number")));
            case Kind::negation:
                return Value::of(!truth_of(of(node.parts[0])));
            default:
                return binary(node);
        }
    }

  private:
    Value named(const Node& node) const {
        if (auto found = scope_.member(node.text)) {
            return *std::move(found);
        }
        if (node.text == "pi") {
            return Value::of(std::acos(-1.0));
        }
        no_such("name", node.text, scope_.names());
    }
    Value called(const Node& node) const {
        std::vector<Value> arguments;
        for (const Node& argument : node.parts) {
            arguments.push_back(of(argument));
        }
        if (auto found = scope_.call(node.text, arguments)) {
            return *std::move(found);
        }
        if (auto found = call_function(node.text, arguments)) {
            return Value::of(*std::move(found));
        }
        std::vector<std::string> names = function_names();
        for (const std::string& name : scope_.names()) {
            names.push_back(name);
        }
        no_such("function", node.text, names);
    }
    /// `mistake('…').at(3, 4)`: a function of what stands before the point.
    Value called_of(const Node& node) const {
        const Value whole = of(node.parts[0]);
        std::vector<Value> arguments;
        for (std::size_t k = 1; k < node.parts.size(); ++k) {
            arguments.push_back(of(node.parts[k]));
        }
        if (whole.scope) {
            if (auto found = whole.scope->call(node.text, arguments)) {
                return *std::move(found);
            }
        }
        no_such("function", node.text,
                whole.scope ? whole.scope->names() : std::vector<std::string>());
    }
    Value listed(const Node& node) const {
        Json list = Json::array();
        for (const Node& element : node.parts) {
            list.push_back(data_of(of(element), "data"));
        }
        return Value::of(std::move(list));
    }
    Value binary(const Node& node) const {
        if (node.text == "and" || node.text == "or") {
            const bool left = truth_of(of(node.parts[0]));
            const bool decided = left == (node.text == "or");
            return Value::of(decided ? left : truth_of(of(node.parts[1])));
        }
        const Value left = of(node.parts[0]);
        const Value right = of(node.parts[1]);
        if (std::string_view("==!=<=>=").find(node.text) == std::string_view::npos) {
            return Value::of(
                arithmetic(node.text, data_of(left, "a number"), data_of(right, "a number")));
        }
        return Value::of(compare(node, left, right));
    }
    bool compare(const Node& node, const Value& left, const Value& right) const {
        const double tolerance = node.parts.size() > 2 ? number_of(of(node.parts[2])) : 0;
        if (node.text == "==" || node.text == "!=") {
            // What has members of its own is equal to nothing but itself: `x == null` is asked.
            const bool equal = left.json && right.json ? same(*left.json, *right.json, tolerance)
                                                       : left.scope && left.scope == right.scope;
            return equal == (node.text == "==");
        }
        const double a = number_of(left);
        const double b = number_of(right);
        if (node.text[0] == '<') {
            return node.text == "<=" ? a <= b + tolerance : a < b + tolerance;
        }
        return node.text == ">=" ? a >= b - tolerance : a > b - tolerance;
    }

    const Scope& scope_;
};

/// `at(3, 4).primary` refers to something as `primary` does; `sqrt(2)` does not.
bool looks_up(const Node& node) {
    return node.kind == Kind::name ||
           (node.kind == Kind::call && !is_function_of_numbers(node.text)) ||
           std::ranges::any_of(node.parts, looks_up);
}

}  // namespace

Expression::Expression(std::string_view text)
    : text_(text), root_(std::make_shared<const Node>(parse_expression(text))) {}

Value Expression::evaluate(const Scope& scope) const {
    try {
        return Evaluation(scope).of(*root_);
    } catch (const ExpressionError& error) {
        throw ExpressionError("'" + text_ + "': " + error.what());
    }
}

double Expression::number(const Scope& scope) const {
    const Value value = evaluate(scope);
    if (!value.json || !value.json->is_number()) {
        throw ExpressionError("'" + text_ + "' is no number");
    }
    return value.json->get<double>();
}

bool Expression::truth(const Scope& scope) const {
    const Value value = evaluate(scope);
    if (!value.json || !value.json->is_boolean()) {
        throw ExpressionError("'" + text_ + "' is neither true nor false");
    }
    return value.json->get<bool>();
}

Json Expression::data(const Scope& scope) const {
    const Value value = evaluate(scope);
    if (!value.json) {
        throw ExpressionError("'" + text_ + "' has members of its own: say which" +
                              all_of(" of ", value.scope->names()));
    }
    return *value.json;
}

std::string Expression::found(const Scope& scope) const {
    const bool comparison =
        root_->kind == Kind::binary &&
        std::string_view("==!=<=>=").find(root_->text) != std::string_view::npos;
    if (!comparison) {
        return "";
    }
    const Value left = Evaluation(scope).of(root_->parts[0]);
    if (!left.json) {
        return "the left side is there";
    }
    return "the left side is " + (left.json->is_object() ? shown(*left.json) : left.json->dump());
}

bool Expression::refers() const { return root_ && looks_up(*root_); }

bool same(const Json& a, const Json& b, double tolerance) {
    if (a.is_number() && b.is_number()) {
        const double x = a.get<double>();
        const double y = b.get<double>();
        return x == y || std::abs(x - y) <= tolerance;
    }
    if (!a.is_array() || !b.is_array()) {
        return a == b;
    }
    bool equal = a.size() == b.size();
    for (std::size_t k = 0; equal && k < a.size(); ++k) {
        equal = same(a[k], b[k], tolerance);
    }
    return equal;
}

std::string value_text(const Json& value) {
    if (value.is_number()) {
        return number_text(value.get<double>());
    }
    if (value.is_string()) {
        return value.get<std::string>();
    }
    if (value.is_array()) {
        std::string text;
        for (const Json& element : value) {
            text += (text.empty() ? "(" : ", ") + value_text(element);
        }
        return text.empty() ? "()" : text + ")";
    }
    return value.is_null() ? "nothing" : value.dump();
}

}  // namespace raytree::lesson
