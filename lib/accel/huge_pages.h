#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <new>
#include <vector>

namespace raytree {

/// Allocates large blocks on boundaries of huge pages and asks the system for such pages: the
/// addresses of a hierarchy are scattered, and looking them up costs as much as reading them.
template <class T> struct HugePageAllocator {
    using value_type = T;

    HugePageAllocator() = default;
    template <class U> HugePageAllocator(const HugePageAllocator<U>&) {}

    T* allocate(std::size_t n) {
        const std::size_t bytes = n * sizeof(T);
        void* const place = ::operator new(bytes, alignment(n));
        if (bytes >= huge_page) {
            madvise(place, bytes, MADV_HUGEPAGE);  // a wish: nothing depends on it
        }
        return static_cast<T*>(place);
    }
    void deallocate(T* place, std::size_t n) { ::operator delete(place, alignment(n)); }
    template <class U> bool operator==(const HugePageAllocator<U>&) const { return true; }

  private:
    static constexpr std::size_t huge_page = std::size_t(1) << 21;
    static constexpr std::size_t cache_line = 64;
    static std::align_val_t alignment(std::size_t n) {
        return std::align_val_t(n * sizeof(T) >= huge_page ? huge_page : cache_line);
    }
};

template <class T> using HugePageVector = std::vector<T, HugePageAllocator<T>>;

}  // namespace raytree
