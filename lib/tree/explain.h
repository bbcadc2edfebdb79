#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "tree/ray_tree.h"

/// A recorded tree in words and formulas, the same wherever it is shown. Texts are UTF-8.
namespace raytree {

/// Four significant digits. A number that needs fewer is written with fewer and is exact; integer
/// digits are never rounded away below a million; otherwise 1.235e-5, 1.235e6. Zero is "0".
std::string number_text(double value);

/// A summand as its sum notices it: 0 in channels where it is below the rounding of the sum's own
/// value, such as a highlight of 1e-141. For texts alone; numbers to calculate with stay as they
/// are.
Rgb<double> noticed(const Rgb<double>& part, const Rgb<double>& sum);

/// "(0.2, 0.3, 0.5)", or one number where the three channels are equal.
std::string triple_text(const Rgb<double>& c);
/// Whether the channels look the same in `number_text`.
bool is_grey(const Rgb<double>& c);
std::string point_text(const Vec3<double>& p);

/// "34.56°", of the angle that has this cosine.
std::string angle_text(double cosine);

inline constexpr std::array<const char*, 3> channel_names = {"red", "green", "blue"};
std::array<double, 3> channels(const Rgb<double>& c);

/// The children of every ray, in the order of the tree.
std::vector<std::vector<std::size_t>> children_of(const RayTree<double>& tree);

/// Whether the reflected ray takes over what a total reflection keeps from the refracted one: the
/// hit's kr is then the material's kr + kt (model, "Refraction").
bool kt_joins_kr(const RayTree<double>& tree, const TreeHit<double>& hit);

/// One term of `I = ambient + diffuse + specular + kr·f·Ir + kt·f·It` at a hit: "ambient", or
/// "kr·f·Ir", with f left out where it is 1, and "(kr+kt)·f·Ir" where kt joins kr; and the same in
/// numbers, for each channel.
struct Term {
    std::string symbols;
    std::array<std::string, 3> numbers;
    bool grey = true;  ///< whether the three channels are equal
};

/// The terms of a ray that hit something: those of its children that were grown come last.
std::vector<Term> terms_of(const RayTree<double>& tree, const TreeRay<double>& ray,
                           const std::vector<std::size_t>& children);

/// The refractive indices and the angles: "1 → 1.5, 34.56° → 22.22° from the normal", or why
/// nothing is refracted, with the numbers.
std::string refraction_text(const TreeHit<double>& hit);

/// Why a ray was not sent: the reason's sentence with this tree's numbers put in.
std::string skipped_text(const RayTree<double>& tree, const TreeRay<double>& from,
                         const Skipped& skipped);

/// Why a ray ended, "no branch is sent: ..." where it hit something; empty where it did not end.
std::string ended_text(const RayTree<double>& tree, const TreeRay<double>& ray);

/// What became of a shadow ray: "reaches it, 7.1 away"; "is blocked by ball at t = 3.2".
std::string shadow_text(const TreeRay<double>& ray);

/// Whether a shadow ray's light arrives, at least in part.
bool reaches_light(const TreeRay<double>& ray);

/// Whether the ray's own end says why this branch was not sent: it is so where both branches were
/// not sent for the same reason.
bool told_by_termination(const TreeRay<double>& ray, const Skipped& skipped);

}  // namespace raytree
