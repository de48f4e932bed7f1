#include "tests/bench/peaks.hpp"

#include "framework/image/srgb.hpp"
#include "framework/math/dispatch.hpp"

#include <algorithm>
#include <memory>

namespace glint {
namespace {

template <int N>
float multiply_and_add(int times) {
    using T = typename Lanes<N>::Float;
    constexpr std::size_t chains = 12;  // independent, to hide the latency
    T sum[chains];
    std::fill_n(sum, chains, T(1.0F));
    const T factor(0.999F);
    const T term(0.001F);
    for (int i = 0; i < times; ++i) {
        for (T& s : sum) {
            s = fma(s, factor, term);
        }
    }
    T all(0.0F);
    for (const T& s : sum) {
        all += s;
    }
    float lanes[N];
    store(lanes, all);
    return lanes[0];
}

// The normals turn by 45 degrees to each side, the way to the eye by half of that.
template <int N>
[[gnu::flatten]] void shade_rows(const BenchShader& shader, SrgbImage& picture) {
    using T = typename Lanes<N>::Float;
    const FlushSubnormals flush;
    const float right = 2.0F / static_cast<float>(picture.width());
    const float down = 2.0F / static_cast<float>(picture.height());
    for (int row = 0; row < picture.height(); ++row) {
        const T y(1.0F - (static_cast<float>(row) + 0.5F) * down);
        auto* out = reinterpret_cast<std::int32_t*>(picture.row(row).data());
        for (int column = 0; column < picture.width(); column += N) {
            const T x = (iota<T>() + T(static_cast<float>(column) + 0.5F)) * T(right) - T(1.0F);
            const BenchShader::Varyings<T> in{{x, y, T(1.0F)},
                                              {T(-0.4F) * x, T(-0.4F) * y, T(1.0F)}};
            const Rgb<T> c = shader(in);
            store(out + column, opaque_code(c.r, c.g, c.b));
        }
    }
}

}  // namespace

Peak fma_peak(int lanes) {
    constexpr int times = 1 << 18;
    auto sink = std::make_shared<volatile float>(0.0F);
    return {
        [lanes, sink] { with_lanes(lanes, [&]<int N>() { *sink = multiply_and_add<N>(times); }); },
        2.0 * 12 * times * lanes};
}

Peak write_peak() {
    auto block = std::make_shared<std::vector<std::uint8_t>>(std::size_t{64} << 20);
    auto value = std::make_shared<std::uint8_t>(std::uint8_t{0});
    return {[block, value] { std::fill(block->begin(), block->end(), ++*value); },
            static_cast<double>(block->size())};
}

Peak straight_kernel(const BenchShader& shader, int lanes) {
    auto picture = std::make_shared<SrgbImage>(1920, 256);
    return {[shader, lanes, picture] {
                with_lanes(lanes, [&]<int N>() { shade_rows<N>(shader, *picture); });
            },
            static_cast<double>(picture->pixels().size())};
}

}  // namespace glint
