// Ready-made scenes that the lessons are shown on, of Glint's own shapes.
#pragma once

#include "framework/scene/scene.hpp"

namespace glint::stages {

// A sphere, the teapot and a torus knot on a round table, each of its own material, seen at a
// height that leaves the table at a grazing angle. A key light and a fill light, some ambient.
Scene still_life();

}  // namespace glint::stages
