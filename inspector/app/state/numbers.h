#pragma once

#include <span>
#include <string>
#include <vector>

#include "math/rgb.h"
#include "math/vector.h"

/// Numbers that stand below each other. For those in sentences see tree/explain.h. Independent of
/// the locale.
namespace raytree::inspector {

/// The numbers with as many decimals as give the largest of them `digits` significant ones; very
/// small and very large ones in powers of ten.
std::vector<std::string> aligned(std::span<const double> values, int digits = 6);
std::vector<std::string> aligned(const Vec3<double>& v, int digits = 6);
std::vector<std::string> aligned(const Rgb<double>& c, int digits = 6);
/// As they stand above their sum: with its decimals, where they are too small to have ones of their
/// own that it would notice.
std::vector<std::string> aligned_with(const Rgb<double>& sum, const Rgb<double>& part);

/// "0.274  0.341  0.460", for lists.
std::string rgb_text(const Rgb<double>& c);
/// "0.27 0.34 0.46", where there is little room.
std::string brief_rgb_text(const Rgb<double>& c);

/// The shortest text that is this very double when it is read again: 17 digits at most. Of several,
/// divided by blanks.
std::string exact(double value);
std::string exact(std::span<const double> values);

/// 1234567 -> "1,234,567"
std::string grouped(double count);

}  // namespace raytree::inspector
