// Pictures of several panels side by side: the same lesson with parameters that differ.
#pragma once

#include "framework/app/picture.hpp"

#include <vector>

namespace glint {

// A part of the picture, drawn with these options.
struct PanelOptions {
    Options options;
    int left;  // where it begins in the picture
};

// The lesson's panels, from left to right; one that fills the picture where the lesson has none, or
// where the command line sets a parameter that the panels differ in, or --tolerance chooses it.
std::vector<PanelOptions> panels_of(const Lesson& lesson, const Options& options);

// Puts the drawing of a panel that begins at left into the whole, options.width x options.height, a
// dark line before it; its statistics are added. An empty whole is made first.
void add_panel(const Drawing& part, int left, const Options& options, Drawing& whole);

// Draws every panel and puts them together.
Drawing draw_panels(const Lesson& lesson, const Options& options);

}  // namespace glint
