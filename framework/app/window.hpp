// The live window.
#pragma once

#include "framework/app/lesson.hpp"

namespace glint {

// Shows the lesson's picture until the user closes it or options.frames are drawn; returns main()'s
// exit code. Error where this build has no SDL2 or there is no display.
int run_window(const Lesson& lesson, const Options& options);

}  // namespace glint
