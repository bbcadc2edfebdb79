#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>

#include "lesson/expression_node.h"

namespace raytree::lesson {
namespace {

using Node = Expression::Node;
using Kind = Node::Kind;

constexpr std::size_t longest = 1000;  // bytes; enough for any reference, and bounds the nesting
constexpr int deepest = 50;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Reads from left to right, one function for each strength of binding.
class Parser {
  public:
    explicit Parser(std::string_view text) : text_(text) {}

    Node whole() {
        Node node = either();
        skip_blanks();
        if (at_ < text_.size()) {
            fail("is not understood");
        }
        return node;
    }

  private:
    [[noreturn]] void fail(const std::string& what) const {
        const std::string rest(text_.substr(at_, 20));
        throw ExpressionError("'" + std::string(text_) + "': " +
                              (rest.empty() ? "ends too early" : "from '" + rest + "' on " + what));
    }

    void skip_blanks() {
        while (at_ < text_.size() && text_[at_] == ' ') {
            ++at_;
        }
    }
    bool take(std::string_view symbol) {
        skip_blanks();
        if (!text_.substr(at_).starts_with(symbol)) {
            return false;
        }
        const std::size_t end = at_ + symbol.size();
        if (is_letter(symbol.back()) && end < text_.size() &&
            (is_letter(text_[end]) || is_digit(text_[end]))) {
            return false;  // a longer name
        }
        at_ = end;
        return true;
    }
    void expect(std::string_view symbol) {
        if (!take(symbol)) {
            fail("there must be '" + std::string(symbol) + "'");
        }
    }

    static Node binary(std::string_view symbol, Node left, Node right) {
        Node node{Kind::binary, std::string(symbol), nullptr, {}};
        node.parts.push_back(std::move(left));
        node.parts.push_back(std::move(right));
        return node;
    }

    Node either() {
        if (++depth_ > deepest) {
            fail("is nested too deep");
        }
        Node node = both();
        while (take("or")) {
            node = binary("or", std::move(node), both());
        }
        --depth_;
        return node;
    }
    Node both() {
        Node node = negation();
        while (take("and")) {
            node = binary("and", std::move(node), negation());
        }
        return node;
    }
    Node negation() {
        if (!take("not")) {
            return comparison();
        }
        Node node{Kind::negation, "not", nullptr, {}};
        node.parts.push_back(comparison());
        return node;
    }
    Node comparison() {
        Node node = sum();
        for (const std::string_view symbol : {"==", "!=", "<=", ">=", "<", ">"}) {
            if (take(symbol)) {
                node = binary(symbol, std::move(node), sum());
                if (take("within") || take("±")) {
                    node.parts.push_back(sum());
                }
                break;
            }
        }
        return node;
    }
    Node sum() {
        Node node = product();
        for (;;) {
            if (take("+")) {
                node = binary("+", std::move(node), product());
            } else if (take("-")) {
                node = binary("-", std::move(node), product());
            } else {
                return node;
            }
        }
    }
    Node product() {
        Node node = sign();
        for (;;) {
            if (take("*")) {
                node = binary("*", std::move(node), sign());
            } else if (take("/")) {
                node = binary("/", std::move(node), sign());
            } else {
                return node;
            }
        }
    }
    Node sign() {
        bool negative = false;
        while (take("-")) {
            negative = !negative;
        }
        Node node = power();
        if (!negative) {
            return node;
        }
        Node minus{Kind::negate, "-", nullptr, {}};
        minus.parts.push_back(std::move(node));
        return minus;
    }
    Node power() {
        Node node = postfix();
        return take("^") ? binary("^", std::move(node), exponent()) : node;
    }
    Node exponent() {
        Node minus{Kind::negate, "-", nullptr, {}};
        if (!take("-")) {
            return postfix();
        }
        minus.parts.push_back(postfix());
        return minus;
    }
    Node postfix() {
        Node node = atom();
        for (;;) {
            if (take(".")) {
                Node next{Kind::member, name(), nullptr, {}};
                next.parts.push_back(std::move(node));
                if (take("(")) {
                    next.kind = Kind::call_of;
                    std::ranges::move(list(")"), std::back_inserter(next.parts));
                }
                node = std::move(next);
            } else if (take("[")) {
                Node next{Kind::element, "[]", nullptr, {}};
                next.parts.push_back(std::move(node));
                next.parts.push_back(either());
                expect("]");
                node = std::move(next);
            } else {
                return node;
            }
        }
    }
    Node atom() {
        skip_blanks();
        if (at_ == text_.size()) {
            fail("");
        }
        if (is_digit(text_[at_])) {
            return number();
        }
        if (text_[at_] == '\'') {
            return quoted();
        }
        if (take("(")) {
            Node node = either();
            expect(")");
            return node;
        }
        if (take("[")) {
            return {Kind::list, "[]", nullptr, list("]")};
        }
        return named();
    }
    Node number() {
        double value = 0;
        const char* const end = text_.data() + text_.size();
        const auto read = std::from_chars(text_.data() + at_, end, value);
        if (read.ec != std::errc()) {
            fail("is no number");
        }
        at_ = static_cast<std::size_t>(read.ptr - text_.data());
        return {Kind::literal, "", value, {}};
    }
    Node quoted() {
        const std::size_t end = text_.find('\'', at_ + 1);
        if (end == std::string_view::npos) {
            fail("a quotation has no end");
        }
        const std::string inside(text_.substr(at_ + 1, end - at_ - 1));
        at_ = end + 1;
        return {Kind::literal, "", inside, {}};
    }
    Node named() {
        if (take("true")) {
            return {Kind::literal, "", true, {}};
        }
        if (take("false")) {
            return {Kind::literal, "", false, {}};
        }
        if (take("null")) {
            return {Kind::literal, "", nullptr, {}};
        }
        const std::string word = name();
        if (take("(")) {
            return {Kind::call, word, nullptr, list(")")};
        }
        return {Kind::name, word, nullptr, {}};
    }
    std::string name() {
        skip_blanks();
        const std::size_t from = at_;
        if (at_ == text_.size() || !is_letter(text_[at_])) {
            fail("there must be a name");
        }
        while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) {
            ++at_;
        }
        return std::string(text_.substr(from, at_ - from));
    }
    std::vector<Node> list(std::string_view closing) {
        std::vector<Node> parts;
        if (take(closing)) {
            return parts;
        }
        do {
            parts.push_back(either());
        } while (take(","));
        expect(closing);
        return parts;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int depth_ = 0;
};

}  // namespace

Node parse_expression(std::string_view text) {
    if (text.size() > longest) {
        throw ExpressionError("an expression of " + std::to_string(text.size()) +
                              " bytes; at most 1000 are allowed");
    }
    return Parser(text).whole();
}

}  // namespace raytree::lesson
