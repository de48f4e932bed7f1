// Meshes that hurt a rasterizer, in a picture of 24 x 40 pixels: neighbours share each edge, so no
// pixel inside may be missed or drawn twice.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace glint::grids {

inline constexpr int width = 24;
inline constexpr int height = 40;

struct Grid {
    std::string name;
    std::vector<std::array<glm::vec2, 3>> triangles;  // in pixels
};

// Thin triangles that meet in a point.
inline Grid fan() {
    constexpr int blades = 28;
    const glm::vec2 centre(11.7F, 11.4F);
    const auto rim = [&](int i) {
        const double turn = 2 * std::numbers::pi * (i + 0.3) / blades;
        return centre + 10.6F * glm::vec2(std::cos(turn), std::sin(turn));
    };
    Grid grid{"fan", {}};
    for (int i = 0; i < blades; ++i) {
        grid.triangles.push_back({centre, rim(i), rim(i + 1)});
    }
    return grid;
}

// Cells of 13/12 x 7/5 pixels that lean over so far that most triangles are thinner than a pixel.
inline Grid sheared() {
    constexpr int columns = 12;
    constexpr int rows = 10;
    const auto point = [](int column, int row) {
        const auto x = static_cast<float>(column) * 13 / 12;
        const auto y = static_cast<float>(row) * 7 / 5;
        return glm::vec2(1.3F + x + 0.66F * y, 24.6F + y - 0.11F * x);
    };
    Grid grid{"sheared", {}};
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const glm::vec2 a = point(column, row);
            const glm::vec2 b = point(column + 1, row);
            const glm::vec2 c = point(column, row + 1);
            const glm::vec2 d = point(column + 1, row + 1);
            grid.triangles.push_back({a, c, b});
            grid.triangles.push_back({b, c, d});
        }
    }
    return grid;
}

inline std::vector<Grid> all() {
    return {fan(), sheared()};
}

}  // namespace glint::grids
