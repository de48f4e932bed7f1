// All that a picture shows.
#pragma once

#include "framework/scene/camera.hpp"
#include "framework/scene/light.hpp"
#include "framework/geometry/mesh.hpp"

#include <vector>

namespace glint {

struct Scene {
    Mesh mesh;
    std::vector<Material> materials{Material{}};  // mesh.materials are places in here
    Lighting lighting;
    Camera camera;
    Rgb<float> background{0.0F};
};

}  // namespace glint
