#include "framework/app/window_overlay.hpp"

#include "framework/app/text.hpp"
#include "framework/app/window_compare.hpp"
#include "framework/image/heat_map.hpp"

#include <algorithm>
#include <cmath>

namespace glint {
namespace {

constexpr Rgba8 dark{16, 18, 22, 226};
constexpr Rgba8 light{238, 238, 232, 255};
constexpr int padding = 6;

int pixels(float scale, std::size_t cells) {
    return static_cast<int>(std::lround(scale * static_cast<float>(cells)));
}

int line_pitch(float scale) {
    return pixels(scale, cell_height);
}

}  // namespace

int WordsPanel::width() const {
    std::size_t longest = 0;
    for (const std::string& line : lines) {
        longest = std::max(longest, line.size());
    }
    return pixels(scale, cell_width * longest) + 2 * padding;
}

int WordsPanel::height() const {
    return static_cast<int>(lines.size()) * line_pitch(scale) + 2 * padding;
}

void WordsPanel::draw(SrgbImage& image, int x, int y) const {
    shade_rectangle(image, x, y, width(), height(), dark);
    y += padding;
    for (const std::string& line : lines) {
        draw_text(image, x + padding, y, line, scale, light);
        y += line_pitch(scale);
    }
}

float words_scale(int height) {
    return height < 400 ? 1.0F : height < 1000 ? 1.5F : height < 1800 ? 2.0F : 3.0F;
}

WordsPanel fitting_panel(Lines lines, float scale, int height) {
    WordsPanel panel{std::move(lines), scale};
    if (panel.height() > height) {
        panel.scale = 1.0F;
    }
    const auto room =
        static_cast<std::size_t>(std::max(1, (height - 2 * padding) / line_pitch(panel.scale)));
    if (panel.lines.size() > room) {
        const std::size_t left_out = panel.lines.size() - room + 1;
        panel.lines.resize(room);
        panel.lines.back() = "... " + std::to_string(left_out) + " more lines: enlarge the window";
    }
    return panel;
}

void draw_mark(SrgbImage& image, int x, int y) {
    constexpr int inner = 3;
    constexpr int outer = 10;
    for (const int border : {1, 0}) {
        const Rgba8 colour = border != 0 ? Rgba8{0, 0, 0, 255} : Rgba8{255, 255, 255, 255};
        const int length = outer - inner + 2 * border;
        const int width = 1 + 2 * border;
        for (const int start : {-outer - border, inner + 1 - border}) {
            shade_rectangle(image, x + start, y - border, length, width, colour);
            shade_rectangle(image, x - border, y + start, width, length, colour);
        }
    }
}

void draw_difference_legend(SrgbImage& image, float scale) {
    constexpr int width = 256;
    const int bar = line_pitch(scale);
    const int left = image.width() - width - 24;
    const int top = image.height() - 2 * bar - 3 * padding;
    shade_rectangle(image, left - 3 * padding, top - padding, width + 6 * padding,
                    2 * bar + 3 * padding, dark);
    for (int i = 0; i < width; ++i) {
        shade_rectangle(image, left + i, top, 1, bar, heat_colour(static_cast<float>(i) / 255.0F));
    }
    for (const int codes : {0, 4, 16, 64, 128, 255}) {
        const std::string number = std::to_string(codes);
        const int middle = left + static_cast<int>(std::lround(255.0F * difference_heat(codes)));
        const int half = pixels(scale, cell_width * number.size()) / 2;
        draw_text(image, middle - half, top + bar + padding / 2, number, scale, light);
    }
}

}  // namespace glint
