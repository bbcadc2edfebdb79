#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/json_parse.h"
#include "math/rgb.h"
#include "math/vector.h"
#include "scene/input_error.h"
#include "scene/json_pointer.h"
#include "scene/range_check.h"

/// Reading members of a parsed JSON document, strictly, with all mistakes collected.
namespace raytree {

/// Collects what is wrong with one file.
struct JsonReport {
    std::string file;
    std::vector<Mistake> mistakes;
    std::vector<std::string> warnings;   ///< "file: place: text"
    bool unknown_keys_are_fine = false;  ///< a newer minor version may have added some

    /// Further mistakes are only counted as such.
    bool is_full() const { return mistakes.size() >= kMostMistakes; }
    void add(const JsonPlace& place, std::string text);
    void unknown_key(const JsonPlace& place, std::string text);
};

/// `value` as it is shown in a message: shortened, a list or an object by its size alone.
std::string shown(const Json& value);

/// Checks the member `format` of `document`, "NAME/MAJOR.MINOR". A newer minor version is a
/// warning; what is not `name` in version `major` throws at once, since no other rule of ours holds
/// there.
void check_json_format(const Json& document, std::string_view name, int major, int minor,
                       JsonReport& report);

enum class Need { required, optional };

/// The members of one object. Each function reads one member into `out` and leaves `out` alone
/// where the member is absent or wrong; that an absent one was required, or that it was wrong, is
/// reported.
class ObjectReader {
  public:
    ObjectReader(const Json& object, const JsonPlace& place, JsonReport& report)
        : object_(object), place_(place), report_(report) {}

    /// Reports that `value` is no object; tells whether it is one.
    static bool is_object(const Json& value, const JsonPlace& place, JsonReport& report);

    const Json* find(std::string_view key) const;
    /// Whether the member is there and not `null`.
    bool has(std::string_view key) const;
    /// The member, or null with a report that it is missing.
    const Json* need(std::string_view key, std::string_view allowed) const;
    JsonPlace place_of(std::string_view key) const { return place_.member(key); }

    bool text(std::string_view key, std::string& out, Need need) const;
    bool truth(std::string_view key, bool& out, Need need) const;
    bool number(std::string_view key, double& out, Need need) const;
    bool whole_number(std::string_view key, std::int64_t& out, Need need, std::int64_t least,
                      std::int64_t most) const;
    bool point(std::string_view key, Vec3<double>& out, Need need) const;
    /// Three numbers, or one for all channels.
    bool colour(std::string_view key, Rgb<double>& out, Need need) const;
    /// A list of `count` numbers.
    bool numbers(std::string_view key, std::size_t count, double* out, Need need) const;
    bool points(std::string_view key, std::vector<Vec3<double>>& out, Need need) const;

    using Words = std::vector<std::string_view>;
    /// One of `words`; `out` is its place among them.
    bool choice(std::string_view key, const Words& words, std::size_t& out, Need need) const;

    /// Reports every member that is not in `known`.
    void nothing_but(const Words& known) const;

  private:
    const Json* member(std::string_view key, Need need, std::string_view allowed) const;
    bool wrong(std::string_view key, const Json& found, std::string_view allowed) const;

    const Json& object_;
    const JsonPlace& place_;
    JsonReport& report_;
};

/// `value` as `count` numbers, reporting what is wrong with it.
bool read_numbers(const Json& value, const JsonPlace& place, std::size_t count, double* out,
                  JsonReport& report);

}  // namespace raytree
