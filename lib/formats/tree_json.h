#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/input_error.h"
#include "scene/scene.h"
#include "tree/error_bounds.h"
#include "tree/given.h"
#include "tree/ray_tree.h"

/// The format raytree/1.0: one pixel's ray tree.
namespace raytree {

/// The tree as a raytree/1.0 document, with the whole of `embedded` under `scene.document` where it
/// is given. `T` is float, double or Quad; every number of the tree is finite. With the bounds of
/// its errors, by ray, each ray has `error_bounds` besides (a bound for each of its numbers, of the
/// same name; of a vector one for all components) and, where it could have gone either way,
/// `undecided`.
template <class T> std::string write_tree_json(const RayTree<T>& tree,
                                               const Scene* embedded = nullptr,
                                               const std::vector<RayBounds>* bounds = nullptr);

/// One ray as it stands in a raytree/1.0 document, with a line feed at its end.
std::string write_ray_json(const TreeRay<double>& ray);

/// A ray tree as a file gave it, which may be from someone else's tracer.
struct ReadTree {
    /// Depth first and numbered anew, directions made unit. What the file leaves out has its
    /// default, except for what follows from the rest: levels, counts of rays, points and distances
    /// of hits, and a hit's kr and kt, which are known from the shares of its branches.
    RayTree<double> tree;
    std::vector<std::string> ids;  ///< of each ray of `tree`: what the file calls it
    std::vector<Given> given;      ///< of each ray of `tree`: what the file says of it
    std::vector<double> units;     ///< of each ray of `tree`: the length of its direction as given
    std::optional<Scene> scene;    ///< the one inside the file
    bool has_camera = false;       ///< whether the file gave the camera
    bool has_settings = false;
    std::optional<std::size_t> lights;  ///< how many the file says that the scene has
    std::vector<std::string> warnings;  ///< for people, "file: place: text"
    /// Where levels and counts that the file gives are not those of its rays.
    std::vector<Mistake> contradictions;
};

/// Reads a raytree/1.0 document tolerantly: rays nested or in a list, in any order, with numbers or
/// strings as ids, with little more than their kinds. Throws InputError, which names the JSON
/// pointer, for what is no tree (two roots, an unknown parent, a circle, more than 1000 levels) and
/// for values of a wrong type. `file` names it in messages; an embedded scene's meshes are looked
/// for beside it.
ReadTree read_tree_json(const std::string& text, const std::filesystem::path& file);

}  // namespace raytree
