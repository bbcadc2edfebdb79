#include "lesson/expression.h"

#include <algorithm>
#include <cmath>

#include "formats/did_you_mean.h"
#include "lesson/expression_node.h"
#include "tree/explain.h"

namespace raytree::lesson {
namespace {

using Node = Expression::Node;
using Kind = Node::Kind;

[[noreturn]] void no_such(std::string_view what, const std::string& found,
                          std::vector<std::string> names) {
    std::sort(names.begin(), names.end());
    const std::vector<std::string_view> views(names.begin(), names.end());
    std::string text = "there is no " + std::string(what) + " '" + found + "'";
    const std::string meant = did_you_mean(found, views);
    text += meant;
    if (meant.empty() && names.size() <= 40) {
        for (std::size_t k = 0; k < names.size(); ++k) {
            text += (k == 0 ? "; there are " : ", ") + names[k];
        }
    }
    throw ExpressionError(text);
}

const Json& data_of(const Value& value, const char* wanted) {
    if (!value.json) {
        throw ExpressionError(std::string("has members of its own, where ") + wanted +
                              " is wanted: say which member");
    }
    return *value.json;
}

double number_of(const Value& value) {
    const Json& json = data_of(value, "a number");
    if (!json.is_number()) {
        throw ExpressionError("found " + value_text(json) + ", where a number is wanted");
    }
    return json.get<double>();
}

bool truth_of(const Value& value) {
    const Json& json = data_of(value, "true or false");
    if (!json.is_boolean()) {
        throw ExpressionError("found " + value_text(json) + ", where true or false is wanted");
    }
    return json.get<bool>();
}

/// A part of the data that `whole` owns.
Value part(const Value& whole, const Json& of) {
    return {std::shared_ptr<const Json>(whole.json, &of), nullptr};
}

std::optional<Value> data_member(const Value& whole, const std::string& name) {
    const Json& json = *whole.json;
    if (json.is_object()) {
        const auto found = json.find(name);
        return found == json.end() ? std::nullopt : std::optional(part(whole, *found));
    }
    if (!json.is_array()) {
        return std::nullopt;
    }
    if (name == "count") {
        return Value::of(json.size());
    }
    for (const Json& element : json) {
        if (element.is_object() && element.contains("name") && element["name"] == name) {
            return part(whole, element);
        }
    }
    const std::size_t axis = std::string_view("xyz").find(name);
    const std::size_t channel = std::string_view("rgb").find(name);
    const std::size_t k = std::min(axis, channel);
    return name.size() == 1 && k < json.size() ? std::optional(part(whole, json[k])) : std::nullopt;
}

std::vector<std::string> member_names(const Json& json) {
    std::vector<std::string> names;
    if (json.is_object()) {
        for (const auto& [name, value] : json.items()) {
            names.push_back(name);
        }
    } else if (json.is_array()) {
        names.emplace_back("count");
        for (const Json& element : json) {
            if (element.is_object() && element.contains("name") && element["name"].is_string()) {
                names.push_back(element["name"].get<std::string>());
            }
        }
    }
    return names;
}

Value member_of(const Value& whole, const std::string& name) {
    if (whole.scope) {
        if (auto found = whole.scope->member(name)) {
            return *std::move(found);
        }
        no_such("member", name, whole.scope->names());
    }
    if (auto found = data_member(whole, name)) {
        return *std::move(found);
    }
    if (whole.json->is_null()) {
        throw ExpressionError("'." + name + "' is asked of what is not there (null)");
    }
    no_such("member", name, member_names(*whole.json));
}

Value element_of(const Value& whole, const Value& place) {
    const Json& at = data_of(place, "a number or a name");
    if (at.is_string()) {
        return member_of(whole, at.get<std::string>());
    }
    const double number = number_of(place);
    const bool natural = number >= 0 && number < 1e9 && std::floor(number) == number;
    const auto k = static_cast<std::size_t>(natural ? number : 0);
    if (natural && whole.scope) {
        if (auto found = whole.scope->element(k)) {
            return *std::move(found);
        }
    } else if (natural && whole.json->is_array() && k < whole.json->size()) {
        return part(whole, (*whole.json)[k]);
    }
    throw ExpressionError("there is no element " + value_text(at));
}

double combine(const std::string& symbol, double a, double b) {
    switch (symbol[0]) {
        case '+':
            return a + b;
        case '-':
            return a - b;
        case '*':
            return a * b;
        case '/':
            return a / b;
        default:
            return std::pow(a, b);
    }
}

/// Numbers, and lists of them element by element.
Json arithmetic(const std::string& symbol, const Json& a, const Json& b) {
    if (a.is_number() && b.is_number()) {
        return combine(symbol, a.get<double>(), b.get<double>());
    }
    const bool lists = a.is_array() && b.is_array() && a.size() == b.size();
    if (!lists && !(a.is_array() && b.is_number()) && !(a.is_number() && b.is_array())) {
        throw ExpressionError("'" + symbol + "' between " + value_text(a) + " and " +
                              value_text(b) + ", where numbers are wanted");
    }
    Json result = Json::array();
    for (std::size_t k = 0; k < (a.is_array() ? a : b).size(); ++k) {
        result.push_back(arithmetic(symbol, a.is_array() ? a[k] : a, b.is_array() ? b[k] : b));
    }
    return result;
}

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
        throw ExpressionError("'" + text_ + "' has members of its own: say which");
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
    return left.json ? "the left side is " + left.json->dump() : "the left side is there";
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
