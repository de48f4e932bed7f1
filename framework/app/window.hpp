// The live window.
#pragma once

#include "framework/app/lesson.hpp"

namespace glint {

// Shows the scene until the user closes it; returns main()'s exit code. Error where this build has
// no SDL2 or there is no display.
int run_window(const Lesson& lesson, const Options& options, const Scene& scene);

}  // namespace glint
