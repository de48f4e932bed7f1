// Six varyings, a position and a normal, along rows of 256 pixels over a surface whose far end is
// so many times as far away as its near one.
#include "docs/charts/families.hpp"
#include "docs/charts/kernel.hpp"

namespace glint::charts {
namespace {

constexpr int varyings = 6;
constexpr int span_pixels = 256;

// 1/w and each varying over w are linear on the screen. At pixel x: at + x per_pixel.
struct Linear {
    float at, per_pixel;

    template <class T>
    T operator()(const T& x) const {
        return fma(T(per_pixel), x, T(at));
    }
};
// Side by side: columns farther apart may be in each other's way in the cache.
struct alignas(64) Values {
    std::array<float, std::size_t{varyings} * span_pixels> at;

    float* column(int k) { return &at[static_cast<std::size_t>(k) * span_pixels]; }
    const float* column(int k) const { return &at[static_cast<std::size_t>(k) * span_pixels]; }
};

struct Span {
    Linear inverse_w;
    std::array<Linear, varyings> over_w;
};

double near_value(int k) {
    return 0.1 * k;
}
double far_value(int k) {
    return near_value(k) + (k % 2 == 0 ? 1 : -1);  // each goes through a range of 1
}

Linear linear(double first, double last) {
    return {static_cast<float>(first), static_cast<float>((last - first) / span_pixels)};
}

Span span_to(double depth_ratio) {
    Span s{linear(1, 1 / depth_ratio), {}};
    for (int k = 0; k < varyings; ++k) {
        s.over_w[static_cast<std::size_t>(k)] = linear(near_value(k), far_value(k) / depth_ratio);
    }
    return s;
}

double exact(double depth_ratio, int k, double x) {
    const double share = x / span_pixels;
    const double near = 1 - share;
    const double far = share / depth_ratio;
    return (near * near_value(k) + far * far_value(k)) / (near + far);
}

// Calls f(x, i) for the pixels from first on, in lanes: x is where their middles are.
template <class F>
void for_each_pixel(int first, int count, const F& f) {
    for (int i = first; i < first + count; i += lanes_of<Wide>) {
        f(iota<Wide>() + Wide(static_cast<float>(i) + 0.5F), i);
    }
}

// inverse(1/w) at every pixel.
template <class Inverse>
struct Perspective {
    Inverse inverse;

    void operator()(const Span& given, Values& out) const {
        const Span span = given;  // where no store can reach it
        for_each_pixel(0, span_pixels, [&](const Wide& x, int i) {
            const Wide w = inverse(span.inverse_w(x));
            for (int k = 0; k < varyings; ++k) {
                store(out.column(k) + i, span.over_w[static_cast<std::size_t>(k)](x) * w);
            }
        });
    }
};

template <class Inverse>
Perspective(Inverse) -> Perspective<Inverse>;

// Right at the ends of a block, on a straight line between; one block a span is affine.
struct ByBlock {
    int pixels;

    void operator()(const Span& span, Values& out) const {
        for (int first = 0; first < span_pixels; first += pixels) {
            const auto begin = static_cast<float>(first);
            const float end = begin + static_cast<float>(pixels);
            const float w_begin = 1.0F / span.inverse_w(begin);
            const float w_end = 1.0F / span.inverse_w(end);
            std::array<Linear, varyings> line;
            for (std::size_t k = 0; k < varyings; ++k) {
                const float a = span.over_w[k](begin) * w_begin;
                const float b = span.over_w[k](end) * w_end;
                const float slope = (b - a) / static_cast<float>(pixels);
                line[k] = {a - slope * begin, slope};
            }
            for_each_pixel(first, pixels, [&](const Wide& x, int i) {
                for (int k = 0; k < varyings; ++k) {
                    store(out.column(k) + i, line[static_cast<std::size_t>(k)](x));
                }
            });
        }
    }
};

Errors errors_of(double depth_ratio, const Values& out) {
    ErrorSum sum;
    for (int i = 0; i < span_pixels; ++i) {
        for (int k = 0; k < varyings; ++k) {
            sum.add(double{out.column(k)[i]} - exact(depth_ratio, k, i + 0.5));
        }
    }
    return sum.errors();
}

template <class Method>
[[gnu::noinline, gnu::flatten]] void interpolate(const Method& method, const Span& span,
                                                 Values& out) {
    method(span, out);
}

void add_all(std::vector<Contender>& all, double depth_ratio, const char* name) {
    const Span span = span_to(depth_ratio);
    const auto add = [&](const char* method, const auto& how) {
        constexpr int times = 128;
        auto out = std::make_shared<Values>();
        interpolate(how, span, *out);
        const auto work = [=] {
            for (int i = 0; i < times; ++i) {
                interpolate(how, span, *out);
            }
        };
        all.push_back({method,
                       work,
                       double{span_pixels} * times,
                       {{name, "share of the range", errors_of(depth_ratio, *out)}}});
    };
    add("division", Perspective{[](const Wide& s) { return Wide(1.0F) / s; }});
    add("Glint's reciprocal", Perspective{[](const Wide& s) { return reciprocal(s); }});
#if defined(__AVX512VL__)
    add("estimated reciprocal",
        Perspective{[](const Wide& s) { return Wide(simd::quotient_estimate(s.v.data)); }});
#endif
    add("linear by 16 pixels", ByBlock{16});
    add("linear by 64 pixels", ByBlock{64});
    add("affine", ByBlock{span_pixels});
}

}  // namespace

std::vector<Contender> interpolation_contenders() {
    std::vector<Contender> all;
    add_all(all, 1.02, "depth ratio 1.02");
    add_all(all, 1.5, "depth ratio 1.5");
    add_all(all, 20, "depth ratio 20");
    return all;
}

}  // namespace glint::charts
