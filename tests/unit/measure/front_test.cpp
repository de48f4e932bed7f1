#include "framework/measure/front.hpp"

#include <doctest/doctest.h>

#include <limits>

namespace glint {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<bool> front(std::vector<CostAndError> points) {
    return pareto_front(points);
}

TEST_CASE("nothing and one point") {
    CHECK(front({}).empty());
    CHECK(front({{1, 2}}) == std::vector<bool>{true});
    CHECK(front({{infinity, infinity}}) == std::vector<bool>{true});
}

TEST_CASE("what is beaten is off the front") {
    // in between; cheap and bad; dear and good; beaten by the first; beaten by the third
    CHECK(front({{2, 2}, {1, 4}, {4, 1}, {3, 3}, {5, 1.5}}) ==
          std::vector<bool>{true, true, true, false, false});
}

TEST_CASE("who is equal in one is beaten by who is better in the other") {
    CHECK(front({{1, 1}, {1, 2}}) == std::vector<bool>{true, false});
    CHECK(front({{1, 1}, {2, 1}}) == std::vector<bool>{true, false});
    CHECK(front({{1, 0}, {2, 0}}) == std::vector<bool>{true, false});
}

TEST_CASE("equal points stand or fall together") {
    CHECK(front({{1, 2}, {1, 2}, {2, 1}}) == std::vector<bool>{true, true, true});
    CHECK(front({{1, 2}, {1, 2}, {1, 1}}) == std::vector<bool>{false, false, true});
}

TEST_CASE("an infinite error is on the front only where nothing is as cheap") {
    CHECK(front({{1, infinity}, {2, 1}}) == std::vector<bool>{true, true});
    CHECK(front({{2, infinity}, {2, 1}}) == std::vector<bool>{false, true});
}

TEST_CASE("what is not a number is refused") {
    CHECK_THROWS_WITH_AS(front({{1, 1}, {nan, 1}}), "front: point 1 is not a number", Error);
    CHECK_THROWS_AS(front({{1, nan}}), Error);
}

}  // namespace
}  // namespace glint
