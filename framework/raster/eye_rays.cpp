#include "framework/raster/eye_rays.hpp"

#include <glm/matrix.hpp>

namespace glint {

// A point whose clip coordinates are w (x, y, z, 1) is w (A + z B) in homogeneous world space, with
// A = M^-1 (x, y, 0, 1) and B = M^-1 (0, 0, 1, 0), which is the eye. The last of the four says
// w (A.w + z B.w) = 1, so z drops out of the way from the point to the eye:
//     B.xyz / B.w - w (A + z B).xyz = w (A.w B.xyz / B.w - A.xyz)
// If B.w = 0 the eye is infinitely far, where z grows: B.xyz. A is linear in x and y.
EyeRays eye_rays(const View& view) {
    const glm::dmat4 world_from_clip = glm::inverse(glm::dmat4(view.clip_from_world));
    const glm::dvec4 eye = world_from_clip[2];
    const auto towards_eye = [&](const glm::dvec4& a) {
        return eye.w == 0.0 ? glm::dvec3(eye) * a.w
                            : glm::dvec3(eye) * (a.w / eye.w) - glm::dvec3(a);
    };
    const glm::dvec3 middle = towards_eye(world_from_clip[3]);
    const double scale = 1 / glm::length(middle);
    const glm::dvec3 x = towards_eye(world_from_clip[0]) * scale;
    const glm::dvec3 y = towards_eye(world_from_clip[1]) * scale;
    return {middle * scale - x + y, x * (2.0 / view.width), y * (-2.0 / view.height)};
}

}  // namespace glint
