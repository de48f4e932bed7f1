// Times of what is run in turns, so that a slow spell of the machine meets all alike.
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <span>
#include <vector>

namespace glint {

struct Times {
    std::vector<double> ms{};  // sorted

    double least() const { return ms.front(); }
    double median() const { return ms[ms.size() / 2]; }
};

// Runs A B C A B C ..., rounds >= 1 times each after one round that is not counted.
inline std::vector<Times> time_in_turns(int rounds,
                                        std::span<const std::function<void()>> contenders) {
    using Clock = std::chrono::steady_clock;
    std::vector<Times> times(contenders.size());
    for (int round = -1; round < rounds; ++round) {
        for (std::size_t i = 0; i < contenders.size(); ++i) {
            const auto start = Clock::now();
            contenders[i]();
            const std::chrono::duration<double, std::milli> took = Clock::now() - start;
            if (round >= 0) {
                times[i].ms.push_back(took.count());
            }
        }
    }
    for (Times& t : times) {
        std::sort(t.ms.begin(), t.ms.end());
    }
    return times;
}

}  // namespace glint
