// Where the eye is and what it sees.
#pragma once

#include "framework/geometry/mesh.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace glint {

// As glm::lookAt and glm::perspective: right-handed, the eye looks along its -z, vertical field of
// view. near and far are distances along the view direction.
struct Camera {
    glm::vec3 eye{0, 0, 3};
    glm::vec3 target{0, 0, 0};
    glm::vec3 up{0, 1, 0};
    float fov_degrees = 45.0F;  // 0 < fov < 180
    float near = 0.1F;          // 0 < near < far
    float far = 100.0F;
};

// World space to clip space with reversed depth: z/w is 1 at near and 0 at far, where float32 has
// its finest steps for what is far (Lapidous and Jiao 1999). aspect is width over height.
// Error where eye is target, up is along the view, or a number is out of its range.
glm::mat4 clip_from_world(const Camera& camera, float aspect);

// Moves the eye back along its direction until the sphere about the mesh's bounds fills the window,
// and sets near and far about that sphere. Error where the mesh has no extent.
Camera frame(const Mesh& mesh, Camera camera, float aspect);

// Sets near and far about the sphere round the mesh's bounds, as seen from where the eye is. Error
// where that is so far away that no number lies between them.
Camera around(const Mesh& mesh, Camera camera);

}  // namespace glint
