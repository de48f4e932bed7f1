// Perspective-correct interpolation at one point, from exact edge values.
#pragma once

#include "framework/raster/eye_rays.hpp"
#include "framework/raster/setup.hpp"
#include "framework/raster/shader.hpp"

#include <array>

namespace glint {

// The varyings at the three corners of a triangle.
using CornerVaryings = std::array<std::array<float, max_varyings>, 3>;

inline CornerVaryings corner_varyings(const Shader& shader, const Mesh& mesh,
                                      const ScreenTriangle& triangle) {
    std::array<float, 3 * max_varyings> of_mesh{};
    const glm::uvec3 vertices = mesh.triangles[triangle.source];
    shader.vertex(shader.shader, mesh, &vertices.x, 3, 3, of_mesh.data());
    CornerVaryings corners{};
    const auto count = static_cast<std::size_t>(shader.varyings);
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 b = triangle.barycentric[i];
        for (std::size_t k = 0; k < count; ++k) {
            const float* of_corner = &of_mesh[3 * k];
            const double mixed = b.x * double{of_corner[0]} + b.y * double{of_corner[1]} +
                                 b.z * double{of_corner[2]};
            corners[i][k] = triangle.clipped ? static_cast<float>(mixed) : of_corner[i];
        }
    }
    return corners;
}

// Barycentric coordinates of a window position (1/256 pixel) with respect to the corners: on the
// screen, and on the triangle in space, where each is weighted by its corner's 1/w.
template <class T>
struct Barycentrics {
    std::array<T, 3> screen;
    std::array<T, 3> space;
};

template <class T>
Barycentrics<T> barycentrics(const ScreenTriangle& triangle, const Edges& edges, std::int64_t x,
                             std::int64_t y) {
    Barycentrics<T> b{};
    const auto area = static_cast<T>(std::abs(edges.double_area));
    T sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Edge& e = edges.edge[i];
        b.screen[i] = static_cast<T>(e.at(x, y) + (e.inclusive ? 0 : 1)) / area;
        b.space[i] = b.screen[i] * static_cast<T>(triangle.v[i].inverse_w);
        sum += b.space[i];
    }
    for (T& weight : b.space) {
        weight /= sum;
    }
    return b;
}

// What a shader is called with at a window position (1/256 pixel): the varyings, relative to corner
// 0, for what small triangles vary little in is then rounded little; and the way to the eye, where
// it asks for that. T is float or double.
template <class T>
std::array<T, max_varyings> interpolate(const Shader& shader, const CornerVaryings& corners,
                                        const std::array<T, 3>& weight, const EyeRays& rays,
                                        std::int64_t x, std::int64_t y) {
    std::array<T, max_varyings> out{};
    const auto count = static_cast<std::size_t>(shader.varyings);
    for (std::size_t k = 0; k < count; ++k) {
        const auto first = static_cast<T>(corners[0][k]);
        out[k] = first + (weight[1] * (static_cast<T>(corners[1][k]) - first) +
                          weight[2] * (static_cast<T>(corners[2][k]) - first));
    }
    if (shader.to_eye) {
        const double pixel = 1.0 / subpixel_one;
        const glm::dvec3 to_eye =
            rays.at(static_cast<double>(x) * pixel, static_cast<double>(y) * pixel);
        for (int i = 0; i < 3; ++i) {
            out[count + static_cast<std::size_t>(i)] = static_cast<T>(to_eye[i]);
        }
    }
    return out;
}

}  // namespace glint
