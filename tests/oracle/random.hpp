// Random numbers that are the same with every standard library.
#pragma once

#include <cstdint>
#include <random>

namespace glint::oracle {

class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    int between(int low, int high) {  // both included
        const auto count = static_cast<std::uint64_t>(std::int64_t{high} - low) + 1;
        return static_cast<int>(low + static_cast<std::int64_t>(engine_() % count));
    }
    double real(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }
    bool one_in(int n) { return between(1, n) == 1; }

  private:
    std::mt19937_64 engine_;
};

}  // namespace glint::oracle
