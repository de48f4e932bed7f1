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

template <int N>
[[gnu::flatten]] void shade_rows(const BenchShader& shader, const glm::vec3& eye,
                                 SrgbImage& picture) {
    using T = typename Lanes<N>::Float;
    const FlushSubnormals flush;
    const float step = 1.0F / static_cast<float>(picture.width());
    for (int y = 0; y < picture.height(); ++y) {
        const T row(static_cast<float>(y) * step);
        auto* out = reinterpret_cast<std::int32_t*>(picture.row(y).data());
        for (int x = 0; x < picture.width(); x += N) {
            const T column = (iota<T>() + T(static_cast<float>(x))) * T(step);
            const Vec3<T> position(column - T(0.5F), row - T(0.3F), column + row);
            const BenchShader::Varyings<T> in{{column - T(0.5F), T(0.3F) - row, T(0.7F) + row},
                                              eye - position};
            const Rgb<T> c = shader(in);
            store(out + x, opaque_code(c.r, c.g, c.b));
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

Peak straight_kernel(const BenchShader& shader, const glm::vec3& eye, int lanes) {
    auto picture = std::make_shared<SrgbImage>(1920, 256);
    return {[shader, eye, lanes, picture] {
                with_lanes(lanes, [&]<int N>() { shade_rows<N>(shader, eye, *picture); });
            },
            static_cast<double>(picture->pixels().size())};
}

}  // namespace glint
