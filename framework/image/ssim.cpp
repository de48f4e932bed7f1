#include "framework/image/ssim.hpp"

#include "framework/image/filter.hpp"
#include "framework/image/same_size.hpp"

#include <cmath>

namespace glint {
namespace {

constexpr int radius = 5;
constexpr double sigma = 1.5;

std::vector<double> gaussian_window() {
    std::vector<double> weights;
    double sum = 0.0;
    for (int x = -radius; x <= radius; ++x) {
        weights.push_back(std::exp(-0.5 * x * x / (sigma * sigma)));
        sum += weights.back();
    }
    for (double& weight : weights) {
        weight /= sum;
    }
    return weights;
}

Image<double> luma(const SrgbImage& image) {
    Image<double> out(image.width(), image.height());
    std::ranges::transform(image.pixels(), out.pixels().begin(), [](const Rgba8& p) {
        return 0.2126 * p.r + 0.7152 * p.g + 0.0722 * p.b;
    });
    return out;
}

Image<double> product(const Image<double>& a, const Image<double>& b) {
    Image<double> out(a.width(), a.height());
    std::ranges::transform(a.pixels(), b.pixels(), out.pixels().begin(), std::multiplies<>());
    return out;
}

Image<double> blurred(const Image<double>& image) {
    static const std::vector<double> window = gaussian_window();
    return filter_columns(filter_rows(image, window, Border::mirror), window, Border::mirror);
}

// Means, variances and covariance under the window to similarity, equation 13 of the paper.
double similarity(double mean_a, double mean_b, double var_a, double var_b, double cov) {
    constexpr double c1 = (0.01 * 255) * (0.01 * 255);
    constexpr double c2 = (0.03 * 255) * (0.03 * 255);
    return (2 * mean_a * mean_b + c1) * (2 * cov + c2) /
           ((mean_a * mean_a + mean_b * mean_b + c1) * (var_a + var_b + c2));
}

}  // namespace

double mean_ssim(const SrgbImage& reference, const SrgbImage& test) {
    require_same_size(reference, test);
    const Image<double> a = luma(reference);
    const Image<double> b = luma(test);
    const Image<double> mean_a = blurred(a);
    const Image<double> mean_b = blurred(b);
    const Image<double> mean_aa = blurred(product(a, a));
    const Image<double> mean_bb = blurred(product(b, b));
    const Image<double> mean_ab = blurred(product(a, b));

    const int edge = std::min(a.width(), a.height()) > 2 * radius ? radius : 0;
    double sum = 0.0;
    for (int y = edge; y < a.height() - edge; ++y) {
        for (int x = edge; x < a.width() - edge; ++x) {
            const double ma = mean_a(x, y);
            const double mb = mean_b(x, y);
            sum += similarity(ma, mb, mean_aa(x, y) - ma * ma, mean_bb(x, y) - mb * mb,
                              mean_ab(x, y) - ma * mb);
        }
    }
    return sum / (static_cast<double>(a.width() - 2 * edge) * (a.height() - 2 * edge));
}

}  // namespace glint
