#pragma once

#include <string>

namespace raytree::check {

/// The catalogue of mistakes and the profiles of courses as Markdown, made from the tables.
std::string catalogue_markdown();

}  // namespace raytree::check
