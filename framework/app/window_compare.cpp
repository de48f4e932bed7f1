#include "framework/app/window_compare.hpp"

#include "framework/image/heat_map.hpp"
#include "framework/image/same_size.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace glint {
namespace {

constexpr Rgba8 white{255, 255, 255, 255};
constexpr Rgba8 black{0, 0, 0, 255};

int difference(Rgba8 a, Rgba8 b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

void draw_column(SrgbImage& image, int column, Rgba8 colour) {
    if (column >= 0 && column < image.width()) {
        for (int y = 0; y < image.height(); ++y) {
            image(column, y) = colour;
        }
    }
}

}  // namespace

SrgbImage split_picture(const SrgbImage& left, const SrgbImage& right, int column) {
    require_same_size(left, right);
    SrgbImage both = right;
    for (int y = 0; y < left.height(); ++y) {
        std::copy_n(left.row(y).begin(), std::clamp(column, 0, left.width()), both.row(y).begin());
    }
    draw_column(both, column - 1, black);
    draw_column(both, column, white);
    draw_column(both, column + 1, black);
    return both;
}

CodeDifference code_difference(const SrgbImage& a, const SrgbImage& b) {
    require_same_size(a, b);
    std::array<Rgba8, 256> colours{};
    for (int codes = 0; codes < 256; ++codes) {
        colours[static_cast<std::size_t>(codes)] = heat_colour(difference_heat(codes));
    }
    CodeDifference out{.picture = SrgbImage(a.width(), a.height())};
    std::size_t differ = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const int codes = difference(a(x, y), b(x, y));
            out.picture(x, y) = colours[static_cast<std::size_t>(codes)];
            differ += codes > 0 ? 1 : 0;
            if (codes > out.largest) {
                out.largest = codes;
                out.x = x;
                out.y = y;
            }
        }
    }
    out.share = static_cast<double>(differ) / static_cast<double>(a.pixels().size());
    return out;
}

float difference_heat(int codes) {
    return std::sqrt(static_cast<float>(codes) / 255.0F);
}

}  // namespace glint
