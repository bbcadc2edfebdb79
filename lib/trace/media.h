#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace raytree {

/// The materials that a ray is inside, the one entered last at the end. At most one is added a
/// level, and a tree has at most 64.
class Media {
  public:
    Media() = default;
    Media(const Media& other) : count_(other.count_) {
        for (std::size_t k = 0; k < count_; ++k) {
            materials_[k] = other.materials_[k];
        }
    }
    Media& operator=(const Media&) = delete;

    bool empty() const { return count_ == 0; }
    std::size_t size() const { return count_; }
    std::uint32_t operator[](std::size_t k) const { return materials_[k]; }
    std::uint32_t last() const { return materials_[count_ - 1]; }

    void enter(std::uint32_t material) { materials_[count_++] = material; }

    /// Takes out the most recent entry of the material, if there is one.
    void leave(std::uint32_t material) {
        for (std::size_t k = count_; k > 0; --k) {
            if (materials_[k - 1] == material) {
                for (; k < count_; ++k) {
                    materials_[k - 1] = materials_[k];
                }
                --count_;
                return;
            }
        }
    }

  private:
    std::array<std::uint32_t, 64> materials_;
    std::size_t count_ = 0;
};

}  // namespace raytree
