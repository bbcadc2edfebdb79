#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "check/not_numbers.h"
#include "scene/input_error.h"
#include "tree/given.h"
#include "tree/ray_tree.h"

/// A ray tree from someone else's tracer: what it says, and how exactly.
namespace raytree::check {

/// Larger files are refused unread: a tree of 31 rays takes 20 kB.
inline constexpr std::size_t largest_submission = std::size_t{16} << 20;

/// How exactly the numbers of a submission were computed and written. A number x is off by up to
/// `relative * |x| + absolute` for that reason alone.
struct Precision {
    double relative = 1e-15;
    double absolute = 0;
    std::string_view name = "double";  ///< "double", "float", "rounded"
    int digits = 17;                   ///< significant ones, where it is rounded

    bool is_rounded() const { return relative > 1e-12 || absolute > 0; }
};

struct Submission {
    std::string file;
    RayTree<double> tree;          ///< depth first, directions made unit
    std::vector<Given> given;      ///< of each ray
    std::vector<std::string> ids;  ///< of each ray: its own name for it
    std::vector<double> units;     ///< of each ray: the length its direction had
    std::vector<std::vector<std::size_t>> children;
    bool has_shadow_rays = false;  ///< else their absence says nothing
    bool has_camera = false, has_settings = false;
    std::optional<std::size_t> lights;  ///< how many it says that the scene has
    std::vector<std::string> remarks;
    std::vector<Mistake> contradictions;  ///< levels and counts that are not those of its rays
    std::vector<NotNumber> not_numbers;   ///< where its numbers are none
    Precision precision;

    bool gives(std::size_t ray, Field field) const { return given[ray][place_of(field)]; }
    /// The fields that some ray gives.
    Given fields() const;
};

/// The file's text. Throws InputError where there is none, or where it is too large.
std::string load_submission_text(const std::filesystem::path& file);
/// Throws InputError for what cannot be read as a tree.
Submission parse_submission(const std::string& text, const std::string& file);

/// What a ray says of a numeric field: one to three numbers; none where it says nothing, or where
/// the field is a word.
struct Numbers {
    int size = 0;
    std::array<double, 3> x{};
};
Numbers numbers_of(const RayTree<double>& tree, std::size_t ray, Field field);

/// Recognises exports in `float` or with few digits by the numbers themselves.
Precision precision_of(const Submission& submission);

}  // namespace raytree::check
