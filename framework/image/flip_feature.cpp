#include "framework/image/filter.hpp"
#include "framework/image/flip_parts.hpp"

#include <numbers>

namespace glint::flip {
namespace {

struct Filters {
    Weights blur, edge, point;  // a Gaussian and its two derivatives
};

Filters filters(double pixels_per_degree) {
    const double sigma = 0.5 * 0.082 * pixels_per_degree;  // an edge is 0.082 degrees wide
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    const auto gaussian = [=](double x) { return std::exp(-0.5 * x * x / (sigma * sigma)); };
    return {normalised(sampled(radius, gaussian)),
            normalised(sampled(radius, [=](double x) { return -x * gaussian(x); })),
            normalised(sampled(
                radius, [=](double x) { return (x * x / (sigma * sigma) - 1) * gaussian(x); }))};
}

// The length of the gradient that the derivative finds along x and along y.
Plane magnitude(const Plane& luminance, const Weights& derivative, const Weights& blur) {
    constexpr Border border = Border::repeat;
    Plane out = filter_columns(filter_rows(luminance, derivative, border), blur, border);
    const Plane dy = filter_columns(filter_rows(luminance, blur, border), derivative, border);
    std::ranges::transform(out.pixels(), dy.pixels(), out.pixels().begin(),
                           [](float x, float y) { return std::sqrt(x * x + y * y); });
    return out;
}

// Y of YCxCz to 0..1.
Plane relative_luminance(Plane y) {
    for (float& value : y.pixels()) {
        value = (value + 16.0F) / 116.0F;
    }
    return y;
}

}  // namespace

Plane feature_difference(const Plane& reference, const Plane& test, float pixels_per_degree) {
    const Filters f = filters(pixels_per_degree);
    const Plane a = relative_luminance(reference);
    const Plane b = relative_luminance(test);
    const Plane edges_a = magnitude(a, f.edge, f.blur);
    const Plane edges_b = magnitude(b, f.edge, f.blur);
    const Plane points_a = magnitude(a, f.point, f.blur);
    const Plane points_b = magnitude(b, f.point, f.blur);
    Plane out(a.width(), a.height());
    for (std::size_t i = 0; i < out.pixels().size(); ++i) {
        const float edge = std::abs(edges_a.pixels()[i] - edges_b.pixels()[i]);
        const float point = std::abs(points_a.pixels()[i] - points_b.pixels()[i]);
        out.pixels()[i] = std::sqrt(std::max(edge, point) / std::numbers::sqrt2_v<float>);
    }
    return out;
}

}  // namespace glint::flip
