// Ready-made scenes that the lessons are shown on, of Glint's own shapes.
#pragma once

#include "framework/scene/scene.hpp"

namespace glint::stages {

// A sphere, the teapot and a torus knot on a round table, each of its own material, seen at a
// height that leaves the table at a grazing angle. A key light and a fill light, some ambient.
Scene still_life();

// The same things on the same table, closer together: for panels about as high as wide.
Scene still_life_upright();

// Two light set-ups for them: their own, and one with two lamps more, each as strong as the key
// light, which burns out what was tweaked for the first.
Lighting key_and_fill();
Lighting three_lamps();

// Unit spheres in columns and rows, row by row from the top left, each of its own material, before
// a dark ground; the camera frames them for a window of that aspect. One key light from the upper
// left. Error where there are no materials or columns is below 1.
Scene sphere_grid(const std::vector<Material>& materials, int columns, float aspect);

}  // namespace glint::stages
