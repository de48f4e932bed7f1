#include "framework/image/metrics.hpp"

#include "framework/image/flip.hpp"
#include "framework/image/same_size.hpp"
#include "framework/image/srgb.hpp"
#include "framework/image/ssim.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace glint {
namespace {

std::array<int, 3> code_difference(const Rgba8& a, const Rgba8& b) {
    return {std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)};
}

void measure_codes(Metrics& metrics, const SrgbImage& reference, const SrgbImage& test) {
    std::int64_t squares = 0;
    std::int64_t over_one = 0;
    int worst = 0;
    for (int y = 0; y < reference.height(); ++y) {
        for (int x = 0; x < reference.width(); ++x) {
            const auto d = code_difference(reference(x, y), test(x, y));
            squares += d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
            const int largest = std::ranges::max(d);
            over_one += largest > 1 ? 1 : 0;
            if (largest > worst) {
                worst = largest;
                metrics.worst_x = x;
                metrics.worst_y = y;
            }
        }
    }
    const auto pixels = static_cast<double>(reference.pixels().size());
    metrics.max = worst;
    metrics.rmse = std::sqrt(static_cast<double>(squares) / (3.0 * pixels));
    metrics.psnr = 20.0 * std::log10(255.0 / metrics.rmse);
    metrics.over_one = static_cast<double>(over_one) / pixels;
}

// Not rounded.
double code(float linear) {
    return 255 * srgb_encode(std::clamp(double{linear}, 0.0, 1.0));
}

double code_difference(float a, float b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) {
        return 0;
    }
    const double d = std::abs(code(a) - code(b));
    return std::isnan(a) || std::isnan(b) ? std::numeric_limits<double>::infinity() : d;
}

}  // namespace

Metrics measure_difference(const SrgbImage& reference, const SrgbImage& test) {
    require_same_size(reference, test);
    Metrics metrics;
    measure_codes(metrics, reference, test);
    metrics.ssim = mean_ssim(reference, test);
    const Image<float> flip = flip_map(reference, test);
    const auto pixels = flip.pixels();
    metrics.flip_mean =
        std::accumulate(pixels.begin(), pixels.end(), 0.0) / static_cast<double>(pixels.size());
    metrics.flip_max = std::ranges::max(pixels);
    return metrics;
}

double largest_code_difference(const LinearImage& reference, const LinearImage& test) {
    require_same_size(reference, test);
    double largest = 0;
    for (std::size_t i = 0; i < reference.pixels().size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            largest =
                std::max(largest, code_difference(reference.pixels()[i][c], test.pixels()[i][c]));
        }
    }
    return largest;
}

}  // namespace glint
