// Maps of a model's failures over the light's angle and the exponent, measured by the
// gonioreflectometer at the corners of a mesh: the map is drawn as any mesh is.
#pragma once

#include "lessons/14_combined/instruments.hpp"
#include "framework/scene/scene.hpp"

#include <glm/trigonometric.hpp>

namespace glint::failure_map {

// From left to right theta = 0..90 degrees, from bottom to top n = 0.1..1000, a decade a quarter.
inline constexpr int columns = 30, rows = 12;
inline double angle(int column) {
    return std::min(glm::radians(90.0 * column / columns), 0.5 * std::numbers::pi - 1e-6);
}
inline double exponent(int row) {
    return std::pow(10.0, 4.0 * row / rows - 1);
}

// The largest reciprocity error, as a share of the BRDF, where the lobe is at least half its peak.
// That is a cone about the mirror direction; the worst is in the plane of incidence.
template <class Brdf>
double worst_reciprocity_error(const Brdf& brdf, double theta, double n) {
    const double cone = std::acos(std::exp2(-1 / n));
    double worst = 0;
    for (int i = -32; i <= 32; ++i) {
        const double theta_V = std::min(theta + cone * i / 32, 0.5 * std::numbers::pi - 1e-6);
        const auto g = incidence_of_angles(theta, theta_V, std::numbers::pi);
        worst = std::max(worst, relative_reciprocity_error(brdf, g));
    }
    return worst;
}

// A rectangle in pixels from the lower left corner of a panel of 480 x 540.
struct Rectangle {
    float left, bottom, right, top;
};

// Adds a grid of columns x rows cells; quantity(column, row) of a corner becomes its u.
template <class Quantity>
void add_map(Mesh& mesh, const Rectangle& at, Quantity quantity) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            const float x = static_cast<float>(column) / columns;
            const float y = static_cast<float>(row) / rows;
            mesh.positions.emplace_back(at.left + x * (at.right - at.left),
                                        at.bottom + y * (at.top - at.bottom), 0.0F);
            mesh.uvs.emplace_back(static_cast<float>(quantity(column, row)), 0.0F);
        }
    }
    for (std::uint32_t i = 0; i < rows * (columns + 1); ++i) {
        if (i % (columns + 1) != columns) {
            const std::uint32_t a = first + i;
            const std::uint32_t b = a + columns + 1;
            mesh.triangles.emplace_back(a, a + 1, b + 1);
            mesh.triangles.emplace_back(a, b + 1, b);
        }
    }
}

// Lines at 30 and 60 degrees and at n = 1, 10 and 100, by triangles of material 1.
inline void add_lines(Mesh& mesh, const Rectangle& at) {
    mesh.materials.resize(mesh.triangles.size(), 0);
    const auto bar = [&](const Rectangle& r) {
        const auto a = static_cast<std::uint32_t>(mesh.positions.size());
        for (const glm::vec2 corner : {glm::vec2(r.left, r.bottom), glm::vec2(r.right, r.bottom),
                                       glm::vec2(r.right, r.top), glm::vec2(r.left, r.top)}) {
            mesh.positions.emplace_back(corner, 1.0F);
            mesh.uvs.emplace_back(0.0F);
        }
        mesh.triangles.emplace_back(a, a + 1, a + 2);
        mesh.triangles.emplace_back(a, a + 2, a + 3);
    };
    for (int i = 1; i < 3; ++i) {
        const float x = std::round(at.left + static_cast<float>(i) * (at.right - at.left) / 3);
        bar({x, at.bottom, x + 1, at.top});
    }
    for (int i = 1; i < 4; ++i) {
        const float y = std::round(at.bottom + static_cast<float>(i) * (at.top - at.bottom) / 4);
        bar({at.left, y, at.right, y + 1});
    }
    mesh.materials.resize(mesh.triangles.size(), 1);
}

// The map's colour: shares above 1 pale as they grow, to white at 1.5.
struct Plot {
    bool line;

    template <class T>
    struct Varyings {
        T share;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.uv.x}; }
    template <Real T, class Noting = Silent>
    Rgb<T> operator()(const Varyings<T>& in, const Noting& note = {}) const {
        const T pale = clamp((in.share - T(1.0F)) * 2.0F, T(0.0F), T(1.0F));
        note("share", in.share);
        return line ? Rgb<T>(T(0.02F))
                    : mix(colour_of_share(in.share, 80), Rgb<T>(T(1.0F)), Rgb<T>(pale));
    }
};

}  // namespace glint::failure_map
