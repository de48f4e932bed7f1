// Runs a small function over many numbers, as a shader does over a tile's fragments.
#pragma once

#include "framework/math/lanes.hpp"
#include "docs/charts/harness.hpp"

#include <array>
#include <memory>

namespace glint::charts {

using Wide = Lanes<max_lanes>::Float;

// Numbers in columns: number k of evaluation i is column(k)[i]. Few enough for the first cache, in
// whole lines of it, and columns begin at different places of its sets.
class Columns {
  public:
    static constexpr int rows = 2048;

    explicit Columns(int columns) : lines_(static_cast<std::size_t>(columns) * stride) {}
    float* column(int k) { return lines_[static_cast<std::size_t>(k) * stride].number; }
    const float* column(int k) const { return lines_[static_cast<std::size_t>(k) * stride].number; }

  private:
    struct alignas(64) Line {
        float number[16];
    };
    static constexpr std::size_t stride = rows / 16 + 5;
    std::vector<Line> lines_;
};

// Row i gets the In numbers that of(i) returns.
template <int In, class Of>
std::shared_ptr<const Columns> make_columns(Of of) {
    auto columns = std::make_shared<Columns>(In);
    for (int i = 0; i < Columns::rows; ++i) {
        const std::array<float, In> row = of(i);
        for (int k = 0; k < In; ++k) {
            columns->column(k)[i] = row[static_cast<std::size_t>(k)];
        }
    }
    return columns;
}

// Where evaluation i lies between 0 and 1, both excluded.
inline double share_of(int i) {
    return (i + 0.5) / Columns::rows;
}

// Flattened, or what f calls would pass its registers through memory.
template <class T, int In, int Out, class F>
[[gnu::noinline, gnu::flatten]] void evaluate(const Columns& in, Columns& out, const F& f) {
    for (int i = 0; i < Columns::rows; i += lanes_of<T>) {
        std::array<T, In> x;
        for (int k = 0; k < In; ++k) {
            x[static_cast<std::size_t>(k)] = load<T>(in.column(k) + i);
        }
        const std::array<T, Out> y = f(x);
        for (int k = 0; k < Out; ++k) {
            store(out.column(k) + i, y[static_cast<std::size_t>(k)]);
        }
    }
}

// What is timed, how many evaluations that is, and what came out.
struct Trial {
    std::function<void()> work;
    double amount;
    std::shared_ptr<const Columns> out;
};

// f: std::array<T, In> to std::array<T, Out>.
template <class T, int In, int Out, class F>
Trial try_out(const std::shared_ptr<const Columns>& in, const F& f) {
    constexpr int times = 16;
    auto out = std::make_shared<Columns>(Out);
    evaluate<T, In, Out>(*in, *out, f);
    const auto work = [in, out, f] {
        for (int i = 0; i < times; ++i) {
            evaluate<T, In, Out>(*in, *out, f);
        }
    };
    return {work, double{Columns::rows} * times, out};
}

// f of eight numbers next to x, summed: for what takes less time than to load and to store.
inline constexpr int multiples = 8;
template <class T, std::size_t In, class F>
auto sum_of_multiples(const std::array<T, In>& x, const F& f) {
    auto sum = f(x);
    for (int m = 1; m < multiples; ++m) {
        std::array<T, In> multiple = x;
        for (T& number : multiple) {
            number *= T(1 - 0x1p-20F * static_cast<float>(m));
        }
        const auto y = f(multiple);
        for (std::size_t k = 0; k < y.size(); ++k) {
            sum[k] += y[k];
        }
    }
    return sum;
}

// As try_out(), timed by sums of multiples.
template <class T, int In, int Out, class F>
Trial try_out_quick(const std::shared_ptr<const Columns>& in, const F& f) {
    const auto sum = [f](const std::array<T, In>& x) { return sum_of_multiples(x, f); };
    const Trial timed = try_out<T, In, Out>(in, sum);
    return {timed.work, timed.amount * multiples, try_out<T, In, Out>(in, f).out};
}

}  // namespace glint::charts
