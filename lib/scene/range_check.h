#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/input_error.h"
#include "scene/json_pointer.h"
#include "scene/scene.h"

/// Checking values of a scene against their ranges; what is wrong is collected.
namespace raytree {

/// The ranges that readers and options share.
inline constexpr int kLargestSide = 65535;           ///< pixels, of a picture's width or height
inline constexpr long long kMostPixels = 1LL << 28;  ///< of a picture
inline constexpr int kDeepest = 64;                  ///< levels of a ray tree
/// Enough to see what is wrong with a file; a generated one may hold a million mistakes.
inline constexpr std::size_t kMostMistakes = 50;

/// `number` as it is shown in a message: the shortest decimal that is the same double.
std::string shown_number(double number);

/// `name` between quotes.
std::string quoted(std::string_view name);

/// Each check returns whether the value is good and notes a mistake where it is not.
class RangeCheck {
  public:
    void add(const JsonPlace& place, std::string text);
    bool require(bool good, const JsonPlace& place, double found, const char* allowed);
    bool not_negative(const JsonPlace& place, double found);
    bool positive(const JsonPlace& place, double found);
    bool finite(const JsonPlace& place, const Point& p);
    /// Finite and not of length 0.
    bool direction(const JsonPlace& place, const Point& v);
    bool finite(const JsonPlace& place, const Colour& c);
    bool not_negative(const JsonPlace& place, const Colour& c);
    bool attenuation(const JsonPlace& place, const Attenuation& f);

    /// What was found, with a last line that counts what was left out.
    std::vector<Mistake> take();

  private:
    std::vector<Mistake> mistakes_;
    std::size_t left_out_ = 0;
};

/// Checks an object's transform and shape; `place` is the object's.
void check_object(const Object& object, const JsonPlace& place, RangeCheck& check);

}  // namespace raytree
