#include "check/not_numbers.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "formats/json_parse.h"

namespace raytree::check {
namespace {

constexpr std::array<std::string_view, 14> numeric_keys = {
    "origin",  "direction", "weight",   "t",         "point",       "normal",   "cos_incident",
    "ambient", "diffuse",   "specular", "intensity", "attenuation", "distance", "transmittance"};

bool is_none(std::string_view word) {
    if (word.starts_with('-') || word.starts_with('+')) {
        word.remove_prefix(1);
    }
    std::string lower(word.substr(0, 9));
    std::ranges::transform(lower, lower.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower == "nan" || lower == "inf" || lower == "infinity" || lower.starts_with("nan(");
}

/// Walks the text once and copies it, but for what is no number.
class Walk {
  public:
    explicit Walk(const std::string& text) : text_(text) { out_.reserve(text.size()); }

    std::vector<NotNumber> run() {
        while (at_ < text_.size()) {
            step();
        }
        return std::move(found_);
    }
    std::string take() { return std::move(out_); }

  private:
    struct List {
        std::size_t out = 0;   ///< where it starts in the copy
        std::size_t text = 0;  ///< and in the text
        bool none = false;     ///< one of its numbers is none
    };

    bool of_numbers() const { return std::ranges::find(numeric_keys, key_) != numeric_keys.end(); }
    bool in_list() const { return !open_.empty() && open_.back().text != in_object; }

    void none_at(std::size_t place) {
        if (in_list()) {
            open_.back().none = true;
        } else {
            note(place);
        }
        out_ += "null";
    }
    void note(std::size_t place) {
        if (found_.size() < most) {
            found_.push_back({line_and_column(text_, place), key_});
        }
    }

    void step() {
        const char c = text_[at_];
        if (c == '"') {
            string();
        } else if (std::isalpha(static_cast<unsigned char>(c)) != 0 ||
                   ((c == '-' || c == '+') && at_ + 1 < text_.size() &&
                    std::isalpha(static_cast<unsigned char>(text_[at_ + 1])) != 0)) {
            word();
        } else {
            bracket(c);
            ++at_;
        }
    }

    void bracket(char c) {
        if (c == '{' || c == '[') {
            open_.push_back({out_.size(), c == '[' ? at_ : in_object, false});
        }
        out_ += c;
        if ((c == '}' || c == ']') && !open_.empty()) {
            const List closed = open_.back();
            open_.pop_back();
            if (c == ']' && closed.text != in_object && closed.none) {
                out_.resize(closed.out);
                out_ += "null";
                note(closed.text);
            }
        }
    }

    void string() {
        std::size_t end = at_ + 1;
        while (end < text_.size() && text_[end] != '"') {
            end += text_[end] == '\\' ? 2 : 1;
        }
        end = std::min(end + 1, text_.size());
        const std::string_view whole = std::string_view(text_).substr(at_, end - at_);
        const std::string_view inner = whole.size() < 2 ? "" : whole.substr(1, whole.size() - 2);
        const std::size_t next = text_.find_first_not_of(" \t\r\n", end);
        if (next != std::string::npos && text_[next] == ':') {
            key_ = inner.substr(0, longest_key);
            out_ += whole;
        } else if (of_numbers() && is_none(inner)) {
            none_at(at_);
        } else {
            out_ += whole;
        }
        at_ = end;
    }

    void word() {
        std::size_t end = at_ + 1;
        while (end < text_.size() &&
               (std::isalnum(static_cast<unsigned char>(text_[end])) != 0 ||
                std::string_view("_()").find(text_[end]) != std::string_view::npos)) {
            ++end;
        }
        const std::string_view word = std::string_view(text_).substr(at_, end - at_);
        const bool null_among_numbers = word == "null" && in_list() && of_numbers();
        if (null_among_numbers || (of_numbers() && is_none(word))) {
            none_at(at_);
        } else {
            out_ += word;
        }
        at_ = end;
    }

    static constexpr std::size_t in_object = ~std::size_t{0};
    static constexpr std::size_t most = 20;  // places
    static constexpr std::size_t longest_key = 40;
    const std::string& text_;
    std::string out_, key_;
    std::size_t at_ = 0;
    std::vector<List> open_;
    std::vector<NotNumber> found_;
};

/// Whether there is anything to look for, which in nearly all files there is not.
bool may_have_some(std::string_view text) {
    for (std::size_t at = 0; at + 1 < text.size(); ++at) {
        const char c = static_cast<char>(text[at] | 0x20);
        const char next = static_cast<char>(text[at + 1] | 0x20);
        if ((c == 'n' && next == 'a') || (c == 'i' && next == 'n')) {
            const std::string_view before = text.substr(at == 0 ? 0 : at - 1, at == 0 ? 0 : 1);
            if (before.empty() || std::isalpha(static_cast<unsigned char>(before.front())) == 0) {
                const char third =
                    at + 2 < text.size() ? static_cast<char>(text[at + 2] | 0x20) : 0;
                if ((c == 'n' && third == 'n') || (c == 'i' && third == 'f')) {
                    return true;
                }
            }
        }
    }
    return text.find("[null") != std::string_view::npos ||
           text.find(", null") != std::string_view::npos ||
           text.find(",null") != std::string_view::npos ||
           text.find("[ null") != std::string_view::npos;
}

}  // namespace

std::vector<NotNumber> take_out_not_numbers(std::string& text) {
    if (!may_have_some(text)) {
        return {};
    }
    Walk walk(text);
    std::vector<NotNumber> found = walk.run();
    if (!found.empty()) {
        text = walk.take();
    }
    return found;
}

}  // namespace raytree::check
