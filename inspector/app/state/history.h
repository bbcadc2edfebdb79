#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "state/document.h"

namespace raytree::inspector {

/// How a pixel is picked: by itself, or as one of the many on a way, such as a drag's.
enum class Pick { apart, on_the_way };

/// The pixels picked, oldest first, and where in them one is. Pixels on a way are one entry: the
/// last of them.
class History {
  public:
    /// Begins anew.
    void begin(Pixel pixel);
    /// Forgets what had been gone back from.
    void add(Pixel pixel, Pick how);
    /// The pixel that is `by` further; none beyond the ends.
    std::optional<Pixel> at(int by) const;
    /// To a place where there is a pixel.
    void go(int by);

    std::size_t size() const { return pixels_.size(); }

  private:
    std::deque<Pixel> pixels_;
    std::size_t here_ = 0;
    bool on_the_way_ = false;  ///< whether the pixel here is
};

}  // namespace raytree::inspector
