// A triangle mesh in world space, the materials that its triangles name, and what can be done to
// any mesh. The world is right-handed with y up.
#pragma once

#include "framework/math/memory.hpp"
#include "framework/math/vec.hpp"

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace glint {

// What a surface is made of. Which of these a lesson uses is the lesson's matter.
struct Material {
    std::string name{};
    Rgb<float> diffuse{0.8F};    // MTL Kd: diffuse albedo Cd, 0..1
    Rgb<float> specular{0.04F};  // MTL Ks: reflectance at normal incidence F0, 0..1
    float exponent = 50.0F;      // MTL Ns: Phong exponent n, >= 0
    float ior = 1.5F;            // MTL Ni: refractive index relative to air, > 0
    std::string diffuse_map{};   // MTL map_Kd: path of a picture; no lesson draws it
};

// Counter-clockwise triangles face the viewer. normals and uvs are as long as positions, or empty;
// materials is as long as triangles, or empty (all of material 0).
struct Mesh {
    LineVector<glm::vec3> positions;
    LineVector<glm::vec3> normals;  // unit length
    LineVector<glm::vec2> uvs;
    LineVector<glm::uvec3> triangles;
    std::vector<std::uint16_t> materials;
};

// The mesh moved by an affine matrix: normals by the inverse transpose, made unit length again;
// a matrix that mirrors also turns the triangles round, so that outside stays outside.
// A matrix that is not affine or not invertible is an Error.
Mesh transform(Mesh mesh, const glm::mat4& matrix);

// Adds a copy of other to mesh, all of it of the given material. Missing uvs become (0, 0); that
// only one of them has normals is an Error, as are more than 2^32 - 1 vertices.
void append(Mesh& mesh, const Mesh& other, std::uint16_t material = 0);

// The smallest box along the axes that holds all vertices.
struct Bounds {
    glm::vec3 low, high;
};

// A mesh without vertices is an Error.
Bounds bounds(const Mesh& mesh);

}  // namespace glint
