// Random worlds for the property run: scenes made to hurt, under lights and of materials that hurt.
#pragma once

#include "framework/scene/camera.hpp"
#include "framework/scene/light.hpp"
#include "framework/raster/pipeline.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace glint::stability {

struct Surface {
    Rgb<float> Cd, F0;
    float n;
};

enum class Model { side_by_side, engine, by_angle, consistent };

struct World {
    std::uint64_t seed = 0;
    Mesh mesh{};  // materials are places in surfaces
    Camera camera{};
    Lighting lighting{};
    std::vector<Surface> surfaces{};
    Model model = Model::engine;
    int width = 0, height = 0;
    Settings settings{};  // of samples and culling
};

// The same seed makes the same world with every compiler; from one triangle to some hundreds.
World random_world(std::uint64_t seed);

// How much there is to look through when it fails: triangles and lights, then pixels.
double size_of(const World& world);
std::string words(const World& world);  // one line

}  // namespace glint::stability
