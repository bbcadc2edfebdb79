#include <algorithm>
#include <cmath>

#include "formats/did_you_mean.h"
#include "formats/json_reader.h"
#include "lesson/expression_node.h"
#include "tree/explain.h"

namespace raytree::lesson {
namespace {

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

}  // namespace

std::string all_of(const char* before, std::vector<std::string> names) {
    std::sort(names.begin(), names.end());
    std::string text;
    for (std::size_t k = 0; k < names.size() && names.size() <= 40; ++k) {
        text += (k == 0 ? before : ", ") + names[k];
    }
    return text;
}

void no_such(std::string_view what, const std::string& found, std::vector<std::string> names) {
    const std::vector<std::string_view> views(names.begin(), names.end());
    std::string text = "there is no " + std::string(what) + " '" + found + "'";
    const std::string meant = did_you_mean(found, views);
    throw ExpressionError(text +
                          (meant.empty() ? all_of("; there are ", std::move(names)) : meant));
}

const Json& data_of(const Value& value, const char* wanted) {
    if (!value.json) {
        throw ExpressionError(std::string("has members of its own, where ") + wanted +
                              " is wanted: say which" + all_of(" of ", value.scope->names()));
    }
    return *value.json;
}

double number_of(const Value& value) {
    const Json& json = data_of(value, "a number");
    if (!json.is_number()) {
        throw ExpressionError("found " + shown(json) + ", where a number is wanted");
    }
    return json.get<double>();
}

bool truth_of(const Value& value) {
    const Json& json = data_of(value, "true or false");
    if (!json.is_boolean()) {
        throw ExpressionError("found " + shown(json) + ", where true or false is wanted");
    }
    return json.get<bool>();
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
        throw ExpressionError("'." + name +
                              "' is asked of what is not there (null); where that can be, "
                              "ask first whether it is: x != null and …");
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

}  // namespace raytree::lesson
