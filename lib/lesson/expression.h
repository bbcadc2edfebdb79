#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "formats/json_parse.h"

/// The small language in which lessons refer to numbers: `primary.hit.t`, `counts.shadow == 3`,
/// `angle(ray.hit.cos_incident)`. It is documented for teachers in lessons/README.md.
namespace raytree::lesson {

class Scope;

/// What an expression stands for: data, or something that has members of its own.
struct Value {
    std::shared_ptr<const Json> json;    ///< null where it is a scope
    std::shared_ptr<const Scope> scope;  ///< null where it is data

    static Value of(Json data) { return {std::make_shared<const Json>(std::move(data)), nullptr}; }
};

/// Something that expressions can look into. Members are worked out when they are asked for.
class Scope {
  public:
    virtual ~Scope() = default;
    virtual std::optional<Value> member(std::string_view name) const = 0;
    virtual std::optional<Value> element(std::size_t) const { return std::nullopt; }
    virtual std::optional<Value> call(std::string_view, std::span<const Value>) const {
        return std::nullopt;
    }
    /// Its members and functions, for messages.
    virtual std::vector<std::string> names() const = 0;
};

/// An expression that cannot be read, or that has no value where it is asked for.
class ExpressionError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

class Expression {
  public:
    struct Node;

    /// An empty expression, which has no value.
    Expression() = default;
    /// Throws ExpressionError where `text` is none.
    explicit Expression(std::string_view text);

    bool empty() const { return root_ == nullptr; }
    const std::string& text() const { return text_; }

    /// Throws ExpressionError: for a name that there is none of, or a sum of what are no numbers.
    Value evaluate(const Scope& scope) const;
    double number(const Scope& scope) const;
    bool truth(const Scope& scope) const;
    Json data(const Scope& scope) const;

    /// Of a comparison: what its left side is, for people ("it is 4.25"); else empty.
    std::string found(const Scope& scope) const;
    /// Whether anything is looked up at all: a reference does, a number written down does not.
    bool refers() const;

  private:
    std::string text_;
    std::shared_ptr<const Node> root_;
};

/// Whether the two are equal; numbers, and lists of them, to within `tolerance`.
bool same(const Json& a, const Json& b, double tolerance = 0);

/// Data for people: numbers with four significant digits, lists in brackets.
std::string value_text(const Json& value);

}  // namespace raytree::lesson
