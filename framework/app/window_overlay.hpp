// What the live window lays over its picture.
#pragma once

#include "framework/app/window_words.hpp"
#include "framework/image/image.hpp"

namespace glint {

// A dark box of lines, as large as they need.
struct WordsPanel {
    Lines lines;
    float scale;  // of the letters
    int width() const;
    int height() const;
    void draw(SrgbImage& image, int x, int y) const;
};

// The scale at which words in a picture of that height are read with ease.
float words_scale(int height);

// A panel that fits into a height: with smaller letters if it must, or with its last lines left
// out.
WordsPanel fitting_panel(Lines lines, float scale, int height);

// A cross that leaves the pixel itself free.
void draw_mark(SrgbImage& image, int x, int y);

// What the heat colours of code_difference mean, in the lower right corner.
void draw_difference_legend(SrgbImage& image, float scale);

}  // namespace glint
