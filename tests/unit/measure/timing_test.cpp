// A clock that the test turns: no machine is quick or quiet enough to be asserted on.
#include "framework/measure/timing.hpp"

#include <doctest/doctest.h>

#include <string>

namespace glint {
namespace {

TEST_CASE("contenders run in turns, once more than is counted") {
    std::string order;
    const std::function<void()> contenders[] = {[&] { order += 'a'; }, [&] { order += 'b'; }};
    const auto times = time_in_turns(3, contenders);
    CHECK(order == "abababab");
    REQUIRE(times.size() == 2);
    CHECK(times[0].ms.size() == 3);
    CHECK(times[1].ms.size() == 3);
}

TEST_CASE("times are sorted; the first round and a slow spell do not reach the median") {
    double now = 1000;
    double slow = 50;  // the first round
    int round = 0;
    const std::function<void()> contenders[] = {[&] {
                                                    now += 2 * slow;
                                                    slow = ++round == 3 ? 7 : 1;
                                                },
                                                [&] { now += 3 * slow; }};
    const auto times = time_in_turns(5, contenders, [&] { return now; });
    CHECK(times[0].ms == std::vector<double>{2, 2, 2, 2, 14});
    CHECK(times[1].ms == std::vector<double>{3, 3, 3, 3, 21});
    CHECK(times[0].median() == 2);
    CHECK(times[1].least() == 3);
}

TEST_CASE("quartiles") {
    const Times times{{1, 2, 3, 4, 5, 6, 7}};
    CHECK(times.lower_quartile() == 2);
    CHECK(times.median() == 4);
    CHECK(times.upper_quartile() == 6);
    const Times once{{5}};
    CHECK(once.lower_quartile() == 5);
    CHECK(once.upper_quartile() == 5);
}

TEST_CASE("the clock of every day runs forward") {
    const double before = steady_ms();
    CHECK(steady_ms() >= before);
}

}  // namespace
}  // namespace glint
