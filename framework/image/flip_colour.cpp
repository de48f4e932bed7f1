#include "framework/image/colour.hpp"
#include "framework/image/filter.hpp"
#include "framework/image/flip_parts.hpp"

#include <numbers>
#include <numeric>

namespace glint::flip {
namespace {

// ---- spatial filtering: what the eye resolves ----------------------------------------------

// A channel's contrast sensitivity is the sum of a sqrt(pi / b) exp(-pi^2 x^2 / b) over its
// Gaussians; x in degrees.
struct Gaussian {
    double a, b;
};
constexpr Gaussian y_sensitivity{1.0, 0.0047};
constexpr Gaussian cx_sensitivity{1.0, 0.0053};
constexpr Gaussian cz_wide{34.1, 0.04};
constexpr Gaussian cz_narrow{13.5, 0.025};

// Along one axis and without its factor, which scales both axes at once. All are cut at three
// standard deviations of the widest.
Weights profile(Gaussian g, double pixels_per_degree) {
    constexpr double pi = std::numbers::pi;
    const double widest = std::sqrt(cz_wide.b / (2 * pi * pi)) * pixels_per_degree;
    return sampled(static_cast<int>(std::ceil(3 * widest)), [&](double x) {
        const double degrees = x / pixels_per_degree;
        return std::exp(-pi * pi * degrees * degrees / g.b);
    });
}

// The sum of the two-dimensional filter.
double weight(Gaussian g, const Weights& profile) {
    const double sum = std::accumulate(profile.begin(), profile.end(), 0.0);
    return g.a * std::sqrt(std::numbers::pi / g.b) * sum * sum;
}

Plane blurred(const Plane& plane, const Weights& profile) {
    const Weights weights = normalised(profile);
    return filter_columns(filter_rows(plane, weights, Border::repeat), weights, Border::repeat);
}

Opponent resolved(const Opponent& planes, double pixels_per_degree) {
    const Weights wide = profile(cz_wide, pixels_per_degree);
    const Weights narrow = profile(cz_narrow, pixels_per_degree);
    const double all = weight(cz_wide, wide) + weight(cz_narrow, narrow);
    const auto share = static_cast<float>(weight(cz_wide, wide) / all);
    Plane cz = blurred(planes[2], wide);
    std::ranges::transform(cz.pixels(), blurred(planes[2], narrow).pixels(), cz.pixels().begin(),
                           [=](float w, float n) { return share * w + (1.0F - share) * n; });
    return {blurred(planes[0], profile(y_sensitivity, pixels_per_degree)),
            blurred(planes[1], profile(cx_sensitivity, pixels_per_degree)), std::move(cz)};
}

// ---- how far apart colours look ------------------------------------------------------------

// CIELAB of a colour of the screen, less colourful where dark: the Hunt adjustment.
glm::vec3 perceived(const Rgb<float>& rgb) {
    const glm::vec3 lab = cielab(xyz_from_rgb(rgb));
    return {lab.x, 0.01F * lab.x * lab.y, 0.01F * lab.x * lab.z};
}

glm::vec3 perceived(const Opponent& planes, std::size_t pixel) {
    const glm::vec3 ycxcz(planes[0].pixels()[pixel], planes[1].pixels()[pixel],
                          planes[2].pixels()[pixel]);
    return perceived(clamp(rgb_from_xyz(from_opponent(ycxcz)), 0.0F, 1.0F));
}

// HyAB, which holds for large distances: city-block in lightness, Euclidean in hue and chroma.
float hyab(const glm::vec3& p, const glm::vec3& q) {
    const glm::vec3 d = p - q;
    return std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
}

// Error redistribution: compressed by the power 0.7, then 0..0.4 of the largest possible difference
// spread over 0..0.95 and the rest over 0.95..1.
float error_from_distance(float distance) {
    constexpr float power = 0.7F;
    constexpr float knee = 0.4F;
    constexpr float knee_error = 0.95F;
    static const float largest =
        std::pow(hyab(perceived(Rgb<float>(0, 1, 0)), perceived(Rgb<float>(0, 0, 1))), power);
    const float relative = std::pow(distance, power) / largest;
    return relative < knee ? relative * knee_error / knee
                           : knee_error + (relative - knee) / (1.0F - knee) * (1.0F - knee_error);
}

}  // namespace

Plane colour_difference(const Opponent& reference, const Opponent& test, float pixels_per_degree) {
    const Opponent a = resolved(reference, pixels_per_degree);
    const Opponent b = resolved(test, pixels_per_degree);
    Plane out(a[0].width(), a[0].height());
    for (std::size_t i = 0; i < out.pixels().size(); ++i) {
        out.pixels()[i] = error_from_distance(hyab(perceived(a, i), perceived(b, i)));
    }
    return out;
}

}  // namespace glint::flip
