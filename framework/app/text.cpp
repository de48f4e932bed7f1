#include "framework/app/text.hpp"

#include <stb/stb_easy_font.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace glint {
namespace {

// As stb_easy_font writes them: four to a stroke, the first and third are opposite corners.
struct Corner {
    float x, y, z;
    std::array<std::uint8_t, 4> colour;
};

constexpr int most_strokes = 64;

void mix_in(Rgba8& pixel, Rgba8 colour, float part) {
    const auto mixed = [part](std::uint8_t under, std::uint8_t over) {
        return static_cast<std::uint8_t>(std::lround(
            static_cast<float>(under) + part * static_cast<float>(int{over} - int{under})));
    };
    pixel = {mixed(pixel.r, colour.r), mixed(pixel.g, colour.g), mixed(pixel.b, colour.b), 255};
}

// How much of the unit interval at i lies within low..high.
float overlap(int i, float low, float high) {
    const auto start = static_cast<float>(i);
    return std::max(0.0F, std::min(start + 1.0F, high) - std::max(start, low));
}

void draw_stroke(SrgbImage& image, float left, float top, float right, float bottom, Rgba8 colour) {
    const int first_x = std::max(0, static_cast<int>(std::floor(left)));
    const int first_y = std::max(0, static_cast<int>(std::floor(top)));
    const int last_x = std::min(image.width(), static_cast<int>(std::ceil(right)));
    const int last_y = std::min(image.height(), static_cast<int>(std::ceil(bottom)));
    for (int y = first_y; y < last_y; ++y) {
        for (int x = first_x; x < last_x; ++x) {
            mix_in(image(x, y), colour, overlap(x, left, right) * overlap(y, top, bottom));
        }
    }
}

void draw_letter(SrgbImage& image, float x, float y, char letter, float scale, Rgba8 colour) {
    const bool known = letter >= ' ' && letter <= '~';
    char text[] = {known ? letter : '?', '\0'};
    std::array<Corner, std::size_t{4} * most_strokes> corners{};
    const int strokes =
        stb_easy_font_print(0, 0, text, nullptr, corners.data(), static_cast<int>(sizeof corners));
    const int margin = (cell_width - stb_easy_font_width(text)) / 2;
    const float origin = x + scale * static_cast<float>(margin);
    for (std::size_t i = 0; i < static_cast<std::size_t>(strokes); ++i) {
        const Corner& a = corners[4 * i];
        const Corner& b = corners[4 * i + 2];
        draw_stroke(image, origin + scale * a.x, y + scale * a.y, origin + scale * b.x,
                    y + scale * b.y, colour);
    }
}

}  // namespace

void draw_text(SrgbImage& image, int x, int y, std::string_view text, float scale, Rgba8 colour) {
    auto at = static_cast<float>(x);
    for (const char letter : text) {
        draw_letter(image, at, static_cast<float>(y), letter, scale, colour);
        at += scale * cell_width;
    }
}

void shade_rectangle(SrgbImage& image, int x, int y, int width, int height, Rgba8 colour) {
    const float part = static_cast<float>(colour.a) / 255.0F;
    for (int row = std::max(0, y); row < std::min(image.height(), y + height); ++row) {
        for (int column = std::max(0, x); column < std::min(image.width(), x + width); ++column) {
            mix_in(image(column, row), colour, part);
        }
    }
}

}  // namespace glint
