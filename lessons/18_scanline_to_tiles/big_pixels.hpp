// A picture of few pixels, each as big as a hand: their squares, and outlines over them.
#pragma once

#include "framework/scene/scene.hpp"
#include "framework/raster/shader.hpp"

#include <glm/geometric.hpp>

#include <array>

namespace glint::big_pixels {

inline void add_quad(Mesh& mesh, const std::array<glm::vec2, 4>& corners, float z,
                     std::size_t material) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::vec2& c : corners) {
        mesh.positions.emplace_back(c, z);
    }
    mesh.triangles.emplace_back(first, first + 1, first + 2);
    mesh.triangles.emplace_back(first, first + 2, first + 3);
    mesh.materials.resize(mesh.triangles.size(), static_cast<std::uint16_t>(material));
}

// A square of this size about a middle.
inline void add_square(Mesh& mesh, const glm::vec2& middle, float size, float z,
                       std::size_t material) {
    const float half = 0.5F * size;
    const auto at = [&](float x, float y) { return middle + half * glm::vec2(x, y); };
    add_quad(mesh, {at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)}, z, material);
}

inline void add_line(Mesh& mesh, const glm::vec2& from, const glm::vec2& to, float breadth, float z,
                     std::size_t material) {
    const glm::vec2 along = 0.5F * breadth * normalize(to - from);
    const glm::vec2 across(-along.y, along.x);
    add_quad(mesh, {from - across, to - across, to + across, from + across}, z, material);
}

// One radiance.
struct Flat {
    Rgb<float> radiance;

    template <class T>
    struct Varyings {
        T unused;
    };
    static Varyings<float> vertex(const Vertex&) { return {0.0F}; }
    template <Real T>
    Rgb<T> operator()(const Varyings<T>&) const {
        return Rgb<T>(radiance);
    }
};

}  // namespace glint::big_pixels
