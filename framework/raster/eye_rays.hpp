// The direction from a pixel's fragments towards the eye. It follows from the view alone, whatever
// the triangle, so it need not be interpolated.
#pragma once

#include "framework/raster/pipeline.hpp"

namespace glint {

// At x, y in pixels from the window's top-left corner: corner + right x + down y, in world space;
// about of unit length in the middle of the window. The eye may be infinitely far. NaN or infinite
// where the view's matrix has no inverse.
struct EyeRays {
    glm::dvec3 corner, right, down;

    glm::dvec3 at(double x, double y) const { return corner + right * x + down * y; }
};

EyeRays eye_rays(const View& view);

}  // namespace glint
