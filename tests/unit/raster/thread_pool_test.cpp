#include "framework/raster/thread_pool.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <stdexcept>
#include <string>

namespace glint {
namespace {

TEST_CASE("every item runs exactly once, on a thread of the pool") {
    for (int threads = 1; threads <= 7; ++threads) {
        CAPTURE(threads);
        ThreadPool pool(threads);
        CHECK(pool.threads() == threads);
        for (const std::size_t items : {0U, 1U, 2U, 7U, 1000U}) {
            CAPTURE(items);
            std::vector<int> runs(items, 0);  // each item is touched by one thread alone
            std::atomic<int> strangers{0};
            pool.run(items, [&](std::size_t item, int thread) {
                ++runs[item];
                strangers += thread < 0 || thread >= threads ? 1 : 0;
            });
            CHECK(runs == std::vector<int>(items, 1));
            CHECK(strangers == 0);
        }
    }
}

TEST_CASE("a thread's number is its own: what it keeps by number needs no lock") {
    ThreadPool pool(4);
    std::vector<long> sum(4, 0);
    for (int round = 0; round < 200; ++round) {
        pool.run(50, [&](std::size_t item, int thread) {
            sum[static_cast<std::size_t>(thread)] += static_cast<long>(item);
        });
    }
    CHECK(sum[0] + sum[1] + sum[2] + sum[3] == 200L * 49 * 50 / 2);
}

TEST_CASE("what one loop wrote the next one sees, on whichever thread") {
    ThreadPool pool(3);
    std::vector<int> value(64, 0);
    for (int round = 0; round < 300; ++round) {
        pool.run(value.size(), [&](std::size_t item, int) { value[item] = round; });
        REQUIRE(value == std::vector<int>(64, round));
        const std::vector<int> before = value;
        pool.run(value.size(), [&](std::size_t item, int) { value[item] += before[63 - item]; });
        REQUIRE(value == std::vector<int>(64, 2 * round));
    }
}

TEST_CASE("several threads take part") {
    ThreadPool pool(3);
    std::atomic<int> waiting{0};
    bool together = true;  // three items at a time, or the first would wait for ever
    const auto late = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    std::vector<int> taken_by(3, -1);
    pool.run(3, [&](std::size_t item, int thread) {
        taken_by[item] = thread;
        ++waiting;
        while (waiting < 3 && std::chrono::steady_clock::now() < late) {
            std::this_thread::yield();
        }
    });
    together = waiting == 3 && std::chrono::steady_clock::now() < late;
    CHECK(together);
    CHECK(taken_by[0] != taken_by[1]);
    CHECK(taken_by[1] != taken_by[2]);
    CHECK(taken_by[0] != taken_by[2]);
}

TEST_CASE("an exception comes through, and the pool is as good as new") {
    for (int threads = 1; threads <= 5; ++threads) {
        CAPTURE(threads);
        ThreadPool pool(threads);
        for (const std::size_t bad : {0U, 1U, 500U, 999U}) {
            CHECK_THROWS_WITH_AS(pool.run(1000,
                                          [bad](std::size_t item, int) {
                                              if (item == bad) {
                                                  throw std::runtime_error("item");
                                              }
                                          }),
                                 "item", std::runtime_error);
            std::atomic<int> count{0};
            pool.run(100, [&](std::size_t, int) { ++count; });
            CHECK(count == 100);
        }
        CHECK_THROWS_AS(pool.run(300, [](std::size_t, int) { throw 1; }), int);
    }
}

TEST_CASE("of several exceptions the first is thrown on") {
    ThreadPool pool(2);
    std::atomic<int> inside{0};
    std::atomic<bool> thrown{false};
    const auto wait_for = [](const auto& until) {
        const auto late = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        while (!until() && std::chrono::steady_clock::now() < late) {
            std::this_thread::yield();
        }
    };
    CHECK_THROWS_WITH(pool.run(2,
                               [&](std::size_t, int) {
                                   const int mine = ++inside;
                                   wait_for([&] { return inside == 2; });
                                   if (mine == 1) {
                                       thrown = true;
                                       throw std::runtime_error("first");
                                   }
                                   wait_for([&] { return thrown.load(); });
                                   // The pool has caught the other long before this.
                                   std::this_thread::sleep_for(std::chrono::milliseconds(50));
                                   throw std::runtime_error("second");
                               }),
                      "first");
}

}  // namespace
}  // namespace glint
