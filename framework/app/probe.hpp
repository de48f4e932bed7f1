// Everything about one pixel.
#pragma once

#include "framework/app/lesson.hpp"

#include <string>

namespace glint {

// The triangle that wins the pixel's centre, its edge values, barycentrics and depth, its varyings,
// and every term of its shading that the shader names, in double beside float.
std::string explain_pixel(const Lesson& lesson, const Options& options, const Scene& scene);

}  // namespace glint
