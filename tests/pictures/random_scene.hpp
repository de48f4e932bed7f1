// Scenes made to hurt: triangles of all sizes and shapes, through each other, the eye and the near
// plane, some of them twice.
#pragma once

#include "framework/scene/camera.hpp"

#include <cstdint>

namespace glint {

struct RandomScene {
    Mesh mesh;  // of one material; with normals and uvs
    Camera camera;
};

// The same seed makes the same scene.
RandomScene random_scene(std::uint64_t seed);

}  // namespace glint
