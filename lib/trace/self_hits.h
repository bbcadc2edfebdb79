#pragma once

#include "trace/world.h"

namespace raytree {

/// What becomes of rays that do not know which surface they leave: of the shadow, reflected and
/// refracted rays of a picture those that meet something else than they should, most of them the
/// very surface that they start on.
struct SelfHits {
    std::size_t rays = 0;   ///< that leave a surface
    std::size_t wrong = 0;  ///< whose first hit is another one without care
    double share() const {
        return rays == 0 ? 0 : static_cast<double>(wrong) / static_cast<double>(rays);
    }
};

/// `T` is float or double.
template <class T> SelfHits self_hits(const World<T>& world);

extern template SelfHits self_hits(const World<float>&);
extern template SelfHits self_hits(const World<double>&);

}  // namespace raytree
