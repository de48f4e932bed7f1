// Words in a picture, in the manner of a terminal: every letter has a cell of one size.
#pragma once

#include "framework/image/image.hpp"

#include <string_view>

namespace glint {

// A cell in pixels at a scale of 1.
inline constexpr int cell_width = 6;
inline constexpr int cell_height = 11;

// A line of ASCII text, its first cell's top left corner at x, y; other bytes are drawn as '?'.
// What lies outside the picture is left out.
void draw_text(SrgbImage& image, int x, int y, std::string_view text, float scale, Rgba8 colour);

// Lays a colour of which alpha / 255 is opaque over a rectangle. Mixes code values, not light: so
// do other programs, and panels look alike.
void shade_rectangle(SrgbImage& image, int x, int y, int width, int height, Rgba8 colour);

}  // namespace glint
