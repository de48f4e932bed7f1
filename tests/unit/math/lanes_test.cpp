#include "framework/math/vec.hpp"

#include <doctest/doctest.h>

namespace glint {
namespace {

TEST_CASE("one lane is a scalar") {
    CHECK(lanes_of<float> == 1);
    CHECK(select(true, 1.0F, 2.0F) == 1.0F);
}

}  // namespace
}  // namespace glint
