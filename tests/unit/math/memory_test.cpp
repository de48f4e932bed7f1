#include "framework/math/memory.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <numeric>

namespace glint {
namespace {

TEST_CASE_TEMPLATE("large arrays begin where lines and pages do, and keep their values", T, char,
                   std::int32_t, double) {
    constexpr std::size_t huge = LineAllocator<T>::huge_page / sizeof(T);
    LineVector<T> values;
    for (const std::size_t size :
         {std::size_t{1}, std::size_t{100}, huge - 1, huge, 3 * huge + 5}) {
        CAPTURE(size);
        const std::size_t known = values.size();
        values.resize(size);
        values.shrink_to_fit();
        std::iota(values.begin() + static_cast<std::ptrdiff_t>(known), values.end(),
                  static_cast<T>(known));
        const auto address = reinterpret_cast<std::uintptr_t>(values.data());
        CHECK(address % (size < huge ? 64 : LineAllocator<T>::huge_page) == 0);
        bool kept = true;
        for (std::size_t i = 0; i < size; ++i) {
            kept = kept && values[i] == static_cast<T>(i);
        }
        CHECK(kept);
    }
}

}  // namespace
}  // namespace glint
