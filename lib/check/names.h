#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "check/laws.h"

namespace raytree::check {

/// Finds a scene's shapes and lights by the names that trees have for them.
class Names {
  public:
    explicit Names(const Place& place);

    std::string_view of(PrimitiveId primitive) const { return names_[primitive]; }
    /// Whether `name` is that of the shape, or of the mesh that it is part of.
    bool means(const std::string& name, PrimitiveId primitive) const;
    /// A shape of that name: of a mesh, its first triangle.
    std::optional<PrimitiveId> find(const std::string& name) const;
    std::optional<std::size_t> light(const std::string& name) const;

  private:
    const Place& place_;
    std::vector<std::string> names_;
    std::unordered_map<std::string, PrimitiveId> by_name_;
    std::unordered_map<std::string, std::size_t> lights_;
};

}  // namespace raytree::check
