// Curves as meshes: strips of triangles in the plane of the picture, whose u is the value shown.
#pragma once

#include "lessons/06_energy/furnace.hpp"
#include "framework/scene/scene.hpp"

namespace glint::plot {

// In pixels of a panel of 480 x 540, from its lower left corner: theta = 0..90 degrees to the
// right, albedo 0..3.3 upwards.
inline glm::vec2 place(double degrees, double albedo) {
    return {30 + degrees * (430.0 / 90), 30 + albedo * (490.0 / 3.3)};
}

// A line of so many pixels' width; material 0 is drawn by value, material 1 in grey.
inline void add_line(Mesh& mesh, const std::vector<glm::vec2>& points,
                     const std::vector<float>& values, float width, std::uint16_t material) {
    const auto last = points.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
        const glm::vec2 along = normalize(points[i < last ? i + 1 : i] - points[i > 0 ? i - 1 : i]);
        const glm::vec2 across = 0.5F * width * glm::vec2(-along.y, along.x);
        const auto at = static_cast<std::uint32_t>(mesh.positions.size());
        for (const float side : {1.0F, -1.0F}) {
            mesh.positions.emplace_back(points[i] + side * across, material == 0 ? 0.5F : 0.0F);
            mesh.uvs.emplace_back(values[i], 0.0F);
        }
        if (i < last) {
            mesh.triangles.emplace_back(at, at + 1, at + 3);
            mesh.triangles.emplace_back(at, at + 3, at + 2);
            mesh.materials.insert(mesh.materials.end(), 2, material);
        }
    }
}

// Lines at 0, 30, 60 and 90 degrees and at albedo 0, 1, 2 and 3; the one at 1 is the limit.
inline void add_axes(Mesh& mesh) {
    for (const double degrees : {0.0, 30.0, 60.0, 90.0}) {
        add_line(mesh, {place(degrees, 0), place(degrees, 3.3)}, {0.2F, 0.2F}, 1, 1);
    }
    for (const double albedo : {0.0, 1.0, 2.0, 3.0}) {
        const float grey = albedo == 1 ? 1.0F : 0.2F;
        add_line(mesh, {place(0, albedo), place(90, albedo)}, {grey, grey}, 1, 1);
    }
}

struct Plot {
    bool grey;

    template <class T>
    struct Varyings {
        T value;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.uv.x}; }
    template <Real T, class Noting = Silent>
    Rgb<T> operator()(const Varyings<T>& in, const Noting& note = {}) const {
        note("value", in.value);
        return grey ? Rgb<T>(in.value) : colour_of_share(in.value, 40);
    }
};

}  // namespace glint::plot
