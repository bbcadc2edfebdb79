#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace raytree {

/// `key` as a part of a JSON pointer, with its leading slash (RFC 6901: ~ is ~0, / is ~1).
std::string json_pointer_part(std::string_view key);

/// Where a value stands in a JSON document. Costs nothing until the pointer is asked for: a scene
/// of a million objects has none made. Each place refers to its parent, which must outlive it.
class JsonPlace {
  public:
    JsonPlace() = default;  ///< the document itself
    JsonPlace member(std::string_view key) const { return JsonPlace(this, key, 0); }
    JsonPlace element(std::size_t index) const { return JsonPlace(this, {}, index); }
    std::string pointer() const;

  private:
    JsonPlace(const JsonPlace* parent, std::string_view key, std::size_t index)
        : parent_(parent), key_(key), index_(index) {}

    const JsonPlace* parent_ = nullptr;
    std::string_view key_;  ///< data() is null for an element of a list
    std::size_t index_ = 0;
};

}  // namespace raytree
