#include "formats/json_parse.h"

#include <algorithm>
#include <iterator>
#include <unordered_set>
#include <utility>

#include "formats/json_text.h"
#include "scene/json_pointer.h"
#include "scene/progress.h"

namespace raytree {
namespace {

/// By comparing all with all, which is the fastest way for a few.
bool any_repeated(const Json::object_t::Container& members) {
    for (std::size_t i = 0; i < members.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (members[i].first == members[j].first) {
                return true;
            }
        }
    }
    return false;
}

/// Builds the document from the parser's events. The parser keeps its own stack on the heap, so the
/// depth of a file costs no stack; this refuses what is too deep for those who walk the document.
class Builder final : public nlohmann::json_sax<Json> {
  public:
    Builder(std::string_view text, const std::string& file, std::size_t deepest)
        : text_(text), file_(file), deepest_(deepest) {}

    bool null() override { return put(nullptr); }
    bool boolean(bool truth) override { return put(truth); }
    bool number_integer(number_integer_t n) override { return put(n); }
    bool number_unsigned(number_unsigned_t n) override { return put(n); }
    bool number_float(number_float_t n, const string_t& /*spelling*/) override { return put(n); }
    bool string(string_t& s) override { return put(std::move(s)); }
    bool binary(binary_t& /*bytes*/) override { return false; }
    bool start_object(std::size_t /*count*/) override { return open(Json::object()); }
    bool start_array(std::size_t /*count*/) override { return open(Json::array()); }

    bool key(string_t& name) override {
        key_ = std::move(name);
        return true;
    }
    bool end_object() override {
        refuse_repeated_keys();
        open_.pop_back();
        return true;
    }
    bool end_array() override {
        open_.pop_back();
        return true;
    }
    bool parse_error(std::size_t position, const std::string& last_token,
                     const nlohmann::detail::exception& error) override;

    Json take() {
        if (!mistakes_.empty()) {
            throw InputError(std::move(mistakes_));
        }
        return std::move(root_);
    }

  private:
    template <class Value> Json* place(Value&& value) {
        if (open_.empty()) {
            root_ = std::forward<Value>(value);
            return &root_;
        }
        if (open_.back()->is_array()) {
            auto& list = open_.back()->template get_ref<Json::array_t&>();
            return &list.emplace_back(std::forward<Value>(value));
        }
        // Not through operator[]: it looks for the key in the whole object each time.
        auto& members = open_.back()->template get_ref<Json::object_t&>();
        using Members = Json::object_t::Container;
        return &static_cast<Members&>(members)
                    .emplace_back(std::move(key_), std::forward<Value>(value))
                    .second;
    }
    template <class Value> bool put(Value&& value) {
        place(std::forward<Value>(value));
        return true;
    }
    bool open(Json container) {
        if (open_.size() == deepest_) {
            throw InputError(file_, pointer(),
                             "is nested too deep; at most " + std::to_string(deepest_) +
                                 " lists and objects may lie in one another");
        }
        open_.push_back(place(std::move(container)));
        return true;
    }
    void refuse_repeated_keys();
    std::string pointer() const;

    std::string_view text_;
    const std::string& file_;
    std::size_t deepest_;
    Json root_;
    std::vector<Json*> open_;
    std::string key_;
    std::vector<Mistake> mistakes_;
};

/// Of the innermost open container.
std::string Builder::pointer() const {
    std::string text;
    for (std::size_t k = 0; k + 1 < open_.size(); ++k) {
        const Json& container = *open_[k];
        text += container.is_array()
                    ? "/" + std::to_string(container.size() - 1)
                    : json_pointer_part(container.get_ref<const Json::object_t&>().back().first);
    }
    return text;
}

void Builder::refuse_repeated_keys() {
    const auto& members = open_.back()->get_ref<const Json::object_t&>();
    constexpr std::size_t few = 16;
    if (members.size() <= few && !any_repeated(members)) {
        return;
    }
    std::unordered_set<std::string_view> seen;
    for (const auto& [name, value] : members) {
        if (!seen.insert(name).second) {
            mistakes_.push_back({file_, pointer() + json_pointer_part(name),
                                 "the key " + json_string(name) +
                                     " is there twice; each key is allowed once in an object"});
        }
    }
}

/// The parser's explanation without its own codes and positions.
std::string explanation(std::string text) {
    constexpr std::string_view mark = "syntax error while parsing ";
    const auto at = text.find(mark);
    if (at == std::string::npos) {
        return text;
    }
    text.erase(0, at + mark.size());
    const auto dash = text.find(" - ");
    return "in " + (dash == std::string::npos ? text : text.replace(dash, 3, ": "));
}

bool looks_like_nan_or_infinity(std::string_view token) {
    const auto at = token.find_last_of("NnIi");
    return at != std::string_view::npos && at + 3 > token.size();
}

bool Builder::parse_error(std::size_t position, const std::string& last_token,
                          const nlohmann::detail::exception& error) {
    const std::string place = line_and_column(text_, position == 0 ? 0 : position - 1);
    // 406: a number that is no double, such as 1e999
    if (error.id == 406) {
        throw InputError(file_, place,
                         "the number " + last_token +
                             " is too large; numbers are doubles, up to "
                             "1.7976931348623157e+308");
    }
    throw InputError(
        file_, place,
        "is not JSON: " + explanation(error.what()) +
            (looks_like_nan_or_infinity(last_token) ? " (JSON has no NaN and no infinity)" : ""));
}

/// Goes through a text, and tells how far.
class ToldBytes {
  public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    ToldBytes(std::string_view text, std::size_t at) : text_(text), at_(at) {}
    reference operator*() const { return text_[at_]; }
    ToldBytes& operator++() {
        constexpr std::size_t seldom = 1 << 16;
        if (++at_ % seldom == 0) {
            tell_progress("reading", static_cast<double>(at_) / static_cast<double>(text_.size()));
        }
        return *this;
    }
    ToldBytes operator++(int) {
        const ToldBytes before = *this;
        ++*this;
        return before;
    }
    bool operator==(const ToldBytes& other) const { return at_ == other.at_; }

  private:
    std::string_view text_;
    std::size_t at_;
};

}  // namespace

Json parse_json(std::string_view text, const std::string& file, std::size_t deepest) {
    Builder builder(text, file, deepest);
    Json::sax_parse(ToldBytes(text, 0), ToldBytes(text, text.size()), &builder);
    return builder.take();
}

std::string line_and_column(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const auto start = before.rfind('\n') + 1;  // npos + 1 is 0
    return "line " + std::to_string(line) + ", column " + std::to_string(before.size() - start + 1);
}

}  // namespace raytree
