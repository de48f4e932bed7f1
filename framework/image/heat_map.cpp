#include "framework/image/heat_map.hpp"

#include "framework/image/colour.hpp"
#include "framework/image/same_size.hpp"
#include "framework/image/srgb.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace glint {
namespace {

// A Bezier curve through Oklab that stays inside sRGB, chosen by search: its lightness rises evenly
// and its hue turns once from blue over red to yellow.
glm::vec3 heat_curve(float t) {
    std::array<glm::vec3, 5> points = {{{0.100F, 0.008F, -0.029F},
                                        {0.202F, 0.035F, -0.150F},
                                        {0.485F, 0.308F, -0.047F},
                                        {0.588F, 0.168F, 0.209F},
                                        {0.965F, -0.060F, 0.164F}}};
    for (std::size_t left = points.size() - 1; left > 0; --left) {
        for (std::size_t i = 0; i < left; ++i) {
            points[i] = mix(points[i], points[i + 1], t);
        }
    }
    return points[0];
}

Rgba8 code_of(const glm::vec3& oklab) {
    const Rgb<float> rgb = rgb_from_oklab(oklab);
    return {linear_to_srgb(rgb.r), linear_to_srgb(rgb.g), linear_to_srgb(rgb.b), 255};
}

using Table = std::array<Rgba8, 256>;

// Colours at equal steps along the length of the curve.
Table heat_table() {
    constexpr int steps = 4096;
    std::array<float, steps + 1> length{};  // from the start of the curve
    for (int i = 1; i <= steps; ++i) {
        const auto at = static_cast<std::size_t>(i);
        length[at] = length[at - 1] + distance(heat_curve(static_cast<float>(i - 1) / steps),
                                               heat_curve(static_cast<float>(i) / steps));
    }
    Table table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        const float wanted = length.back() * static_cast<float>(i) / 255.0F;
        const auto at = std::ranges::lower_bound(length, wanted) - length.begin();
        table[i] = code_of(heat_curve(static_cast<float>(at) / steps));
    }
    return table;
}

}  // namespace

Rgba8 heat_colour(float error) {
    static const Table table = heat_table();
    const float shown = error < 1.0F ? std::max(error, 0.0F) : 1.0F;  // NaN is not below 1
    return table[static_cast<std::size_t>(std::lround(shown * 255.0F))];
}

SrgbImage heat_map(const Image<float>& error) {
    SrgbImage out(error.width(), error.height());
    std::ranges::transform(error.pixels(), out.pixels().begin(), heat_colour);
    return out;
}

SrgbImage side_by_side(const SrgbImage& reference, const SrgbImage& test, const SrgbImage& heat) {
    require_same_size(reference, test);
    require_same_size(reference, heat);
    constexpr int line = 2;
    const int step = reference.width() + line;
    SrgbImage out(3 * step - line, reference.height(), Rgba8{255, 255, 255, 255});
    int column = 0;
    for (const SrgbImage* picture : {&reference, &test, &heat}) {
        for (int y = 0; y < picture->height(); ++y) {
            std::ranges::copy(picture->row(y), out.row(y).begin() + column);
        }
        column += step;
    }
    return out;
}

}  // namespace glint
