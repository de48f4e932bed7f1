// The scenes that the bench draws: each strains another part of the rasterizer.
#pragma once

#include "framework/scene/scene.hpp"

#include <string>
#include <vector>

namespace glint {

struct BenchScene {
    std::string name;
    std::string what;  // it is, in a few words
    Scene scene;
    int width = 1920, height = 1080;
};

std::vector<std::string> bench_scene_names();

// The scene of that name, Error where there is none. bunny_file: an OBJ file to draw as "bunny";
// empty for a shape of about as many triangles, of our own.
BenchScene bench_scene(const std::string& name, const std::string& bunny_file = {});

// A UV sphere of radius 1 seen from eye, with lights around it: what most scenes are made of.
Scene bench_sphere(int segments, int rings, const glm::vec3& eye, int lights);

// count directions over the half of the sphere that the eye sees, evenly spread, each with its
// share of the irradiance.
Lighting bench_lights(int count);

}  // namespace glint
