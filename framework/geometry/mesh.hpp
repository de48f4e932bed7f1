// A triangle mesh in world space, and the materials that its triangles name.
#pragma once

#include "framework/math/vec.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace glint {

// What a surface is made of. Which of these a lesson uses is the lesson's matter.
struct Material {
    std::string name;
    Rgb<float> diffuse{0.8F};    // MTL Kd: diffuse albedo Cd, 0..1
    Rgb<float> specular{0.04F};  // MTL Ks: reflectance at normal incidence F0, 0..1
    float exponent = 50.0F;      // MTL Ns: Phong exponent n, >= 0
    float ior = 1.5F;            // MTL Ni: refractive index relative to air, > 0
    std::string diffuse_map;     // MTL map_Kd: path of a picture, empty for none
};

// Counter-clockwise triangles face the viewer. normals and uvs are as long as positions, or empty;
// materials is as long as triangles, or empty (all of material 0).
struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;  // unit length
    std::vector<glm::vec2> uvs;
    std::vector<glm::uvec3> triangles;
    std::vector<std::uint16_t> materials;
};

}  // namespace glint
