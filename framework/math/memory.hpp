// Memory for large arrays.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace glint {

// May be refused, and is lost on other systems than Linux; then pages are small.
inline void ask_for_huge_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
    madvise(memory, bytes, MADV_HUGEPAGE);
#endif
}

// Memory that begins where a line of the cache does, so that whole lines can be written; from 2 MB
// on in huge pages, where the system has them, for then addresses are found sooner.
template <class T>
struct LineAllocator {
    using value_type = T;
    static constexpr std::size_t huge_page = std::size_t{2} << 20;
    LineAllocator() = default;
    template <class U>
    LineAllocator(const LineAllocator<U>&) {}
    T* allocate(std::size_t n) {
        const std::size_t bytes = n * sizeof(T);
        void* memory = ::operator new(bytes, alignment(n));
        if (bytes >= huge_page) {
            ask_for_huge_pages(memory, bytes);
        }
        return static_cast<T*>(memory);
    }
    void deallocate(T* p, std::size_t n) { ::operator delete(p, alignment(n)); }
    friend bool operator==(LineAllocator, LineAllocator) { return true; }

  private:
    static std::align_val_t alignment(std::size_t n) {
        return std::align_val_t{n * sizeof(T) >= huge_page ? huge_page : 64};
    }
};

template <class T>
using LineVector = std::vector<T, LineAllocator<T>>;

}  // namespace glint
