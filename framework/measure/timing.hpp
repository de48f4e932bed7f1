// Times of what is run in turns, so that a slow spell of the machine meets all alike.
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <span>
#include <vector>

namespace glint {

struct Times {
    std::vector<double> ms{};  // sorted, not empty

    double least() const { return ms.front(); }
    double lower_quartile() const { return ms[ms.size() / 4]; }
    double median() const { return ms[ms.size() / 2]; }
    double upper_quartile() const { return ms[ms.size() * 3 / 4]; }
};

// Milliseconds since some moment.
using Clock = std::function<double()>;
inline double steady_ms() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double, std::milli>(now).count();
}

// Runs A B C A B C ..., rounds >= 1 times each after one round that is not counted.
inline std::vector<Times> time_in_turns(int rounds,
                                        std::span<const std::function<void()>> contenders,
                                        const Clock& clock = steady_ms) {
    std::vector<Times> times(contenders.size());
    for (int round = -1; round < rounds; ++round) {
        for (std::size_t i = 0; i < contenders.size(); ++i) {
            const double start = clock();
            contenders[i]();
            const double took = clock() - start;
            if (round >= 0) {
                times[i].ms.push_back(took);
            }
        }
    }
    for (Times& t : times) {
        std::sort(t.ms.begin(), t.ms.end());
    }
    return times;
}

}  // namespace glint
